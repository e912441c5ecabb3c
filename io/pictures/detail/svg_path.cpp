#include <taut/io/pictures/detail/svg_path.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace taut::detail {

namespace {

constexpr double kFarthest = 1e6;

// Of `ticks` by 10^places: `-1.5`, `.25`, `3`.
void append_decimal(std::string& out, std::int64_t ticks, int places) {
  std::array<char, 24> digits;
  const auto magnitude = static_cast<std::uint64_t>(ticks < 0 ? -ticks : ticks);
  const char* end = std::to_chars(digits.data(), digits.data() + digits.size(), magnitude).ptr;
  std::string_view all(digits.data(), static_cast<std::size_t>(end - digits.data()));
  std::string padded;
  if (all.size() < static_cast<std::size_t>(places)) {
    padded = std::string(static_cast<std::size_t>(places) - all.size(), '0').append(all);
    all = padded;
  }
  std::string_view whole = all.substr(0, all.size() - static_cast<std::size_t>(places));
  std::string_view fraction = all.substr(whole.size());
  while (!fraction.empty() && fraction.back() == '0') fraction.remove_suffix(1);
  if (ticks < 0) out += '-';
  out += whole;
  if (!fraction.empty()) (out += '.') += fraction;
  if (whole.empty() && fraction.empty()) out += '0';
}

// The length of the UTF-8 sequence at the front of `text`, 0 when there is none.
std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  const std::size_t length = lead < 0x80                   ? 1
                             : lead >= 0xc2 && lead < 0xe0 ? 2
                             : lead >= 0xe0 && lead < 0xf0 ? 3
                             : lead >= 0xf0 && lead < 0xf5 ? 4
                                                           : 0;
  if (length == 0 || length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xc0) != 0x80) return 0;
  const bool overlong = (lead == 0xe0 && byte(1) < 0xa0) || (lead == 0xf0 && byte(1) < 0x90);
  const bool surrogate_or_beyond = (lead == 0xed && byte(1) >= 0xa0) || (lead == 0xf4 && byte(1) >= 0x90);
  return overlong || surrogate_or_beyond ? 0 : length;
}

}  // namespace

SvgScale::SvgScale(const Box& box, Point top_left, double extent, double pixels, int decimals, bool y_down)
    : origin_{box.min.x, y_down ? box.min.y : box.max.y},
      top_left_(top_left),
      down_(y_down ? 1 : -1),
      extent_(extent),
      pixels_(pixels),
      decimals_(decimals),
      ticks_(std::pow(10, decimals)) {}

Point SvgScale::pixel(Point p) const {
  const auto near = [](double v) { return std::clamp(v, -kFarthest, kFarthest); };
  return {near(top_left_.x + length(p.x - origin_.x)), near(top_left_.y + length(down_ * (p.y - origin_.y)))};
}

SvgScale::Dot SvgScale::dot(Point p) const {
  const Point at = pixel(p);
  return {std::llround(at.x * ticks_), std::llround(at.y * ticks_)};
}

void SvgPath::number(std::int64_t ticks, bool first) {
  if (!first && ticks >= 0) text_ += ' ';
  append_decimal(text_, ticks, scale_.decimals());
}

void SvgPath::move(SvgScale::Dot to) {
  text_ += begun_ ? 'm' : 'M';
  number(to.x - (begun_ ? at_.x : 0), true);
  number(to.y - (begun_ ? at_.y : 0), false);
  begun_ = true;
  at_ = to;
}

void SvgPath::line(SvgScale::Dot to) {
  if (to.y == at_.y) {
    text_ += 'h';
    number(to.x - at_.x, true);
  } else if (to.x == at_.x) {
    text_ += 'v';
    number(to.y - at_.y, true);
  } else {
    text_ += 'l';
    number(to.x - at_.x, true);
    number(to.y - at_.y, false);
  }
  at_ = to;
}

void SvgPath::segment(const Segment& s) {
  const SvgScale::Dot a = scale_.dot(s.a), b = scale_.dot(s.b);
  if (!begun_ || a != at_) move(a);
  line(b);
}

void SvgPath::chain(const Ring& points) {
  if (points.empty()) return;
  move(scale_.dot(points.front()));
  const std::size_t length = text_.size();
  for (const Point& p : points)
    if (const SvgScale::Dot to = scale_.dot(p); to != at_) line(to);
  if (text_.size() == length) line(at_);
}

void SvgPath::bend(SvgScale::Dot control, SvgScale::Dot to) {
  text_ += 'q';
  number(control.x - at_.x, true);
  number(control.y - at_.y, false);
  number(to.x - at_.x, false);
  number(to.y - at_.y, false);
  at_ = to;
}

void SvgPath::chain(const std::vector<Bezier>& curves) {
  for (const Bezier& c : curves) {
    const SvgScale::Dot from = scale_.dot(c.from), control = scale_.dot(c.control), to = scale_.dot(c.to);
    if (!begun_ || from != at_) move(from);
    if (to == from) continue;
    // A dot to either side comes from rounding.
    const auto far = [](std::int64_t v) { return v < -2 || v > 2; };
    if (far(2 * control.x - from.x - to.x) || far(2 * control.y - from.y - to.y))
      bend(control, to);
    else
      line(to);
  }
}

void SvgPath::arc(Point from, Point to, double radius, bool counter_clockwise) {
  const SvgScale::Dot a = scale_.dot(from), b = scale_.dot(to);
  if (!begun_ || a != at_) move(a);
  if (b == at_) return;
  const std::string r = svg_number(scale_.length(radius));
  text_.append("a").append(r).append(" ").append(r).append(counter_clockwise ? " 0 0 0 " : " 0 0 1 ");
  number(b.x - at_.x, true);
  number(b.y - at_.y, false);
  at_ = b;
}

void SvgPath::ring(const Ring& ring) {
  move(scale_.dot(ring.front()));
  const SvgScale::Dot first = at_;
  for (std::size_t i = 1; i < ring.size(); ++i)
    if (const SvgScale::Dot to = scale_.dot(ring[i]); to != at_) line(to);
  text_ += 'z';
  at_ = first;
}

void SvgPath::polygon(const Polygon& polygon) {
  ring(polygon.outer);
  for (const Ring& hole : polygon.holes) ring(hole);
}

std::string svg_number(double value) {
  std::string out;
  append_decimal(out, std::llround(value * 1000), 3);
  return out;
}

std::string xml_text(const std::string& text) {
  std::string out;
  for (std::string_view rest = text; !rest.empty();) {
    const std::size_t length = utf8_length(rest);
    const char c = rest.front();
    if (length == 0)
      out += "\xEF\xBF\xBD";
    else if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else if (c == '\'')
      out += "&#39;";
    else if (static_cast<unsigned char>(c) >= ' ' && c != 0x7f)
      out += rest.substr(0, length);
    rest.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return out;
}

}  // namespace taut::detail
