#include <taut/search/anytime_search.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <taut/geometry/exact/twofold.h>
#include <taut/geometry/expects.h>
#include <taut/search/detail/goal_distance.h>
#include <taut/search/detail/labels.h>
#include <taut/search/detail/query_graph.h>

namespace taut {

namespace {

using detail::Labels;
using detail::QueryGraph;
using Vertex = Roadmap::Vertex;

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr Vertex kNoVertex = 0xffffffff;
constexpr double kNearOne = 1.0 / 64;

double divide_up(double a, double b) {
  const double q = a / b;
  return std::fma(q, b, -a) < 0 ? std::nextafter(q, kInfinite) : q;
}
double multiply_down(double a, double b) {
  const double p = a * b;
  return std::fma(a, b, -p) < 0 ? std::nextafter(p, 0.0) : p;
}

std::vector<Point> goal_points(const GraphQuery& query) {
  std::vector<Point> points;
  for (const Terminal& goal : query.goals) points.push_back(goal.point);
  return points;
}

class Clock {
 public:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count(); }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace

struct AnytimeSearch::Impl {
  Impl(std::shared_ptr<const Roadmap> map, GraphQuery asked, double first_epsilon)
      : roadmap(std::move(map)),
        query(std::move(asked)),
        graph(*roadmap, query),
        labels(*roadmap, query.start.point, goal_points(query)),
        vertices(graph.vertex_count()),
        epsilon(first_epsilon) {
    VertexState& start = vertices[graph.start()];
    start.label = Labels::kStart;
    start.rest = detail::goal_distance_below(query, query.start.point);
    push(graph.start());
  }

  enum class Place : std::uint8_t { nowhere, open, inconsistent };

  struct VertexState {
    double rest = 0;  // lower bound of the way to a goal
    Labels::Id label = Labels::kNone;
    std::uint32_t closed = 0;  // the last round it was expanded in
    Place place = Place::nowhere;
  };

  /// Out of date when the vertex has another label by now, or is not open.
  struct Entry {
    double key, rest;
    Vertex vertex;
    Labels::Id label;

    friend bool operator<(const Entry& a, const Entry& b) {  // the greatest comes first
      if (a.key != b.key) return a.key > b.key;
      return a.rest != b.rest ? a.rest > b.rest : a.vertex > b.vertex;
    }
  };

  bool is_current(const Entry& e) const {
    return vertices[e.vertex].place == Place::open && vertices[e.vertex].label == e.label;
  }
  bool is_found() const { return best != Labels::kNone; }
  double lower_bound(Vertex v) const { return twofold::add_down(labels[vertices[v].label].lo, vertices[v].rest); }
  bool is_hopeless(Vertex v) const { return is_found() && lower_bound(v) >= upper; }

  void push(Vertex v) {
    VertexState& state = vertices[v];
    state.place = Place::open;
    const double weighted = multiply_down(pull, state.rest);
    open.push_back({twofold::add_down(labels[state.label].lo, weighted), state.rest, v, state.label});
    std::push_heap(open.begin(), open.end());
  }

  Entry pop() {
    std::pop_heap(open.begin(), open.end());
    const Entry entry = open.back();
    open.pop_back();
    return entry;
  }

  /// The open vertex to expand next: one that the goal's length does not yet beat. kNoVertex when the round is over.
  Vertex next() {
    while (!open.empty() && (!is_found() || open.front().key < upper)) {
      const Entry entry = pop();
      if (!is_current(entry)) continue;
      vertices[entry.vertex].place = Place::nowhere;
      if (!is_hopeless(entry.vertex)) return entry.vertex;
    }
    return kNoVertex;
  }

  void expand(Vertex v) {
    ++expanded;
    is_idle = false;
    vertices[v].closed = round;
    const QueryGraph::Row row = graph.row(v);
    for (const auto targets : {row.first, row.second})
      for (const Vertex to : targets) offer(vertices[v].label, to);
  }

  void offer(Labels::Id parent, Vertex v) {
    VertexState& state = vertices[v];
    const bool is_new = state.label == Labels::kNone;
    if (!is_new && !labels.is_shorter(parent, v, state.label)) return;
    state.label = labels.extend(parent, v, state.label);
    generated += is_new;
    if (graph.is_goal(v)) return take_goal(v);
    if (is_new) state.rest = detail::goal_distance_below(query, labels.point(v));
    if (is_hopeless(v)) {
      if (state.place == Place::open) state.place = Place::nowhere;  // one that is listed as inconsistent stays there
    } else if (state.closed != round) {
      push(v);
    } else if (state.place != Place::inconsistent) {
      state.place = Place::inconsistent;
      inconsistent.push_back(v);
    }
  }

  void take_goal(Vertex v) {
    const Labels::Id label = vertices[v].label;
    if (is_found() && best_goal != v && labels.compare(labels.chain(label), labels.chain(best)) >= 0) return;
    best = label;
    best_goal = v;
    upper = std::min(upper, labels[label].hi);
  }

  /// All that is not settled becomes open, in the order of the pull.
  void begin_round(double with_pull) {
    pull = with_pull;
    ++round;
    is_idle = true;
    std::vector<Vertex> unsettled = std::exchange(inconsistent, {});
    for (const Entry& e : open)
      if (is_current(e)) unsettled.push_back(e.vertex);
    open.clear();
    for (const Vertex v : unsettled) {
      vertices[v].place = Place::nowhere;
      if (is_hopeless(v)) continue;
      VertexState& state = vertices[v];
      state.place = Place::open;
      open.push_back(
          {twofold::add_down(labels[state.label].lo, multiply_down(pull, state.rest)), state.rest, v, state.label});
    }
    std::make_heap(open.begin(), open.end());
  }

  /// No path is shorter than this.
  void look_for_bound() {
    double least = kInfinite;
    for (const Entry& e : open)
      if (is_current(e)) least = std::min(least, lower_bound(e.vertex));
    for (const Vertex v : inconsistent) least = std::min(least, lower_bound(v));
    if (!is_found()) {
      is_none = least == kInfinite;
      return;
    }
    lower = std::max(lower, std::min(least, labels[best].lo));
    is_optimal = is_optimal || least >= upper || lower >= upper;
    const double quotient = is_optimal ? 1 : lower > 0 ? std::max(1.0, divide_up(upper, lower)) : kInfinite;
    bound = std::min(bound, quotient);
  }

  bool is_stage_over() const { return is_none || is_optimal || (epsilon > 1 && bound <= epsilon); }

  void begin_stage() {
    if (is_begun) {
      const double excess = (std::min(epsilon, bound) - 1) / 2;
      epsilon = excess < kNearOne ? 1 : 1 + excess;
    }
    is_begun = is_in_stage = true;
    begin_round(epsilon);
  }

  SearchStatus stage(const SearchLimits& limits) {
    const Clock clock;
    std::size_t count = 0;
    if (!is_in_stage) begin_stage();
    while (true) {
      const bool is_late = limits.seconds < 1e9 && count % 64 == 0 && clock.seconds() >= limits.seconds;
      if (is_late || count >= limits.expansions) {
        look_for_bound();
        if (!is_stage_over()) return SearchStatus::stopped;
        break;
      }
      if (const Vertex v = next(); v != kNoVertex) {
        expand(v);
        ++count;
        continue;
      }
      look_for_bound();
      if (is_stage_over()) break;
      // A round without work: only rounding keeps the bound above epsilon. Without a pull there is work until it is 1.
      begin_round(is_idle ? 1 : epsilon);
    }
    is_in_stage = false;
    return is_none ? SearchStatus::none : SearchStatus::found;
  }

  std::shared_ptr<const Roadmap> roadmap;
  GraphQuery query;
  QueryGraph graph;
  Labels labels;
  std::vector<VertexState> vertices;
  std::vector<Entry> open;  // a heap
  std::vector<Vertex> inconsistent;
  double epsilon;
  double pull = 1;  // what the heuristic is multiplied by in this round
  Labels::Id best = Labels::kNone;
  Vertex best_goal = 0;
  double upper = kInfinite, lower = 0, bound = kInfinite;
  std::uint32_t round = 0;
  bool is_begun = false, is_in_stage = false, is_idle = true, is_none = false, is_optimal = false;
  std::size_t expanded = 0, generated = 1;
  double seconds = 0;
};

AnytimeSearch::AnytimeSearch(std::shared_ptr<const Roadmap> roadmap, GraphQuery query, double epsilon)
    : impl_((TAUT_EXPECTS(roadmap != nullptr && epsilon >= 1 && epsilon <= kLargestEpsilon),
             std::make_unique<Impl>(std::move(roadmap), std::move(query), epsilon))) {}
AnytimeSearch::~AnytimeSearch() = default;
AnytimeSearch::AnytimeSearch(AnytimeSearch&&) noexcept = default;
AnytimeSearch& AnytimeSearch::operator=(AnytimeSearch&&) noexcept = default;

SearchStatus AnytimeSearch::improve(const SearchLimits& limits) {
  if (impl_->is_none) return SearchStatus::none;
  if (impl_->is_optimal) return SearchStatus::found;
  const Clock clock;
  const SearchStatus status = impl_->stage(limits);
  impl_->seconds += clock.seconds();
  return status;
}

Path AnytimeSearch::best() const {
  Path path;
  if (!impl_->is_found()) return path;
  path.points = impl_->labels.points(impl_->labels.chain(impl_->best));
  path.length = Length(path.points);
  return path;
}

std::size_t AnytimeSearch::goal() const { return impl_->is_found() ? impl_->best_goal - impl_->graph.start() - 1 : 0; }
double AnytimeSearch::bound() const { return impl_->bound; }
bool AnytimeSearch::optimal() const { return impl_->is_optimal; }
double AnytimeSearch::epsilon() const { return impl_->epsilon; }
std::size_t AnytimeSearch::expanded() const { return impl_->expanded; }
std::size_t AnytimeSearch::generated() const { return impl_->generated; }
double AnytimeSearch::seconds() const { return impl_->seconds; }

AnytimeImprovement AnytimeSearch::latest() const { return {epsilon(), bound(), best().length, expanded(), seconds()}; }

}  // namespace taut
