#include <taut/io/results/arc_proof.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <taut/geometry/errors.h>
#include <taut/geometry/exact/numbers.h>
#include <taut/geometry/free_space.h>
#include <taut/geometry/number_lattice.h>
#include <taut/geometry/plain_world.h>
#include <taut/geometry/text.h>
#include <taut/geometry/walled_world.h>
#include <taut/io/results/path_certificate_text.h>
#include <taut/io/worlds/write_world.h>
#include <taut/search/disc_worlds.h>

namespace taut {

namespace {

using nlohmann::json;
using Places = std::vector<std::array<std::int64_t, 2>>;

constexpr double kEnough = 1 - 1e-6;  // of the radius: what a path keeps that serves the disc but for rounding

Rational per_one(const World& world) {
  const auto lattice = number_lattice(world);
  if (!lattice) throw InputError(world.source(), 0, "its coordinates are no multiples of one unit");
  return Rational(power(static_cast<unsigned>(lattice->base), static_cast<unsigned>(lattice->exponent)));
}

bool is_radius(double r) { return r >= World::kSmallest && r <= World::kLargest; }

// Are both parts about one path? Of the second the unit may be finer.
bool is_one_path(const ArcClaim& claim, const ArcTexts& texts) {
  const json bound = json::parse(claim.bound), keeps = json::parse(claim.keeps);
  const auto scale = keeps.at("scale").get<std::int64_t>(), coarse = bound.at("scale").get<std::int64_t>();
  if (coarse > INT64_MAX / texts.finer || scale % (coarse * texts.finer) != 0) return false;
  const auto finer = scale / (coarse * texts.finer);
  const auto path = bound.at("path").get<Places>(), fine = keeps.at("path").get<Places>();
  const auto is_same = [finer](const auto& p, const auto& q) {
    return q[0] % finer == 0 && q[0] / finer == p[0] && q[1] % finer == 0 && q[1] / finer == p[1];
  };
  return std::equal(path.begin(), path.end(), fine.begin(), fine.end(), is_same) && bound.at("kind") == "shortest" &&
         keeps.at("kind") == "widest";
}

}  // namespace

std::string certificate_text(const ArcCertificate& certificate, const ArcTexts& texts) {
  std::string out = "{\n\"format\": \"taut certificate 1\",\n\"kind\": \"arcs\",\n\"radius\": ";
  append(out, certificate.radius);
  const std::array ends{certificate.start, certificate.goal};
  out += ",\n\"ends\": [[";
  append(out, ends[0].x);
  append(out += ", ", ends[0].y);
  append(out += "], [", ends[1].x);
  append(out += ", ", ends[1].y);
  out += "]],\n\"bound\": " + certificate_text(certificate.bound, texts.inner);
  out += ",\n\"keeps\": " + certificate_text(certificate.keeps, texts.bare, ends);
  return out + "}\n";
}

std::optional<ArcClaim> arc_claim(std::string_view certificate, const std::string& source) {
  const json all = json::parse(certificate, nullptr, false);
  if (!all.is_object() || !all.contains("kind") || all["kind"] != "arcs") return std::nullopt;
  try {
    const auto ends = all.at("ends").get<std::array<std::array<double, 2>, 2>>();
    ArcClaim claim{all.at("radius").get<double>(), {}, all.at("bound").dump(), all.at("keeps").dump()};
    claim.ends = {Point{ends[0][0], ends[0][1]}, Point{ends[1][0], ends[1][1]}};
    if (is_radius(claim.radius)) return claim;
  } catch (const json::exception&) {
  }
  throw InputError(source, 0, "a certificate of arcs has a radius, two ends and two parts, `bound` and `keeps`");
}

ArcTexts arc_texts(const World& world, double radius, const std::array<Point, 2>& ends) {
  const World ground = disc_ground(world, ends[0], ends[1]);
  const auto inner = inner_world(ground, radius);
  if (!inner)
    throw InputError(world.source(), 0, "the disc's radius is too small for the world's numbers, or too large");
  const World bare = bare_world(ground, radius);
  const Rational finer = per_one(*inner) / per_one(bare);
  if (denominator(finer) != 1 || finer > Rational(0x1p50))
    throw InputError(world.source(), 0, "the world's numbers are too fine for the disc's radius");
  ArcTexts texts{write_plain_integers(*inner), write_plain_integers(bare), to_int64(numerator(finer)), 0};
  if (!is_plain(world)) texts.displacement = FreeSpace(walled_world(world, {ends[0], ends[1]})).report().displacement;
  return texts;
}

ArcJudgement judge_arcs(const ArcClaim& claim, const ArcTexts& texts,
                        const std::function<ArcJudgement(const std::string&, const std::string&)>& judge) {
  const ArcJudgement bound = judge(texts.inner, claim.bound);
  if (!bound.proven) return {false, "no path is shorter: " + bound.words, 0, 0, 0};
  const ArcJudgement keeps = judge(texts.bare, claim.keeps);
  if (!keeps.proven) return {false, "the path keeps away: " + keeps.words, 0, 0, 0};
  if (!is_one_path(claim, texts)) return {false, "its two parts are about different paths", 0, 0, 0};
  if (!(keeps.length >= claim.radius * kEnough))
    return {false, fmt::format("the path keeps only {:.12g}", keeps.length), 0, 0, 0};
  // Rounded to the safe side.
  return {
      true,
      fmt::format("no path of a disc of radius {:.12g} is shorter than {:.9f}; one that keeps {:.12g} is {:.9f} long",
                  claim.radius, bound.bound - 1e-9, keeps.length, bound.length + 1e-9),
      bound.length, bound.bound, keeps.length};
}

}  // namespace taut
