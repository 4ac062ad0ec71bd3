#pragma once
#include <functional>

#include "fuzz/fuzz_case.h"

namespace burin {

/// Makes a case that fails smaller as long as it fails: fewer settings and parameters, rounder numbers, fewer
/// samples, a coarser and flatter surface. This is delta debugging [Zeller and Hildebrandt, "Simplifying and
/// Isolating Failure-Inducing Input", IEEE TSE 28, 2002] part by part, until no part gets smaller or after
/// `tries` calls of `fails`.
FuzzCase shrunk(FuzzCase failing, const std::function<bool(const FuzzCase&)>& fails, int tries);

}  // namespace burin
