/* org.burin.test.reloaded in three versions, REVISION. The first makes a ridge that is as high as its state
 * says, which counts strokes. The second makes it twice as high and has no parameter `count` any more; the
 * third does not take the states of others. */
#define ID "org.burin.test.reloaded"
#define IN_END ++((good_brush*)brush->self)->state
#define AT_NODE \
  AT(outputs->up, i) *= (float)(REVISION == 1 ? 1 : 2) * (float)((good_brush*)brush->self)->state / 7
#if REVISION == 2
#define COUNT .id = "amount"
#elif REVISION == 3
#define IN_LOAD                               \
  {                                           \
    (void)self;                               \
    say(error, "written by another version"); \
    return BURIN_UNSUPPORTED;                 \
  }
#endif
#include "../../host_stub/validate/bad_plugins/good.h"
