#pragma once

namespace burin {

/// From now on a crash in the code of a plugin writes "burin: brush ID crashed: SIGNAL" to stderr before the
/// process ends by the signal as it would have. Changes the process's signal handlers: for programs, not for
/// libraries.
void name_plugins_that_crash();

}  // namespace burin
