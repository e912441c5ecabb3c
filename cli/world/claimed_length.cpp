#include <taut/cli/world/claimed_length.h>

#include <fmt/format.h>

#include <taut/io/results/words.h>

namespace taut::cli {

std::string false_claim(const ClaimedPath& claimed, const Length& legs) {
  if (!claimed.length) return {};
  Interval measured = legs.interval();
  if (claimed.measured) measured = {*claimed.measured, *claimed.measured};
  const double rounded = static_cast<double>(claimed.points.size() + 2) * 0x1p-53;
  const double slack = (claimed.measured ? 1e-9 : rounded) * measured.hi;
  const bool may_be_longer = claimed.approximate && !claimed.measured;
  if (measured.lo - slack <= *claimed.length && (may_be_longer || *claimed.length <= measured.hi + slack)) return {};
  return fmt::format("it claims the length {}, but measures {}", *claimed.length,
                     number_text(claimed.measured ? *claimed.measured : legs.value()));
}

}  // namespace taut::cli
