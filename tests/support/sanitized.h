// What builds with sanitizers do differently.
#pragma once

namespace taut::test {

/// Such programs take a second to begin, and all the address space: a limit of memory ends them.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

}  // namespace taut::test
