#include <taut/geometry/exact/signed_roots.h>

#include <taut/geometry/detail/root_sum.h>

namespace taut {

int sign_of_sum(const std::vector<SignedRoot>& terms) { return detail::sign_of_roots(terms); }

}  // namespace taut
