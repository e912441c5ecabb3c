#include <taut/python/asker.h>

#include <algorithm>
#include <chrono>
#include <limits>

#include <taut/geometry/parallel.h>
#include <taut/search/query_ends.h>

namespace taut::python {

namespace {

constexpr std::size_t kBlock = 64;  // queries that a thread takes at once

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

std::vector<Point> all_of(Point from, std::span<const Point> goals) {
  std::vector<Point> ends{from};
  ends.insert(ends.end(), goals.begin(), goals.end());
  return ends;
}

/// Threads that ask `is_over` about ten times a second: asking takes Python's lock.
Parallel crew(unsigned threads, const std::function<bool()>& is_over) {
  using Clock = std::chrono::steady_clock;
  return {threads, [is_over, asked = Clock::now()]() mutable {
            if (Clock::now() - asked < std::chrono::milliseconds(100)) return false;
            asked = Clock::now();
            return is_over();
          }};
}

}  // namespace

class Asker::Loan {
 public:
  explicit Loan(const Asker& asker) : asker_(asker) {
    const std::scoped_lock lock(*asker.mutex_);
    if (asker.idle_->empty()) return;
    search_.emplace(std::move(asker.idle_->back()));
    asker.idle_->pop_back();
  }
  Loan(const Loan&) = delete;
  Loan& operator=(const Loan&) = delete;
  ~Loan() {
    if (!search_) return;
    const std::scoped_lock lock(*asker_.mutex_);
    asker_.idle_->push_back(std::move(*search_));
  }

  PolyanyaSearch& search() {
    if (!search_) search_.emplace(asker_.polyanya_);
    return *search_;
  }

 private:
  const Asker& asker_;
  std::optional<PolyanyaSearch> search_;
};

Asker::Asker(Polyanya polyanya)
    : polyanya_(std::move(polyanya)),
      places_(polyanya_.space()),
      no_path_(std::make_shared<NoPath>(polyanya_.space())),
      mutex_(std::make_shared<std::mutex>()),
      idle_(std::make_shared<std::vector<PolyanyaSearch>>()) {}

std::optional<Asker> Asker::knowing(std::span<const Point> ends) const {
  const bool is_moved = std::ranges::any_of(ends, [&](Point p) { return is_in_reach(p) && places_.is_moved(p); });
  if (!is_moved) return std::nullopt;
  return Asker(Polyanya(FreeSpace(space().world(), space().footprint(), ends)));
}

FoundPath Asker::found(Point from, const Goal& to, Path path, std::size_t expanded) const {
  return {space(), from, to, std::move(path), true, within_of(space()), "polyanya", expanded};
}

std::optional<FoundPath> Asker::find(Point from, const Goal& to) const {
  const Point ends[] = {from, to.point.value_or(from)};
  if (const auto other = knowing(ends)) return other->find_here(from, to);
  return find_here(from, to);
}

std::optional<FoundPath> Asker::find_here(Point from, const Goal& to) const {
  require_ends(space(), from, to);
  return about(space().world().source(), [&]() -> std::optional<FoundPath> {
    Loan loan(*this);
    const PolyanyaSearch& search = loan.search();
    if (loan.search().find(from, to) == SearchStatus::found)
      return found(from, to, {search.points(), Length(search.points())}, search.expanded());
    const std::scoped_lock lock(*mutex_);
    if (!no_path_->holds(from, to)) throw Unproven(unproven_text(space()));
    return std::nullopt;
  });
}

std::optional<std::pair<FoundPath, std::size_t>> Asker::find_nearest(Point from, std::span<const Point> goals) const {
  const auto other = knowing(all_of(from, goals));
  const Asker& asked = other ? *other : *this;
  require_ends(asked.space(), from, {});
  Loan loan(asked);
  PolyanyaSearch& search = loan.search();
  if (search.find_nearest(from, goals) != SearchStatus::found) return std::nullopt;
  const Goal reached{goals[search.goal()], {}};
  return std::pair{asked.found(from, reached, {search.points(), Length(search.points())}, search.expanded()),
                   search.goal()};
}

std::vector<std::optional<FoundPath>> Asker::find_each(Point from, std::span<const Point> goals) const {
  const auto other = knowing(all_of(from, goals));
  const Asker& asked = other ? *other : *this;
  require_ends(asked.space(), from, {});
  Loan loan(asked);
  std::vector<std::optional<Path>> paths = loan.search().find_each(from, goals);
  std::vector<std::optional<FoundPath>> answers(goals.size());
  for (std::size_t i = 0; i < goals.size(); ++i)
    if (paths[i]) answers[i] = asked.found(from, {goals[i], {}}, std::move(*paths[i]), 0);
  return answers;
}

QueryStatus Asker::status_of_none(Point from, Point to) const {
  const std::scoped_lock lock(*mutex_);
  return no_path_->holds(from, {to, {}}) ? QueryStatus::none : QueryStatus::unproven;
}

void Asker::answer(PolyanyaSearch& search, const Ends& ends, std::size_t i, Answers& answers,
                   std::vector<Point>* path) const {
  const Point both[] = {ends.first, ends.second};
  if (const auto other = knowing(both)) {
    PolyanyaSearch own(other->polyanya_);
    return other->answer_here(own, ends, i, answers, path);
  }
  answer_here(search, ends, i, answers, path);
}

void Asker::answer_here(PolyanyaSearch& search, const Ends& ends, std::size_t i, Answers& answers,
                        std::vector<Point>* path) const {
  const auto& [from, to] = ends;
  const auto is_blocked = [&](Point p) { return space().locate(p).kind == Location::Kind::outside; };
  QueryStatus status = QueryStatus::blocked;
  if (!is_blocked(from) && !is_blocked(to))
    status = search.find(from, to) == SearchStatus::found ? QueryStatus::found : status_of_none(from, to);
  answers.status[i] = static_cast<std::uint8_t>(status);
  answers.length[i] = status == QueryStatus::found  ? Length(search.points()).value()
                      : status == QueryStatus::none ? kInfinity
                                                    : kNoNumber;
  if (path && status == QueryStatus::found) path->assign(search.points().begin(), search.points().end());
}

std::vector<double> Asker::distances(std::span<const Point> starts, std::span<const Point> goals, unsigned threads,
                                     const std::function<bool()>& is_over) const {
  std::vector<Point> ends(starts.begin(), starts.end());
  ends.insert(ends.end(), goals.begin(), goals.end());
  const auto other = knowing(ends);
  const Asker& asked = other ? *other : *this;
  std::vector<double> lengths(starts.size() * goals.size(), kNoNumber);
  each_in_parallel(goals.empty() ? 0 : starts.size(), crew(threads, is_over), [&] {
    return [&, loan = std::make_shared<Loan>(asked)](std::size_t row) {
      asked.measure(loan->search(), starts[row], goals, &lengths[row * goals.size()]);
    };
  });
  return lengths;
}

void Asker::measure(PolyanyaSearch& search, Point from, std::span<const Point> goals, double* lengths) const {
  const auto is_blocked = [&](Point p) { return space().locate(p).kind == Location::Kind::outside; };
  if (is_blocked(from)) return;
  const auto paths = search.find_each(from, goals);
  for (std::size_t i = 0; i < goals.size(); ++i) {
    if (paths[i])
      lengths[i] = paths[i]->length.value();
    else if (!is_blocked(goals[i]) && status_of_none(from, goals[i]) == QueryStatus::none)
      lengths[i] = kInfinity;
  }
}

Answers Asker::find_many(std::span<const Ends> queries, bool with_paths, unsigned threads,
                         const std::function<bool()>& is_over) const {
  const std::size_t n = queries.size(), blocks = (n + kBlock - 1) / kBlock;
  Answers answers;
  answers.status.assign(n, static_cast<std::uint8_t>(QueryStatus::unproven));
  answers.length.assign(n, kNoNumber);
  std::vector<std::vector<Point>> paths(with_paths ? n : 0);
  each_in_parallel(blocks, crew(threads, is_over), [&] {
    return [&, loan = std::make_shared<Loan>(*this)](std::size_t block) {
      for (std::size_t i = block * kBlock; i < std::min(n, (block + 1) * kBlock); ++i)
        answer(loan->search(), queries[i], i, answers, with_paths ? &paths[i] : nullptr);
    };
  });
  if (!with_paths) return answers;
  answers.offsets.assign(1, 0);
  for (const std::vector<Point>& path : paths) {
    answers.points.insert(answers.points.end(), path.begin(), path.end());
    answers.offsets.push_back(static_cast<std::int64_t>(answers.points.size()));
  }
  return answers;
}

}  // namespace taut::python
