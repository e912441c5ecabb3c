#include <taut/search/detail/radius_sweep.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <taut/search/arc_search.h>

namespace taut::detail {

namespace {

using End = TradeoffStretch::End;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

constexpr double kAlike = 1e-6;  // of slopes

double after(double r) { return std::nextafter(r, kInfinite); }

}  // namespace

RadiusSweep::RadiusSweep(const AllRadii& radii, const PassageIndex& index, Point s, Point g,
                         const std::function<void(TradeoffStretch)>& tell)
    : radii_(radii), index_(index), s_(s), g_(g), tell_(tell) {}

/// The class of a word, for as long as there is a way.
void RadiusSweep::follow(DiscWord word, double from, double most) {
  way_.clear();
  for (;;) {
    const double to = words_->last_free(word, from, most);
    way_.push_back({from, to, word, length_formula(words_->path(word, from))});
    if (to == most) return;
    auto next = words_->beyond(word, to);
    if (!next) return;
    word = std::move(*next);
    from = after(to);
  }
}

double RadiusSweep::length(double r) const {
  const auto piece = std::ranges::find_if(way_, [&](const Piece& p) { return r <= p.to; });
  return (piece == way_.end() ? way_.back() : *piece).length(r);
}

void RadiusSweep::sweep(double from, double most) {
  double a = from;
  while (a <= most) {
    const TangentGraph graph = radii_.at_radius(a);
    ++graphs_;
    if (!words_) words_.emplace(graph.parts().ground, s_, g_);
    if (way_.empty()) {
      const ArcSearchResult found = arc_search(graph, s_, g_);
      auto word = found.status == DiscStatus::found ? words_->word_of(found.path) : std::nullopt;
      if (!word) return;
      follow(std::move(*word), a, most);
    }
    double b = way_.back().to;
    slack_ = 1e-13 * length(b);
    const auto rival = first_rival(graph, a, b);
    if (rival && words_->is_free(rival->word, rival->at)) {
      const auto [last, first] = enclosed(*rival, b);
      const double begun = way_.front().from;
      if (last >= begun) tell_until(last, End::shorter);
      a = last >= begun ? first : begun;
      follow(rival->word, a, most);
    } else if (rival) {
      a = std::max(rival->at, a * (1 + 1e-12));
    } else if (b < way_.back().to) {
      a = b;
    } else {
      tell_until(b, b == most ? End::last : End::closed);
      way_.clear();
      a = after(b);
    }
  }
}

/// Of all that become shorter before `to`, the first; `to` is brought nearer where there are too many to tell.
std::optional<RadiusSweep::Rival> RadiusSweep::first_rival(const TangentGraph& graph, double from, double& to) {
  const auto piece = std::ranges::find_if(way_, [&](const Piece& p) { return from <= p.to; });
  RadiusRivals rivals(graph.parts(), *words_, piece->word);
  if (window_ > 0) to = std::min(to, from + 4 * window_);
  auto found = rivals.until(to, length(to));
  while (!found && to - from > 1e-9 * from) {
    to = from + (to - from) / 2;
    found = rivals.until(to, length(to));
  }
  window_ = to - from;
  std::optional<Rival> first;
  if (!found) return first;
  for (DiscWord& word : *found) {
    LengthFormula rival = length_formula(words_->path(word, from));
    if (words_->passes_corner_of_openings(word)) {
      const double slope = rival.slope(from);
      rival = {rival(from) - slope * from, slope, {}};
    }
    const auto at = first_below(rival, from, first ? first->at : to);
    if (at && (!first || *at < first->at)) first = Rival{*at, std::move(word)};
  }
  return first;
}

std::optional<double> RadiusSweep::first_below(const LengthFormula& rival, double from, double to) const {
  for (const Piece& piece : way_) {
    if (piece.to < from || piece.from > to) continue;
    const auto [a, b] = LengthFormula::apart(rival, piece.length);
    if (auto at = below(a, b, std::max(from, piece.from), std::min(to, piece.to))) return at;
  }
  return std::nullopt;
}

/// A convex function is not below its tangents, and not above its chords.
std::optional<double> RadiusSweep::below(const LengthFormula& rival, const LengthFormula& best, double from,
                                         double to) const {
  const double x = rival(from), y = rival(to), c = best(from), d = best(to);
  if (x - c < -slack_) return from;
  if (x + rival.slope(from) * (to - from) - d >= -slack_) return std::nullopt;
  if (y - d >= -slack_ && y - rival.slope(to) * (to - from) - c >= -slack_) return std::nullopt;
  const double middle = from + (to - from) / 2;
  if (to - from < 1e-14 * to) return y - d < -slack_ ? std::optional(to) : std::nullopt;
  if (auto at = below(rival, best, from, middle)) return at;
  return below(rival, best, middle, to);
}

/// Up to the first the way is certainly no longer than the rival, from the second on the rival.
std::pair<double, double> RadiusSweep::enclosed(const Rival& rival, double to) const {
  const double from = way_.front().from;
  const auto difference = [&](double r) {
    const auto piece = std::ranges::find_if(way_, [&](const Piece& p) { return r <= p.to; });
    return words_->path(rival.word, r).length - words_->path(piece->word, r).length;
  };
  const auto surely = [&](double r, bool of_way) {
    const Interval d = difference(r);
    return of_way ? d.lo >= 0 : d.hi <= 0;
  };
  // Where the way gained a corner, both touched: as long as each other until then.
  const LengthFormula formula = length_formula(words_->path(rival.word, rival.at));
  for (std::size_t i = 0; i + 1 < way_.size() && way_[i].to < rival.at; ++i) {
    const auto [a, b] = LengthFormula::apart(formula, way_[i].length);
    const double e = way_[i].to;
    if (std::abs(a(e) - b(e)) < slack_ && std::abs(a.slope(e) - b.slope(e)) < kAlike &&
        words_->is_free(rival.word, way_[i + 1].from))
      return {e, way_[i + 1].from};
  }
  // Away from the rival's radius until it is sure, then back as far as it stays so.
  const auto end = [&](bool of_way, double most) {
    double near = rival.at, far = rival.at;
    for (double step = 0x1p-52 * rival.at; !surely(far, of_way); step *= 2) {
      if (far == most) return far;
      near = far;
      far = of_way ? std::max(most, rival.at - step) : std::min(most, rival.at + step);
    }
    for (double middle = std::midpoint(near, far); middle != near && middle != far; middle = std::midpoint(near, far))
      (surely(middle, of_way) ? far : near) = middle;
    return far;
  };
  double last = end(true, from), first = end(false, to);
  if (!surely(last, true)) last = std::nextafter(from, 0);
  if (first <= last) first = after(last);
  return {last, first};
}

std::uint32_t RadiusSweep::gate_at(double r) const {
  std::uint32_t low = 0, high = static_cast<std::uint32_t>(index_.gates().gates().size());
  while (low < high) {
    const std::uint32_t middle = low + (high - low) / 2;
    (index_.gate_radius(middle) < r ? low : high) = index_.gate_radius(middle) < r ? middle + 1 : middle;
  }
  return low < index_.gates().gates().size() && index_.gate_radius(low) == r ? low : kNone;
}

void RadiusSweep::tell_until(double to, End end) {
  for (std::size_t i = 0; i < way_.size(); ++i) {
    const Piece& piece = way_[i];
    TradeoffStretch stretch{piece.from, std::min(piece.to, to), s_, g_, {}, 0, {}, {}, End::bend, kNone};
    stretch.bends = words_->path(piece.word, stretch.from).bends;
    stretch.at_from = stretch.path(stretch.from).length;
    stretch.at_to = stretch.path(stretch.to).length;
    const bool final = i + 1 == way_.size() || way_[i + 1].from > to;
    if (final) stretch.end = end;
    if (final && end == End::closed) stretch.gate = gate_at(to);
    tell_(std::move(stretch));
    if (final) return;
  }
}

}  // namespace taut::detail
