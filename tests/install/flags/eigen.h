#pragma once
#include <burin/base/vector.h>

static_assert(EIGEN_FAST_MATH == 0, "the package must tell applications how Burin's headers are compiled");
