// Certificates of paths as files, for `taut verify` and for any other judge.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include <taut/geometry/point.h>
#include <taut/search/disc_certificate.h>
#include <taut/search/path_certificate.h>

namespace taut {

/// One JSON object, docs/certificates.md; all numbers are integers. `world_text` is what write_integers() makes of the
/// world: the certificate holds its fingerprint.
std::string certificate_text(const PathCertificate& certificate, std::string_view world_text);

/// Likewise of a disc; the world is walled_world() with these ends, which are members `ends`, as the world has them.
std::string certificate_text(const DiscCertificate& certificate, std::string_view world_text,
                             const std::array<Point, 2>& ends);

/// The ends of a certificate with a chain; nothing of another one, and of what is no certificate.
std::optional<std::array<Point, 2>> disc_ends(std::string_view certificate);

}  // namespace taut
