// What labels stand for: the points of a path.
#include <algorithm>

#include <taut/geometry/length.h>
#include <taut/geometry/written.h>
#include <taut/search/detail/index_query.h>

namespace taut::detail {

/// Both ends' ways to where they meet.
void IndexQuery::unpack(const Way& way, std::vector<std::uint32_t>& bends) {
  if (way.meeting != kNone) {
    from_.climb.chain(way.meeting, bends);
    to_.climb.chain(way.meeting, part_);
  } else {
    unpack(from_, way.from, bends);
    unpack(to_, way.to, part_);
  }
  bends.insert(bends.end(), part_.rbegin() + 1, part_.rend());
}

/// From the end to the label's hub; there next() stays where it is.
void IndexQuery::unpack(End& end, std::uint32_t label, std::vector<std::uint32_t>& bends) const {
  const std::uint32_t* const next = parts_.image.next().data();
  const bool has_core = parts_.image.has_core();
  std::uint32_t bend = parts_.bend_of(label);
  if (has_core)
    end.climb.chain(bend, bends);
  else
    bends.assign(1, bend);
  for (std::size_t steps = 0; next[label] != label && steps <= parts_.bends.size(); ++steps) {
    if (has_core) unpack_edge(parts_.image, core_edge(bend, label), false, bends);
    label = next[label];
    bend = parts_.bend_of(label);
    if (!has_core) bends.push_back(bend);
  }
}

/// By which the label goes on.
const IndexImage::Edge& IndexQuery::core_edge(std::uint32_t bend, std::uint32_t label) const {
  const auto cores = parts_.image.cores(bend);
  return *(std::upper_bound(cores.begin(), cores.end(), label,
                            [](std::uint32_t k, const IndexImage::Core& edge) { return k < edge.label; }) -
           1);
}

/// Without points in a straight line.
void IndexQuery::give(const std::vector<std::uint32_t>& bends, std::vector<Point>& path) const {
  path.assign(1, from_.point);
  if (from_.is_integer && to_.is_integer) {
    IntegerPlaces::Place before{}, last = from_.place.at;
    const auto add = [&](IntegerPlaces::Place at, Point p) {
      if (at == last) return;
      if (path.size() > 1 && IntegerPlaces::side(before, last, at) == 0)
        path.pop_back();
      else
        before = last;
      path.push_back(p);
      last = at;
    };
    for (const std::uint32_t v : bends) add(parts_.bends[v].at, parts_.point(v));
    return add(to_.place.at, to_.point);
  }
  const auto add = [&](Point p) {
    if (p == path.back()) return;
    if (path.size() > 1 && written::on_segment(path.back(), path[path.size() - 2], p)) path.pop_back();
    path.push_back(p);
  };
  for (const std::uint32_t v : bends) add(parts_.point(v));
  add(to_.point);
}

bool IndexQuery::is_shorter(const std::vector<Point>& a, const std::vector<Point>& b) {
  const auto legs_of = [](const std::vector<Point>& points, std::vector<Segment>& legs) {
    legs.clear();
    for (std::size_t i = 1; i < points.size(); ++i) legs.push_back({points[i - 1], points[i]});
  };
  if (a == b) return false;
  legs_of(a, legs_a_);
  legs_of(b, legs_b_);
  return compare_lengths(legs_a_, legs_b_) < 0;
}

}  // namespace taut::detail
