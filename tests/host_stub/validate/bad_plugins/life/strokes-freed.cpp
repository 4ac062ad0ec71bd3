// Makes a table for every stroke and forgets it.
#define IN_BEGIN table_ = new float[50]()
#define MEMBERS float* table_
#define AT_NODE up[i] += table_[3]
#include "../good_cpp.h"
