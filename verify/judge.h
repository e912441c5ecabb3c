// The judge of certificates. It shares nothing with what wrote them, and includes nothing of the other folders.
// docs/certificates.md has the format and why it proves what it says.
#pragma once

#include <string>

#include <taut/verify/world.h>

namespace taut::proof {

struct Judgement {
  bool proven = false;
  std::string kind;   ///< of the certificate: `shortest`, `none`, `widest`
  std::string words;  ///< `no path is shorter than 97.6 - 9e-11; yours is 97.6 long`; or the leg that refutes it
  /// In the world's own unit. Of `shortest`: how long the path given is; no path is below the bound. Of `widest`: how
  /// far it keeps from walls; no disc above the bound gets through. Of `none` by a chain the bound is the disc's
  /// radius.
  Real length = 0, bound = 0;
};

/// `world` is the text that `taut convert --as integers` writes, `certificate` what `taut solve --certificate` does.
/// Throws BadInput where one of them cannot be read; what is read and wrong is not proven.
Judgement judge(const std::string& world, const std::string& certificate);

}  // namespace taut::proof
