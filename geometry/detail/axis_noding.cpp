#include <taut/geometry/detail/axis_noding.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>

#include <taut/geometry/detail/radix_sort.h>
#include <taut/geometry/detail/rank_set.h>

namespace taut::detail {

namespace {

/// The different values of numbers, in order, and which each of them is.
struct Ranks {
  std::vector<double> values;
  std::vector<std::uint32_t> of;
};

Ranks ranks(const std::vector<double>& numbers) {
  struct Item {
    std::uint64_t key;
    std::uint32_t index;
  };
  std::vector<Item> order(numbers.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = {sort_key(numbers[i]), i};
  radix_sort(order, 64, [](const Item& item) { return item.key; });
  Ranks result;
  result.of.resize(numbers.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i == 0 || order[i].key != order[i - 1].key) result.values.push_back(numbers[order[i].index]);
    result.of[order[i].index] = static_cast<std::uint32_t>(result.values.size() - 1);
  }
  return result;
}

/// A stretch of a line between two ranks.
struct Piece {
  std::uint32_t line;
  std::uint32_t from;
  std::uint32_t to;
  std::int32_t turn;
  std::uint32_t wall;
};

/// The pieces of one direction by line, then along it, walls that overlap or touch as one; and what they cover
/// together.
class Lines {
 public:
  Lines(std::vector<Piece> pieces, std::size_t line_count, std::size_t rank_count)
      : pieces_(std::move(pieces)), first_(line_count + 1, 0) {
    const int bits = bits_of(rank_count);
    radix_sort(pieces_, bits + bits_of(line_count),
               [bits](const Piece& p) { return std::uint64_t{p.line} << bits | p.from; });
    merge_walls();
    for (const Piece& p : pieces_) ++first_[p.line + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    for (const Piece& p : pieces_) {
      if (!runs_.empty() && runs_.back().line == p.line && p.from <= runs_.back().to)
        runs_.back().to = std::max(runs_.back().to, p.to);
      else
        runs_.push_back({p.line, p.from, p.to, 0, kNone});
    }
  }

  std::span<const Piece> on(std::uint32_t line) const {
    return std::span(pieces_).subspan(first_[line], first_[line + 1] - first_[line]);
  }
  std::size_t count() const { return first_.size() - 1; }
  const std::vector<Piece>& runs() const { return runs_; }  ///< maximal, by line

 private:
  /// A run keeps the lowest of the walls that begin where it does.
  void merge_walls() {
    std::size_t kept = 0, wall = kNone;  // where the last wall is
    for (const Piece& p : pieces_) {
      if (p.turn == 0) {
        if (wall != kNone && pieces_[wall].line == p.line && p.from <= pieces_[wall].to) {
          Piece& run = pieces_[wall];
          run.to = std::max(run.to, p.to);
          if (run.from == p.from) run.wall = std::min(run.wall, p.wall);
          continue;
        }
        wall = kept;
      }
      pieces_[kept++] = p;
    }
    pieces_.resize(kept);
  }

  std::vector<Piece> pieces_;
  std::vector<std::uint32_t> first_;
  std::vector<Piece> runs_;
};

/// Where a horizontal and a vertical run meet.
struct Contact {
  std::uint32_t x;
  std::uint32_t y;
};

/// By y, then x.
std::vector<Contact> contacts(const Lines& horizontal, const Lines& vertical) {
  std::vector<Contact> result;
  std::vector<Piece> starts = vertical.runs(), ends = vertical.runs();
  const int bits = bits_of(horizontal.count());
  radix_sort(starts, bits, [](const Piece& p) { return std::uint64_t{p.from}; });
  radix_sort(ends, bits, [](const Piece& p) { return std::uint64_t{p.to}; });
  RankSet crossed(vertical.count() + 1);
  auto start = starts.begin(), end = ends.begin();
  for (const Piece& run : horizontal.runs()) {
    // Runs of one line touch none of each other: what ends below goes before what starts here comes.
    for (; end != ends.end() && end->to < run.line; ++end) {
      while (start != starts.end() && start->from <= end->to) crossed.insert(start++->line);
      crossed.erase(end->line);
    }
    while (start != starts.end() && start->from <= run.line) crossed.insert(start++->line);
    crossed.each(run.from, run.to, [&](std::uint32_t x) { result.push_back({x, run.line}); });
  }
  return result;
}

/// The contacts of each line of one direction, in order: where along it, and which.
struct Marks {
  std::vector<std::uint32_t> first;
  std::vector<std::uint32_t> at;
  std::vector<std::uint32_t> contact;
};

Marks marks(const std::vector<Contact>& contacts, std::uint32_t Contact::*line, std::uint32_t Contact::*along,
            std::size_t line_count) {
  Marks result{std::vector<std::uint32_t>(line_count + 1, 0), std::vector<std::uint32_t>(contacts.size()),
               std::vector<std::uint32_t>(contacts.size())};
  for (const Contact& c : contacts) ++result.first[c.*line + 1];
  std::partial_sum(result.first.begin(), result.first.end(), result.first.begin());
  std::vector<std::uint32_t> next(result.first.begin(), result.first.end() - 1);
  for (std::uint32_t i = 0; i < contacts.size(); ++i) {
    const std::uint32_t to = next[contacts[i].*line]++;
    result.at[to] = contacts[i].*along;
    result.contact[to] = i;
  }
  return result;
}

/// What lies between two neighbouring marks or ends of pieces on a line.
struct Part {
  std::uint32_t line;
  std::uint32_t from;
  std::uint32_t to;
  std::int32_t turn;
  std::uint32_t wall;
};

/// Splits the pieces of a direction. `passed[contact]` counts the directions of which a piece passes through it.
class Splitter {
 public:
  Splitter(const Lines& lines, const Marks& marks, std::vector<std::uint8_t>& passed)
      : lines_(lines), marks_(marks), passed_(passed) {}

  std::vector<Part> parts() {
    for (std::uint32_t line = 0; line < lines_.count(); ++line)
      if (!lines_.on(line).empty()) split(line);
    return std::move(parts_);
  }

 private:
  struct Stretch {
    std::int32_t turn = 0;
    std::uint32_t wall = kNone;
    bool is_covered = false;
    bool is_passed = false;  // its first point
  };

  void split(std::uint32_t line) {
    const auto first = marks_.first[line], last = marks_.first[line + 1];
    cuts_.assign(marks_.at.begin() + first, marks_.at.begin() + last);
    for (const Piece& p : lines_.on(line)) cuts_.insert(cuts_.end(), {p.from, p.to});
    std::sort(cuts_.begin(), cuts_.end());
    cuts_.erase(std::unique(cuts_.begin(), cuts_.end()), cuts_.end());
    stretches_.assign(cuts_.size(), {});
    for (const Piece& p : lines_.on(line)) add(p);
    for (std::size_t i = 0; i < cuts_.size(); ++i)
      if (const Stretch& s = stretches_[i]; s.is_covered)
        parts_.push_back({line, cuts_[i], cuts_[i + 1], s.turn, s.wall});
    std::size_t i = 0;
    for (auto m = first; m != last; ++m) {
      while (cuts_[i] != marks_.at[m]) ++i;
      passed_[marks_.contact[m]] += stretches_[i].is_passed;
    }
  }

  void add(const Piece& piece) {
    auto i = static_cast<std::size_t>(std::lower_bound(cuts_.begin(), cuts_.end(), piece.from) - cuts_.begin());
    for (bool inside = false; cuts_[i] != piece.to; ++i, inside = true) {
      Stretch& s = stretches_[i];
      s.turn += piece.turn;
      s.wall = std::min(s.wall, piece.wall);
      s.is_covered = true;
      s.is_passed = s.is_passed || inside;
    }
  }

  const Lines& lines_;
  const Marks& marks_;
  std::vector<std::uint8_t>& passed_;
  std::vector<std::uint32_t> cuts_;
  std::vector<Stretch> stretches_;
  std::vector<Part> parts_;
};

/// Both directions as edges, ordered by their ends.
std::vector<Edge> merged(std::vector<Part> horizontal, const std::vector<Part>& vertical, const std::vector<double>& xs,
                         const std::vector<double>& ys) {
  // They come by line, the horizontal ones by y.
  radix_sort(horizontal, bits_of(xs.size()), [](const Part& p) { return std::uint64_t{p.from}; });
  std::vector<Edge> edges;
  edges.reserve(horizontal.size() + vertical.size());
  auto h = horizontal.begin();
  const auto add_horizontal = [&] {
    edges.push_back({{xs[h->from], ys[h->line]}, {xs[h->to], ys[h->line]}, h->turn, h->wall});
    ++h;
  };
  for (const Part& v : vertical) {
    while (h != horizontal.end() && std::pair(h->from, h->line) < std::pair(v.line, v.from)) add_horizontal();
    edges.push_back({{xs[v.line], ys[v.from]}, {xs[v.line], ys[v.to]}, v.turn, v.wall});
  }
  while (h != horizontal.end()) add_horizontal();
  return edges;
}

}  // namespace

Noded node_axis_parallel(const std::vector<Edge>& edges) {
  std::vector<double> x, y;
  x.reserve(2 * edges.size());
  y.reserve(2 * edges.size());
  for (const Edge& e : edges) {
    x.insert(x.end(), {e.a.x, e.b.x});
    y.insert(y.end(), {e.a.y, e.b.y});
  }
  const Ranks xs = ranks(x), ys = ranks(y);
  std::vector<Piece> across, upright;
  for (std::uint32_t i = 0; i < edges.size(); ++i) {
    const Edge& e = edges[i];
    const bool is_across = e.a.y == e.b.y;
    const Ranks &line = is_across ? ys : xs, &along = is_across ? xs : ys;
    const std::uint32_t from = along.of[2 * i], to = along.of[2 * i + 1];
    if (from == to) continue;
    const int turn = from < to ? e.turn : -e.turn;
    (is_across ? across : upright).push_back({line.of[2 * i], std::min(from, to), std::max(from, to), turn, e.wall});
  }
  const Lines horizontal(std::move(across), ys.values.size(), xs.values.size());
  const Lines vertical(std::move(upright), xs.values.size(), ys.values.size());
  const std::vector<Contact> met = contacts(horizontal, vertical);
  std::vector<std::uint8_t> passed(met.size(), 0);
  Noded result;
  std::vector<Part> rows = Splitter(horizontal, marks(met, &Contact::y, &Contact::x, ys.values.size()), passed).parts();
  const std::vector<Part> columns =
      Splitter(vertical, marks(met, &Contact::x, &Contact::y, xs.values.size()), passed).parts();
  result.crossings = static_cast<std::size_t>(std::count(passed.begin(), passed.end(), 2));
  result.edges = merged(std::move(rows), columns, xs.values, ys.values);
  return result;
}

}  // namespace taut::detail
