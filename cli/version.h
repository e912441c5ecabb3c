// What this program is made of.
#pragma once

#include <string>

namespace taut::cli {

/// `taut 0.2.0`, then the compiler, the libraries with their versions and what was chosen when it was built, a line
/// each.
std::string version_text();

}  // namespace taut::cli
