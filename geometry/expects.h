// Documented preconditions, checked where the build asks for it (TAUT_CHECKS: presets dev, asan, tsan).
#pragma once

#include <stdexcept>
#include <string>

namespace taut {

/// The caller broke a documented precondition.
class PreconditionError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

}  // namespace taut

#ifdef TAUT_CHECKS
#define TAUT_EXPECTS(condition)       \
  ((condition) ? static_cast<void>(0) \
               : throw ::taut::PreconditionError(std::string(__func__) + ": precondition broken: " #condition))
#else
#define TAUT_EXPECTS(condition) static_cast<void>(0)
#endif
