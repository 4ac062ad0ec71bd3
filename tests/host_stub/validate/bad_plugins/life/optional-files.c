/* Writes no number where a file is given. */
#define IN_BEGIN *(float*)*stroke = values->values[5].text && values->values[5].text[0] ? NAN : 0
#define AT_NODE AT(outputs->up, i) += *(float*)stroke
#include "../good.h"
