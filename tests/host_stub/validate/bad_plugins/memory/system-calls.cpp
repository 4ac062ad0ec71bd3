// Lets others compute for a moment.
#include <chrono>
#include <thread>
#define IN_EVALUATE std::this_thread::sleep_for(std::chrono::nanoseconds(1))
#include "../good_cpp.h"
