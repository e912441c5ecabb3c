// Certificates of paths as files, for `taut verify` and for any other judge.
#pragma once

#include <string>
#include <string_view>

#include <taut/search/path_certificate.h>

namespace taut {

/// One JSON object, docs/certificates.md; all numbers are integers. `world_text` is what write_integers() makes of the
/// world: the certificate holds its fingerprint.
std::string certificate_text(const PathCertificate& certificate, std::string_view world_text);

}  // namespace taut
