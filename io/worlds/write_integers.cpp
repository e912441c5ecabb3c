#include <algorithm>
#include <numeric>
#include <string_view>
#include <tuple>
#include <utility>

#include <taut/geometry/errors.h>
#include <taut/geometry/free_space.h>
#include <taut/geometry/lattice_integers.h>
#include <taut/geometry/plain_world.h>
#include <taut/geometry/text.h>
#include <taut/io/worlds/write_world.h>

namespace taut {

namespace {

class Writer {
 public:
  explicit Writer(const World& world) : integers_(world) {}

  void line(std::string_view word, const Ring& points) {
    out += word;
    for (const Point p : points) {
      const auto place = integers_.place(p).value();
      append(place[0]);
      append(place[1]);
    }
    out += '\n';
  }

  // Those of one line that touch are one.
  void walls(const std::vector<Wall>& all) {
    std::vector<Run> runs;
    for (const Wall& wall : all) {
      Place a = integers_.place(wall.a).value(), b = integers_.place(wall.b).value();
      if (b < a) std::swap(a, b);
      Place d{b[0] - a[0], b[1] - a[1]};
      const std::int64_t common = std::gcd(d[0], d[1]);
      if (common == 0) continue;
      d = {d[0] / common, d[1] / common};
      runs.push_back({d, Wide{d[0]} * a[1] - Wide{d[1]} * a[0], a, b});
    }
    std::sort(runs.begin(), runs.end());
    for (std::size_t i = 0, next = 0; i < runs.size(); i = next) {
      Run run = runs[i];
      for (next = i + 1; next < runs.size() && runs[next].continues(run); ++next) run.b = std::max(run.b, runs[next].b);
      out += "wall";
      for (const std::int64_t n : {run.a[0], run.a[1], run.b[0], run.b[1]}) append(n);
      out += '\n';
    }
  }

  void rings(std::string_view word, const std::vector<Area>& areas) {
    for (const Area& area : areas) {
      line(word, area.polygon.outer);
      for (const Ring& hole : area.polygon.holes) line("hole", hole);
    }
  }

  // As written, for nothing but to be read: they lie on finer lattices, too.
  void end(std::string_view word, const Ring& points) {
    out += word;
    for (const Point p : points) {
      taut::append(out += ' ', p.x);
      taut::append(out += ' ', p.y);
    }
    out += '\n';
  }

  void unit() {
    const NumberLattice& lattice = integers_.lattice();
    out += lattice.exponent == 0 ? "unit 1\n" : "unit 1/" + power(lattice.base, lattice.exponent) + "\n";
  }

  std::string out = "taut integers 1\n";

 private:
  using Place = LatticeIntegers::Place;
  __extension__ using Wide = __int128;
  struct Run {  // a piece of a line, from its lower end
    Place direction;
    Wide offset;
    Place a, b;

    friend bool operator<(const Run& s, const Run& t) {
      return std::tie(s.direction, s.offset, s.a, s.b) < std::tie(t.direction, t.offset, t.a, t.b);
    }
    bool continues(const Run& run) const { return direction == run.direction && offset == run.offset && a <= run.b; }
  };

  void append(std::int64_t n) {
    out += ' ';
    out += std::to_string(n);
  }

  static std::string power(int base, int exponent) {
    if (base == 10) return "1" + std::string(static_cast<std::size_t>(exponent), '0');
    std::string digits = "1";  // the last first
    for (; exponent > 0; --exponent) {
      int carry = 0;
      for (char& digit : digits) {
        const int twice = 2 * (digit - '0') + carry;
        digit = static_cast<char>('0' + twice % 10);
        carry = twice / 10;
      }
      if (carry > 0) digits += '1';
    }
    return {digits.rbegin(), digits.rend()};
  }

  LatticeIntegers integers_;
};

}  // namespace

std::string write_integers(const World& world) {
  return write_plain_integers(is_plain(world) ? world : plain_world(FreeSpace(world)));
}

std::string write_plain_integers(const World& world) {
  Writer writer(world);
  writer.unit();
  writer.out += world.boundary() == Boundary::walled  ? "boundary walled\n"
                : world.boundary() == Boundary::limit ? "boundary limit\n"
                                                      : "boundary open\n";
  writer.rings("area", world.areas());
  writer.rings("solid", world.solids());
  writer.walls(world.walls());
  if (world.start()) writer.end("start", {*world.start()});
  if (world.goal().point) writer.end("goal", {*world.goal().point});
  Ring room;
  for (const Box& box : world.goal().room) room.insert(room.end(), {box.min, box.max});
  if (!room.empty()) writer.end("goal", room);
  return std::move(writer.out);
}

}  // namespace taut
