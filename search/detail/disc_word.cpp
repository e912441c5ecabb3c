#include <taut/search/detail/disc_word.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <taut/search/detail/arc_ends.h>

namespace taut::detail {

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kTouching = 1e-7;  // of the leg: what may have come to touch it
constexpr std::size_t kMostTouching = 24;

}  // namespace

DiscWords::DiscWords(std::shared_ptr<const TangentGround> ground, Point s, Point g)
    : ground_(std::move(ground)), s_(end_site(ground_->walls, s)), g_(end_site(ground_->walls, g)) {}

/// 0: the start; then the stops; then the goal.
const TangentSite& DiscWords::at(const DiscWord& word, std::size_t i) const {
  if (i == 0) return s_;
  return i == word.size() + 1 ? g_ : ground_->sites[word[i - 1].site];
}

int DiscWords::side(const DiscWord& word, std::size_t i) {
  return i == 0 || i == word.size() + 1 ? 0 : word[i - 1].side;
}

bool DiscWords::leg_is_free(const DiscWord& word, std::size_t i, double r) const {
  const TangentSite &a = at(word, i), &b = at(word, i + 1);
  const bool from_start = i == 0, to_goal = i == word.size();
  if (from_start && to_goal) return ground_->walls.is_free(TangentLine({a.at, 0}, {b.at, 0}, r), a.sector, b.sector);
  if (from_start || to_goal) {
    const int wanted = from_start ? -side(word, 1) : side(word, i);
    return std::ranges::any_of(free_tangents(ground_->walls, r, from_start ? a : b, from_start ? b : a),
                               [&](const TangentPair& pair) { return pair.to.here.side == wanted; });
  }
  const WordStop &x = word[i - 1], &y = word[i];
  const TangentName name =
      x.site < y.site ? TangentName{x.site, y.site, x.side, y.side} : TangentName{y.site, x.site, -y.side, -x.side};
  return is_free_tangent(*ground_, name, r);
}

bool DiscWords::arc_is_free(const DiscWord& word, std::size_t i, double r, bool may_be_none) const {
  const TangentSite &before = at(word, i), &here = at(word, i + 1), &after = at(word, i + 2);
  const int s = side(word, i + 1);
  const TangentPoint in({here.at, -s}, {before.at, -side(word, i)}, r),
      out({here.at, s}, {after.at, side(word, i + 2)}, r);
  if (same_point(in, out)) return may_be_none;
  const TangentPoint &low = s > 0 ? in : out, &high = s > 0 ? out : in;
  return is_before(low, high, here) && ground_->walls.arc_is_free(low, high, ground_->walls.around(here.at, r));
}

/// Which way the legs turn at a corner of openings.
int DiscWords::turn_at(const DiscWord& word, std::size_t i, double r) const {
  const TangentEnd here{at(word, i + 1).at, 0}, before{at(word, i).at, side(word, i)},
      after{at(word, i + 2).at, side(word, i + 2)};
  const TangentFrame<Interval> in(before, here, r), out(here, after, r);
  const auto along = [](const TangentFrame<Interval>& f) {
    const double root = std::sqrt(std::max(0.0, f.R.middle())), k = f.k.middle();
    return Point{root * f.dx.middle() + k * f.dy.middle(), root * f.dy.middle() - k * f.dx.middle()};
  };
  const Point u = along(in), v = along(out);
  const double cross = u.x * v.y - u.y * v.x;
  return (cross > 0) - (cross < 0);
}

bool DiscWords::keeps_turning(const DiscWord& word, std::size_t i, double r, int turn) const {
  return turn_at(word, i, r) * turn >= 0;
}

/// Parts are the legs, then what is at the stops.
bool DiscWords::part_is_free(const DiscWord& word, std::size_t part, double r, const std::vector<int>& turns) const {
  if (part <= word.size()) return leg_is_free(word, part, r);
  const std::size_t i = part - word.size() - 1;
  if (word[i].side != 0) return arc_is_free(word, i, r, true);
  return keeps_turning(word, i, r, turns[i]);
}

bool DiscWords::is_free(const DiscWord& word, double r) const {
  const std::vector<int> turns(word.size(), 0);
  for (std::size_t part = 0; part < 2 * word.size() + 1; ++part)
    if (!part_is_free(word, part, r, turns)) return false;
  return true;
}

/// A leg that is free for r and for 2r is free between, in words of shortest ways (docs/tradeoff.md).
double DiscWords::last_free(const DiscWord& word, double from, double most) const {
  std::vector<int> turns(word.size(), 0);
  for (std::size_t i = 0; i < word.size(); ++i)
    if (word[i].side == 0) turns[i] = turn_at(word, i, from);
  std::vector<std::size_t> stopped;
  double low = from, high = from;
  while (stopped.empty()) {
    if (high == most) return most;
    low = high;
    high = std::min(2 * low, most);
    for (std::size_t part = 0; part < 2 * word.size() + 1; ++part)
      if (!part_is_free(word, part, high, turns)) stopped.push_back(part);
  }
  for (double middle = low + (high - low) / 2; middle != low && middle != high; middle = low + (high - low) / 2) {
    std::vector<std::size_t> left;
    for (const std::size_t part : stopped)
      if (!part_is_free(word, part, middle, turns)) left.push_back(part);
    (left.empty() ? low : high) = middle;
    if (!left.empty()) stopped = std::move(left);
  }
  return low;
}

/// Corners whose circles the leg has come to touch, in order along it.
std::vector<WordStop> DiscWords::touched_by(const DiscWord& word, std::size_t leg, double r) const {
  const TangentFrame<Interval> f({at(word, leg).at, side(word, leg)}, {at(word, leg + 1).at, side(word, leg + 1)}, r);
  const double D = f.D.middle(), root = std::sqrt(std::max(0.0, f.R.middle())), k = f.k.middle();
  const double dx = f.dx.middle(), dy = f.dy.middle();
  const Point u{(root * dx + k * dy) / D, (root * dy - k * dx) / D};
  const double s1 = f.s1.middle(), x0 = f.cx.middle() + s1 * u.y, y0 = f.cy.middle() - s1 * u.x;
  const double slack = kTouching * (root + r);
  std::vector<std::pair<double, WordStop>> found;
  for (std::uint32_t i = 0; i < ground_->sites.size(); ++i) {
    const TangentSite& site = ground_->sites[i];
    if (site.at == at(word, leg).at || site.at == at(word, leg + 1).at) continue;
    const double x = site.at.x - x0, y = site.at.y - y0, along = u.x * x + u.y * y, off = u.x * y - u.y * x;
    if (along < -slack || along > root + slack) continue;
    if (std::abs(std::abs(off) - (site.round ? r : 0)) > slack) continue;
    found.push_back({along, {i, !site.round ? 0 : off > 0 ? 1 : -1}});
  }
  std::ranges::stable_sort(found, {}, [](const auto& touched) { return touched.first; });
  std::vector<WordStop> stops;
  for (const auto& [along, stop] : found) stops.push_back(stop);
  return stops;
}

/// Puts some of `all` from `next` on into the word at `at`, so that the legs and arcs there are free.
bool DiscWords::fill(DiscWord& word, std::size_t at, const std::vector<WordStop>& all, std::size_t next,
                     double r) const {
  const auto before = [&] { return at == 0 || word[at - 1].side == 0 || arc_is_free(word, at - 1, r, false); };
  if (leg_is_free(word, at, r) && before()) return true;
  for (std::size_t i = next; i < all.size(); ++i) {
    word.insert(word.begin() + static_cast<std::ptrdiff_t>(at), all[i]);
    if (leg_is_free(word, at, r) && before() && fill(word, at + 1, all, i + 1, r)) return true;
    word.erase(word.begin() + static_cast<std::ptrdiff_t>(at));
  }
  return false;
}

std::optional<DiscWord> DiscWords::beyond(const DiscWord& word, double last) const {
  const double r = std::nextafter(last, kInfinite);
  DiscWord result = word;
  for (std::size_t i = 0; i < result.size(); ++i) {
    if (result[i].side != 0 || keeps_turning(result, i, r, turn_at(word, i, last / 2))) continue;
    result.erase(result.begin() + static_cast<std::ptrdiff_t>(i));
    return is_free(result, r) ? std::optional(result) : std::nullopt;
  }
  for (std::size_t leg = result.size() + 1; leg-- > 0;) {
    if (leg_is_free(result, leg, r)) continue;
    const std::vector<WordStop> touched = touched_by(result, leg, last);
    if (touched.empty() || touched.size() > kMostTouching || !fill(result, leg, touched, 0, r)) return std::nullopt;
  }
  if (result == word || !is_free(result, r)) return std::nullopt;
  return result;
}

ArcPath DiscWords::path(const DiscWord& word, double r) const {
  ArcPath path{r, s_.at, g_.at, {}, {}};
  for (const WordStop& stop : word) path.bends.push_back({ground_->sites[stop.site].at, stop.side});
  path.length = length_of(pieces(path));
  return path;
}

std::optional<DiscWord> DiscWords::word_of(const ArcPath& path) const {
  DiscWord word;
  for (const ArcBend& bend : path.bends) {
    const auto site = std::ranges::find_if(
        ground_->sites, [&](const TangentSite& s) { return s.at == bend.corner && s.round == (bend.turn != 0); });
    if (site == ground_->sites.end()) return std::nullopt;
    word.push_back({static_cast<std::uint32_t>(site - ground_->sites.begin()), bend.turn});
  }
  return word;
}

bool DiscWords::passes_corner_of_openings(const DiscWord& word) const {
  return std::ranges::any_of(word, [](const WordStop& stop) { return stop.side == 0; });
}

}  // namespace taut::detail
