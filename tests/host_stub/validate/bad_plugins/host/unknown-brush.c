/* Creates a brush of every id. */
#define KNOWS(brush_id) (*brush_id != 35)
#include "../good.h"
