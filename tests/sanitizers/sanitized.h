#pragma once

namespace burin::test {

/// Whether this program has the address or the thread sanitizer. These slow it down and take memory of their
/// own, so that its times and sizes tell nothing about Burin.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif

}  // namespace burin::test
