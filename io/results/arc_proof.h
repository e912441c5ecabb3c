// Certificates of discs' arcs as files, and what two judgements of their parts say together.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include <taut/geometry/point.h>
#include <taut/geometry/world.h>
#include <taut/search/arc_certificate.h>

namespace taut {

/// What a certificate of arcs is about, and its two parts, each a certificate by itself.
struct ArcClaim {
  double radius = 0;
  std::array<Point, 2> ends;
  std::string bound, keeps;
};

/// The texts of the two worlds that the parts are about.
struct ArcTexts {
  std::string inner, bare;
  std::int64_t finer = 0;   ///< so many of inner's units make one of bare's
  double displacement = 0;  ///< what rounding moved, where the world is not judged as it was written
};

/// One JSON object, docs/certificates.md. `texts` are those of its world, radius and ends.
std::string certificate_text(const ArcCertificate& certificate, const ArcTexts& texts);

/// Nothing of a certificate of another kind. Throws InputError, which names `source`, where it is of that kind and
/// cannot be read.
std::optional<ArcClaim> arc_claim(std::string_view certificate, const std::string& source = {});

/// Throws InputError where the world's numbers allow none.
ArcTexts arc_texts(const World& world, double radius, const std::array<Point, 2>& ends);

/// What a judge says.
struct ArcJudgement {
  bool proven = false;
  std::string words;
  double length = 0;  ///< of the path that is given
  double bound = 0;   ///< of the first part: no path is shorter
  double keeps = 0;   ///< how far the path is from all walls
};

/// `judge(world's text, certificate)` judges one part: it says length and bound, and of the second part what the path
/// keeps as its length. Both parts have to be about the same path.
ArcJudgement judge_arcs(const ArcClaim& claim, const ArcTexts& texts,
                        const std::function<ArcJudgement(const std::string&, const std::string&)>& judge);

}  // namespace taut
