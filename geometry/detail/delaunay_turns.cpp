#include <algorithm>
#include <cstdlib>

#include <taut/geometry/detail/axis_sweep.h>

namespace taut::detail {

namespace {

__extension__ typedef __int128 Int128;  // NOLINT(modernize-use-using): pedantic compilers take no other

struct Offset {
  std::int64_t x, y;
};

template <class Number>
Number lifted(Offset o) {
  const Number x = static_cast<Number>(o.x), y = static_cast<Number>(o.y);
  return x * x + y * y;
}

template <class Number>
Number cross(Offset a, Offset b) {
  return static_cast<Number>(a.x) * static_cast<Number>(b.y) - static_cast<Number>(a.y) * static_cast<Number>(b.x);
}

template <class Number>
bool is_inside(Offset a, Offset b, Offset c) {
  return lifted<Number>(a) * cross<Number>(b, c) + lifted<Number>(b) * cross<Number>(c, a) +
             lifted<Number>(c) * cross<Number>(a, b) >
         0;
}

/// By doubles where they are sure: no term is off by more than a few 2^-52 of `largest` to the fourth.
bool is_inside(Offset a, Offset b, Offset c, std::int64_t largest) {
  const double terms = lifted<double>(a) * cross<double>(b, c) + lifted<double>(b) * cross<double>(c, a) +
                       lifted<double>(c) * cross<double>(a, b);
  const double square = static_cast<double>(largest) * static_cast<double>(largest);
  if (std::abs(terms) > 0x1p-46 * square * square) return terms > 0;
  return is_inside<Int128>(a, b, c);
}

/// Does d lie inside the circle through a, b, c, counter-clockwise?
bool is_inside(LatticePoint a, LatticePoint b, LatticePoint c, LatticePoint d) {
  const auto from = [&](LatticePoint p) { return Offset{std::int64_t{p.x} - d.x, std::int64_t{p.y} - d.y}; };
  const Offset u = from(a), v = from(b), w = from(c);
  std::int64_t largest = 0;
  for (const Offset& o : {u, v, w}) largest = std::max({largest, std::abs(o.x), std::abs(o.y)});
  return largest < (1 << 14) ? is_inside<std::int64_t>(u, v, w) : is_inside(u, v, w, largest);
}

class Turning {
 public:
  Turning(std::vector<RawTriangle>& mesh, std::span<const LatticePoint> points) : mesh_(mesh), points_(points) {}

  bool run(std::size_t limit) {
    std::size_t turned = 0;
    for (std::uint32_t first = 0; first < 3 * mesh_.size(); ++first) {
      if (twin(first) < first) continue;  // looked at from the other side
      open_.push_back(first);
      while (!open_.empty()) {
        const std::uint32_t half = open_.back();
        open_.pop_back();
        if (!is_to_turn(half)) continue;
        if (turned++ == limit) return false;
        turn(half);
      }
    }
    return true;
  }

 private:
  static std::uint32_t ccw(std::uint32_t half) { return half % 3 == 2 ? half - 2 : half + 1; }
  static std::uint32_t cw(std::uint32_t half) { return half % 3 == 0 ? half + 2 : half - 1; }
  std::uint32_t& corner(std::uint32_t half) { return mesh_[half / 3].corners[half % 3]; }
  std::uint32_t& twin(std::uint32_t half) { return mesh_[half / 3].twins[half % 3]; }
  std::uint32_t& edge(std::uint32_t half) { return mesh_[half / 3].edges[half % 3]; }
  LatticePoint place(std::uint32_t half) { return points_[corner(half)]; }

  bool is_to_turn(std::uint32_t half) {
    const std::uint32_t across = twin(half);
    if (across == kNone || edge(half) != kNone) return false;
    return is_inside(place(half), place(ccw(half)), place(cw(half)), place(across));
  }

  /// Puts what lies across `from` along `to`.
  void move(std::uint32_t from, std::uint32_t to) {
    const std::uint32_t across = twin(from);
    twin(to) = across;
    edge(to) = edge(from);
    if (across != kNone) twin(across) = to;
  }

  /// The triangles p a b and q b a become p a q and q b p.
  void turn(std::uint32_t half) {
    const std::uint32_t other = twin(half);
    const std::uint32_t p = corner(half), q = corner(other);
    const std::uint32_t half_a = ccw(half), half_b = cw(half), other_b = ccw(other), other_a = cw(other);
    // Across from corner a of the one lies b p, across from b of the other a q.
    corner(half_b) = q;
    corner(other_a) = p;
    move(other_b, half);
    move(half_a, other);
    twin(half_a) = other_b;
    twin(other_b) = half_a;
    edge(half_a) = edge(other_b) = kNone;
    open_.insert(open_.end(), {half, half_b, other, other_a});
  }

  std::vector<RawTriangle>& mesh_;
  std::span<const LatticePoint> points_;
  std::vector<std::uint32_t> open_;
};

}  // namespace

bool make_delaunay(std::vector<RawTriangle>& mesh, std::span<const LatticePoint> points, std::size_t limit) {
  return Turning(mesh, points).run(limit);
}

}  // namespace taut::detail
