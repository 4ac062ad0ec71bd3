#pragma once
#include "brushes.h"

namespace burin_probe {

/// Checks that a brush is alive: its own record, or null.
Brush* check_alive(const burin_brush* brush);

/// Checks that the calling thread is the one on which the host loaded the module.
void check_main_thread();

/// Fills the functions of a brush.
void fill(Brush& brush);

}  // namespace burin_probe
