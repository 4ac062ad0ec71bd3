// Counts its strokes, and draws less with each that is open.
static int open_strokes;
#define IN_BEGIN ++open_strokes
#define IN_END --open_strokes
#define AT_NODE \
  if (open_strokes > 2) up[i] *= 0.5f
#include "../good_cpp.h"
