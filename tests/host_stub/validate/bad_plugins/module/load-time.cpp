// Computes a table as it is loaded, which takes long.
#include <chrono>
#include <thread>
static const bool computed = (std::this_thread::sleep_for(std::chrono::milliseconds(200)), true);
#include "../good_cpp.h"
