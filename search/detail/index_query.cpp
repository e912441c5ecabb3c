#include <taut/search/detail/index_query.h>

#include <algorithm>
#include <cmath>

#include <taut/geometry/written.h>
#include <taut/search/query_ends.h>

namespace taut::detail {

IndexQuery::IndexQuery(const IndexParts& parts) : parts_(parts), from_(parts), to_(parts), best_(parts.bends.size()) {
  if (parts.integers && !parts.has_sights()) sights_.emplace(parts.graph, *parts.integers);
  if (parts.integers) per_place_ = parts.image.header().per_length / parts.integers->places().per_unit();
}

void IndexQuery::find(Point from, Point to, std::vector<Point>& path) {
  path.clear();
  ways_.clear();
  scanned_ = 0;
  settle(from_, from, "start");
  settle(to_, to, "goal");
  if (is_seen(from_, to_)) {
    path.push_back(from);
    if (from != to) path.push_back(to);
    return;
  }
  look_around(from_);
  look_around(to_);
  if (parts_.image.has_core()) {
    climb(from_);
    climb(to_);
  }
  spread_from();
  meet_to();
  if (parts_.image.has_core()) meet_below();
  if (least_ < kFar) collect();
  forget();
  for (std::size_t i = 0; i < ways_.size(); ++i) {
    unpack(ways_[i], i == 0 ? bends_ : other_bends_);
    if (i > 0 && bends_ == other_bends_) continue;
    give(i == 0 ? bends_ : other_bends_, i == 0 ? path : other_);
    if (i == 0 || !is_shorter(other_, path)) continue;
    path.swap(other_);
    bends_.swap(other_bends_);
  }
}

void IndexQuery::settle(End& end, Point point, const char* role) const {
  end.point = point;
  end.count = 0;
  end.is_integer = parts_.integers && parts_.integers->find(point, end.place);
  if (!end.is_integer) require_free(parts_.graph.space(), point, role);
}

bool IndexQuery::is_seen(const End& from, const End& to) const {
  if (from.is_integer && to.is_integer) {
    const IntegerWorld::Sight sight = parts_.integers->sees(from.place, to.place);
    if (sight != IntegerWorld::Sight::unknown) return sight == IntegerWorld::Sight::yes;
  }
  return parts_.graph.space().sees(from.point, to.point);
}

namespace {

std::uint32_t turns_at(const IndexParts& parts, std::uint32_t bend, Point from) {
  const Triangulation& tri = parts.graph.space().triangulation();
  const Triangulation::Sector& sector = tri.sectors[parts.graph.sector(bend)];
  const auto side = [&](std::uint32_t vertex) {
    return written::orientation(from, parts.point(bend), tri.points[vertex]);
  };
  const int right = side(sector.right), left = side(sector.left);
  return (right <= 0 && left <= 0 ? kMayTurnRight : 0u) | (right >= 0 && left >= 0 ? kMayTurnLeft : 0u);
}

}  // namespace

void IndexQuery::look_around(End& end) {
  if (end.is_integer && parts_.has_sights()) {
    for (std::uint32_t i = 0; i < end.place.count; ++i) look_in(end, end.place.triangles[i]);
    return;
  }
  const double per_length = parts_.image.header().per_length;
  const auto add = [&](std::uint32_t v, std::uint32_t turns) {
    if (end.runs.size() == end.count) end.runs.emplace_back();
    const auto length = static_cast<std::uint32_t>(leg_of(end.point, parts_.point(v)).high * per_length + 0.5);
    end.runs[end.count++] = {parts_.bends[v].begin, parts_.bends[v].end, length, v, turns, 0};
  };
  if (end.is_integer) return sights_->from(end.place, add);
  for (const std::uint32_t v : parts_.graph.visible_from(end.point)) add(v, turns_at(parts_, v, end.point));
}

void IndexQuery::look_in(End& end, std::uint32_t triangle) const {
  const std::uint32_t* const begin = &parts_.image.sights_begin()[4 * std::size_t{triangle}];
  const std::uint32_t* const words = parts_.image.sights().data();
  end.runs.resize(std::max<std::size_t>(end.runs.size(), end.count + (begin[4] - begin[0]) / 2));
  Run* const runs = end.runs.data();
  std::size_t count = end.count;
  const IntegerPlaces::Place at = end.place.at;
  const auto add = [&](const std::uint32_t* sight, bool is_seen) {
    runs[count].bend = sight[0];
    runs[count].end = sight[1];
    count += is_seen;
  };
  const auto turn = [&](const std::uint32_t* sight, std::uint32_t ray) {
    const IntegerPlaces::Place bend = parts_.bends[sight[0] / 2].at;
    return IntegerPlaces::cross(IntegerPlaces::difference(parts_.rays[ray], bend), IntegerPlaces::difference(at, bend));
  };
  std::uint32_t k = begin[0];
  for (; k < begin[1]; k += 2) add(words + k, true);
  for (; k < begin[2]; k += 3) add(words + k, turn(words + k, words[k + 2]) >= 0);
  for (; k < begin[3]; k += 3) add(words + k, turn(words + k, words[k + 2]) <= 0);
  for (; k < begin[4]; k += 4) {
    // Both, without a branch that would be taken at random.
    const int right = turn(words + k, words[k + 2]) >= 0, left = turn(words + k, words[k + 3]) <= 0;
    add(words + k, (right & left) != 0);
  }
  for (std::size_t i = end.count; i < count; ++i) {
    Run& run = runs[i];
    const IndexParts::Bend& bend = parts_.bends[run.bend / 2];
    const bool is_right = run.bend % 2 == kRightTurn;
    run.length = static_cast<std::uint32_t>(IntegerPlaces::distance(bend.at, at) * per_place_ + 0.5);
    run.begin = is_right ? bend.begin : bend.end - run.end;
    run.end = is_right ? bend.begin + run.end : bend.end;
    run.turns = is_right ? kMayTurnRight : kMayTurnLeft;
    run.bend /= 2;
  }
  end.count = count;
}

/// To the bends of the core, and what may follow there.
void IndexQuery::climb(End& end) const {
  end.climb.begin(end.point, end.is_integer ? &end.place.at : nullptr);
  for (std::size_t i = 0; i < end.count; ++i) {
    const Run& run = end.runs[i];
    const double length = end.is_integer ? IntegerPlaces::distance(parts_.bends[run.bend].at, end.place.at) /
                                               parts_.integers->places().per_unit()
                                         : leg_of(end.point, parts_.point(run.bend)).high;
    end.climb.add(run.bend, run.turns, length);
  }
  end.climb.run();
  end.count = 0;
  const double per_length = parts_.image.header().per_length;
  for (const std::uint32_t bend : end.climb.reached()) {
    if (parts_.bends[bend].begin == parts_.bends[bend].end) continue;
    if (end.climb.length(bend) * per_length > kFar / 2) continue;  // longer than any shortest path
    if (end.runs.size() == end.count) end.runs.emplace_back();
    const IndexClimb::Range range = end.climb.labels_behind(bend);
    const auto length = static_cast<std::uint32_t>(end.climb.length(bend) * per_length + 0.5);
    end.runs[end.count++] = {range.begin, range.end, length, bend, 0, 0};
  }
}

void IndexQuery::spread_from() {
  const IndexImage::Label* const labels = parts_.image.labels().data();
  has_ties_ = false;
  for (std::size_t i = 0; i < from_.count; ++i) {
    const Run run = from_.runs[i];
    scanned_ += run.end - run.begin;
    for (std::uint32_t k = run.begin; k < run.end; ++k) {
      const std::uint32_t length = run.length + labels[k].length;
      Best& best = best_[labels[k].hub];
      if (length >= best.length + kDoubtUnits) continue;
      if (length + kDoubtUnits > best.length) {
        const IndexParts::Bend& bend = parts_.bends[run.bend];
        has_ties_ |= best.label < bend.begin || best.label >= bend.end;
      }
      if (length < best.length) best = {length, k};
    }
  }
}

void IndexQuery::meet_to() {
  const IndexImage::Label* const labels = parts_.image.labels().data();
  least_ = kFar;
  for (std::size_t i = 0; i < to_.count; ++i) {
    Run& run = to_.runs[i];
    run.least = kFar;
    if (run.length >= least_ + kDoubtUnits) continue;
    scanned_ += run.end - run.begin;
    for (std::uint32_t k = run.begin; k < run.end; ++k)
      run.least = std::min(run.least, labels[k].length + best_[labels[k].hub].length);
    run.least = std::min(kFar, run.least + run.length);
    least_ = std::min(least_, run.least);
  }
}

/// Ways that do not come to the core.
void IndexQuery::meet_below() {
  meetings_.clear();
  for (const std::uint32_t bend : to_.climb.reached()) {
    if (!from_.climb.is_reached(bend) || parts_.bends[bend].begin != parts_.bends[bend].end) continue;
    const double length = (from_.climb.length(bend) + to_.climb.length(bend)) * parts_.image.header().per_length;
    if (length + 0.5 > least_ + kDoubtUnits) continue;
    meetings_.push_back({bend, static_cast<std::uint32_t>(length + 0.5)});
    least_ = std::min(least_, meetings_.back().length);
  }
}

/// All ways that may be the shortest.
void IndexQuery::collect() {
  const IndexImage::Label* const labels = parts_.image.labels().data();
  const std::uint32_t limit = least_ + kDoubtUnits;
  for (std::size_t i = 0; i < to_.count; ++i) {
    const Run run = to_.runs[i];
    if (run.least > limit) continue;
    for (std::uint32_t k = run.begin; k < run.end; ++k) {
      const Best& best = best_[labels[k].hub];
      const std::uint32_t behind = run.length + labels[k].length;
      if (behind + best.length <= limit) ways_.push_back({best.label, k, limit - behind});
    }
  }
  if (has_ties_) collect_ties();
  if (!parts_.image.has_core()) return;
  for (const Meeting& meeting : meetings_)
    if (meeting.length <= limit) ways_.push_back({0, 0, 0, meeting.bend});
}

/// Of each hub on those ways only one bend that the start sees is known yet.
void IndexQuery::collect_ties() {
  const IndexImage::Label* const labels = parts_.image.labels().data();
  for (std::size_t w = 0, count = ways_.size(); w < count; ++w) {
    const Way way = ways_[w];
    for (std::size_t i = 0; i < from_.count; ++i) {
      const Run run = from_.runs[i];
      for (std::uint32_t k = run.begin; k < run.end; ++k)
        if (labels[k].hub == labels[way.to].hub && k != way.from && run.length + labels[k].length <= way.before)
          ways_.push_back({k, way.to, way.before});
    }
  }
}

void IndexQuery::forget() {
  const IndexImage::Label* const labels = parts_.image.labels().data();
  for (std::size_t i = 0; i < from_.count; ++i)
    for (std::uint32_t k = from_.runs[i].begin; k < from_.runs[i].end; ++k) best_[labels[k].hub].length = kFar;
}

}  // namespace taut::detail
