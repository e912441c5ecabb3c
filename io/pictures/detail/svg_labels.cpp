#include <taut/io/pictures/detail/svg_labels.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <taut/io/pictures/detail/svg_path.h>

namespace taut::detail {

namespace {

constexpr double kLetter = 0.62;   // of a bold letter's width to its size
constexpr double kRise = 0.75;     // of a letter's height to its size
constexpr double kOverWord = 40;   // hiding a word is as bad as hiding so many pixels of line
constexpr double kOutside = 1000;  // nobody reads what is cut off
constexpr double kFarther = 6;     // of the farther places
constexpr std::array<double, 2> kGaps{3, 12};
// Right above comes first: there people look.
constexpr std::array<Point, 8> kSides{{{1, -1}, {1, 1}, {-1, -1}, {-1, 1}, {1, 0}, {-1, 0}, {0, -1}, {0, 1}}};

bool overlap(const Box& a, const Box& b) {
  return a.min.x < b.max.x && b.min.x < a.max.x && a.min.y < b.max.y && b.min.y < a.max.y;
}

// Narrows [from, to] to where a + t d lies between lo and hi.
void clip(double a, double d, double lo, double hi, double& from, double& to) {
  if (d == 0) {
    if (a < lo || a > hi) to = from - 1;
    return;
  }
  const double t1 = (lo - a) / d, t2 = (hi - a) / d;
  from = std::max(from, std::min(t1, t2));
  to = std::min(to, std::max(t1, t2));
}

double length_within(const Segment& s, const Box& box) {
  double from = 0, to = 1;
  const Point d{s.b.x - s.a.x, s.b.y - s.a.y};
  clip(s.a.x, d.x, box.min.x, box.max.x, from, to);
  clip(s.a.y, d.y, box.min.y, box.max.y, from, to);
  return to > from ? (to - from) * std::hypot(d.x, d.y) : 0;
}

// The box of a word on one side of its dot.
Box box_of(const SvgWord& word, Point side, double gap, double radius, double size) {
  const double width = kLetter * size * static_cast<double>(word.text.size()), height = kRise * size;
  const bool is_corner = side.x != 0 && side.y != 0;
  const double away = (radius + gap) * (is_corner ? 0.75 : 1);
  const auto low = [&](double at, double way, double extent) {
    return at + way * away - (way < 0 ? extent : way > 0 ? 0 : extent / 2);
  };
  const Point min{low(word.at.x, side.x, width), low(word.at.y, side.y, height)};
  return {min, {min.x + width, min.y + height}};
}

class Places {
 public:
  Places(std::span<const SvgWord> words, std::span<const Segment> lines, const Box& page, double size)
      : lines_(lines), page_(page), size_(size), radius_(size / 4) {
    for (const SvgWord& word : words)
      taken_.push_back({{word.at.x - radius_, word.at.y - radius_}, {word.at.x + radius_, word.at.y + radius_}});
  }

  double radius() const { return radius_; }

  Box take(const SvgWord& word) {
    const std::vector<Segment> near = lines_near(word);
    Box best;
    double least = INFINITY;
    for (const double gap : kGaps)
      for (const Point side : kSides) {
        const Box box = box_of(word, side, gap, radius_, size_);
        const double cost = badness(box, near) + (gap > kGaps[0] ? kFarther : 0);
        if (cost < least) {
          least = cost;
          best = box;
        }
      }
    taken_.push_back(best);
    return best;
  }

 private:
  std::vector<Segment> lines_near(const SvgWord& word) const {
    const double reach = kLetter * size_ * static_cast<double>(word.text.size()) + 2 * size_ + kGaps[1];
    const Box around{{word.at.x - reach, word.at.y - reach}, {word.at.x + reach, word.at.y + reach}};
    std::vector<Segment> near;
    for (const Segment& s : lines_)
      if (length_within(s, around) > 0) near.push_back(s);
    return near;
  }

  double badness(const Box& box, const std::vector<Segment>& near) const {
    double cost = 0;
    for (const Segment& s : near) cost += length_within(s, box);
    for (const Box& other : taken_) cost += overlap(box, other) ? kOverWord : 0;
    const bool is_inside =
        box.min.x >= page_.min.x && box.min.y >= page_.min.y && box.max.x <= page_.max.x && box.max.y <= page_.max.y;
    return cost + (is_inside ? 0 : kOutside);
  }

  std::span<const Segment> lines_;
  Box page_;
  double size_, radius_;
  std::vector<Box> taken_;
};

}  // namespace

std::string words_beside_dots(std::span<const SvgWord> words, std::span<const Segment> lines, const Box& page,
                              double size) {
  Places places(words, lines, page, size);
  std::string out;
  for (const SvgWord& word : words) {
    const Box box = places.take(word);
    out +=
        fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\"/><text x=\"{}\" y=\"{}\" style=\"font-size:{}px\">{}</text>",
                    svg_number(word.at.x), svg_number(word.at.y), svg_number(places.radius()), svg_number(box.min.x),
                    svg_number(box.max.y), svg_number(size), xml_text(word.text));
  }
  return out;
}

}  // namespace taut::detail
