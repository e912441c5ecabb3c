#include <numeric>
#include <string_view>

#include <taut/geometry/errors.h>
#include <taut/geometry/lattice_integers.h>
#include <taut/geometry/text.h>
#include <taut/io/worlds/write_world.h>

namespace taut {

namespace {

class Writer {
 public:
  explicit Writer(const World& world) : integers_(world) {}

  void line(std::string_view word, const Ring& points) {
    out_ += word;
    for (const Point p : points) {
      const auto place = integers_.place(p).value();
      append(place[0]);
      append(place[1]);
    }
    out_ += '\n';
  }

  void rings(std::string_view word, const std::vector<Area>& areas) {
    for (const Area& area : areas) {
      line(word, area.polygon.outer);
      for (const Ring& hole : area.polygon.holes) line("hole", hole);
    }
  }

  // As written, for nothing but to be read: they lie on finer lattices, too.
  void end(std::string_view word, const Ring& points) {
    out_ += word;
    for (const Point p : points) {
      taut::append(out_ += ' ', p.x);
      taut::append(out_ += ' ', p.y);
    }
    out_ += '\n';
  }

  void unit() {
    const NumberLattice& lattice = integers_.lattice();
    out_ += lattice.exponent == 0 ? "unit 1\n" : "unit 1/" + power(lattice.base, lattice.exponent) + "\n";
  }

  std::string out_ = "taut integers 1\n";

 private:
  void append(std::int64_t n) {
    out_ += ' ';
    out_ += std::to_string(n);
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

void check(const World& world) {
  for (const Wall& wall : world.walls())
    if (wall.thickness > 0) throw InputError(world.source(), 0, "integers cannot hold walls with a thickness");
}

}  // namespace

std::string write_integers(const World& world) {
  check(world);
  Writer writer(world);
  writer.unit();
  writer.out_ += world.boundary() == Boundary::walled  ? "boundary walled\n"
                 : world.boundary() == Boundary::limit ? "boundary limit\n"
                                                       : "boundary open\n";
  writer.rings("area", world.areas());
  writer.rings("solid", world.solids());
  for (const Wall& wall : world.walls()) writer.line("wall", {wall.a, wall.b});
  if (world.start()) writer.end("start", {*world.start()});
  if (world.goal().point) writer.end("goal", {*world.goal().point});
  Ring room;
  for (const Box& box : world.goal().room) room.insert(room.end(), {box.min, box.max});
  if (!room.empty()) writer.end("goal", room);
  return std::move(writer.out_);
}

}  // namespace taut
