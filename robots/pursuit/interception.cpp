#include <taut/robots/pursuit/interception.h>

#include <algorithm>
#include <limits>

#include <taut/geometry/exact/as_double.h>
#include <taut/geometry/expects.h>
#include <taut/robots/pursuit/detail/bend_tree.h>
#include <taut/robots/pursuit/detail/meeting_time.h>
#include <taut/robots/pursuit/detail/way_sight.h>

namespace taut::pursuit {

namespace {

using detail::LastBend;
using detail::MeetingTime;
using detail::Part;
using detail::TargetLeg;
using detail::WaySight;

std::vector<TargetLeg> legs_of(const Interception& question) {
  std::vector<TargetLeg> legs;
  const std::vector<TimedPoint>& way = question.way;
  for (std::size_t i = 0; i + 1 < way.size(); ++i) {
    const Rational begins = meaning(way[i].time), ends = meaning(way[i + 1].time), lasts = ends - begins;
    const ExactPoint from(way[i].at), to(way[i + 1].at);
    legs.push_back({{way[i].at, way[i + 1].at},
                    begins,
                    ends,
                    from,
                    Rational((to.x - from.x) / lasts),
                    Rational((to.y - from.y) / lasts)});
  }
  // The last place: for ever, or for its instant.
  const Rational last = meaning(way.back().time);
  legs.push_back({{way.back().at, way.back().at}, last, last, ExactPoint(way.back().at), 0, 0, question.stays});
  return legs;
}

/// A time by which a robot is at the leg's place, and later than it begins.
Rational late_enough(const LastBend& bend, const TargetLeg& leg, const Rational& speed) {
  const double apart = root_as_double(detail::squared_distance(leg.at, bend.at), Toward::up);
  const Rational needs = (Rational(bend.length.hi) + Rational(apart)) / speed;
  return std::max(needs, leg.begins) + 1;
}

class Search {
 public:
  Search(const VisibilityGraph& graph, const Interception& question)
      : graph_(graph),
        question_(question),
        speed_(meaning(question.speed)),
        legs_(legs_of(question)),
        tree_(graph, question.start) {}

  std::optional<MeetingPlace> find() {
    look(WaySight(graph_.space(), question_.start), {ExactPoint(question_.start), {}, 0}, kNone);
    const double speed = as_double(speed_, Toward::up);
    for (const Roadmap::Vertex v : tree_.reached()) {
      // Nobody is at this bend, or at a later one, before the best meeting so far.
      if (best_ && tree_.length(v).lo > speed * best_->time.hi * (1 + 1e-15)) break;
      const auto& sector = graph_.space().triangulation().sectors[graph_.sector(v)];
      look(WaySight(graph_.space(), sector), {ExactPoint(graph_.roadmap().point(v)), tree_.roots(v), tree_.length(v)},
           v);
    }
    return std::move(best_);
  }

 private:
  void look(const WaySight& sight, const LastBend& bend, Roadmap::Vertex v) {
    for (std::size_t i = 0; i < legs_.size(); ++i) {
      const TargetLeg& leg = legs_[i];
      if (best_ && as_double(leg.begins, Toward::down) >= best_->time.hi) return;
      if (!leg.endless && Interval(as_double(Rational(speed_ * leg.ends), Toward::up)).hi < bend.length.lo) continue;
      for (const Part& part : sight.parts(leg.line)) meet(bend, v, i, part);
    }
  }

  void meet(const LastBend& bend, Roadmap::Vertex v, std::size_t i, const Part& part) {
    const TargetLeg& leg = legs_[i];
    const bool stands = leg.line.a == leg.line.b;
    const Rational lasts = leg.ends - leg.begins;
    const Rational from = stands ? leg.begins : Rational(leg.begins + part.first * lasts);
    const Rational until = leg.endless ? late_enough(bend, leg, speed_)
                           : stands    ? leg.ends
                                       : Rational(leg.begins + part.second * lasts);
    if (best_ && from >= Rational(best_->time.lo)) return;
    const MeetingTime meeting(bend, leg, speed_);
    const std::optional<Interval> time = meeting.first(from, until);
    if (!time || (best_ && time->hi >= best_->time.hi)) return;
    take(bend, v, i, *time, meeting);
  }

  void take(const LastBend& bend, Roadmap::Vertex v, std::size_t i, Interval time, const MeetingTime& meeting) {
    const ExactPoint place =
        legs_[i].place(std::min(Rational(time.hi), legs_[i].endless ? Rational(time.hi) : legs_[i].ends));
    MeetingPlace found;
    found.time = time;
    found.at = nearest_point(place);
    found.leg = std::min(i, question_.way.size() - 1);
    found.path = v == kNone ? std::vector{question_.start} : tree_.path(v);
    if (found.path.back() != found.at) found.path.push_back(found.at);
    found.length = bend.length.middle() + root_as_double(detail::squared_distance(place, bend.at), Toward::nearest);
    found.waits = meeting.late(Rational(time.lo)) < 0 ? meeting.wait(time.hi) : 0;
    best_ = std::move(found);
  }

  const VisibilityGraph& graph_;
  const Interception& question_;
  Rational speed_;
  std::vector<TargetLeg> legs_;
  detail::BendTree tree_;
  std::optional<MeetingPlace> best_;
};

}  // namespace

std::optional<MeetingPlace> earliest_meeting(const VisibilityGraph& graph, const Interception& question) {
  TAUT_EXPECTS(!question.way.empty() && question.speed > 0);
  return Search(graph, question).find();
}

std::optional<std::size_t> blocked_leg(const FreeSpace& space, std::span<const TimedPoint> way) {
  if (!space.holds(way.front().at)) return 0;
  for (std::size_t i = 0; i + 1 < way.size(); ++i)
    if (!space.sees(way[i].at, way[i + 1].at)) return i;
  return std::nullopt;
}

Point place_at(std::span<const TimedPoint> way, double time) {
  if (time <= way.front().time) return way.front().at;
  for (std::size_t i = 0; i + 1 < way.size(); ++i) {
    const TimedPoint &a = way[i], &b = way[i + 1];
    if (time > b.time) continue;
    const double part = (time - a.time) / (b.time - a.time);
    return {a.at.x + part * (b.at.x - a.at.x), a.at.y + part * (b.at.y - a.at.y)};
  }
  return way.back().at;
}

}  // namespace taut::pursuit
