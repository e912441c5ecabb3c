#include <taut/io/pictures/detail/svg_frame.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include <taut/io/pictures/detail/svg_palette.h>
#include <taut/io/pictures/detail/svg_path.h>

namespace taut::detail {

namespace {

constexpr double kNarrowest = 480;  // of a page, so that a legend fits
constexpr double kRow = 26;
constexpr double kTitleSize = 19, kTextSize = 15;
constexpr double kSample = 26, kScale = 120;  // widths of a key's sample
constexpr double kGap = 22;                   // between keys
constexpr std::string_view kDot = " \xC2\xB7 ";

double text_width(std::string_view text, double size) { return 0.55 * size * static_cast<double>(text.size()); }

double sample_width(const SvgKey& key) {
  return key.sample == SvgKey::Sample::ruler ? key.length : key.sample == SvgKey::Sample::scale ? kScale : kSample;
}

double key_width(const SvgKey& key) { return sample_width(key) + 8 + text_width(key.label, kTextSize) + kGap; }

std::string shortened(std::string text, double width, double size) {
  const auto most = static_cast<std::size_t>(width / (0.55 * size));
  if (text.size() <= most) return text;
  std::size_t from = text.size() - most + 1;  // the end of a path says more than its beginning
  while (from < text.size() && (static_cast<unsigned char>(text[from]) & 0xc0) == 0x80) ++from;
  return "\xE2\x80\xA6" + text.substr(from);
}

std::string scale_of(const std::vector<std::string>& colours, double x, double y) {
  std::string out;
  const double width = kScale / static_cast<double>(colours.size());
  for (std::size_t i = 0; i < colours.size(); ++i)
    out += fmt::format(R"(<rect x="{}" y="{}" width="{}" height="12" fill="{}" shape-rendering="crispEdges"/>)",
                       svg_number(x + width * static_cast<double>(i)), svg_number(y - 6), svg_number(width + 0.2),
                       colours[i]);
  return out;
}

std::string sample(const SvgKey& key, double x, double y) {
  switch (key.sample) {
    case SvgKey::Sample::marker: return marker(key.kind, {x + kSample / 2, y}, 7, 100);
    case SvgKey::Sample::patch:
      return fmt::format(R"(<g class="{}"><rect x="{}" y="{}" width="{}" height="14" rx="2"/></g>)", key.kind,
                         svg_number(x + 3), svg_number(y - 7), svg_number(kSample - 6));
    case SvgKey::Sample::disc:
      return fmt::format(R"(<g class="{}"><circle cx="{}" cy="{}" r="9"/></g>)", key.kind, svg_number(x + kSample / 2),
                         svg_number(y));
    case SvgKey::Sample::dot:
      return fmt::format(R"(<g class="{} sample"><path class="line" d="M{} {}h0"/></g>)", key.kind,
                         svg_number(x + kSample / 2), svg_number(y));
    case SvgKey::Sample::scale: return fmt::format(R"(<g class="{}">{}</g>)", key.kind, scale_of(key.colours, x, y));
    case SvgKey::Sample::digit:
      return fmt::format(R"(<text class="{}" x="{}" y="{}">{}</text>)", key.kind, svg_number(x + 9), svg_number(y + 5),
                         xml_text(key.text));
    case SvgKey::Sample::ruler:
      return fmt::format(R"(<path class="ruler" d="M{} {}v8m0-4h{}m0-4v8"/>)", svg_number(x), svg_number(y - 4),
                         svg_number(key.length));
    case SvgKey::Sample::line: break;
  }
  const std::string line = fmt::format("M{} {}h{}", svg_number(x + 1), svg_number(y), svg_number(kSample - 2));
  const std::string casing = key.kind == "path" ? fmt::format(R"(<path class="casing" d="{}"/>)", line) : "";
  return fmt::format(R"(<g class="{0} sample">{1}<path class="line" d="{2}"/></g>)", key.kind, casing, line);
}

std::string words(const char* kind, double x, double y, const std::string& text) {
  return fmt::format("<text class=\"{}\" x=\"{}\" y=\"{}\">{}</text>\n", kind, svg_number(x), svg_number(y),
                     xml_text(text));
}

}  // namespace

std::vector<std::string> wrapped(const std::vector<std::string>& facts, double width) {
  std::vector<std::string> rows(1);
  for (const std::string& fact : facts) {
    if (!rows.back().empty() && text_width(rows.back() + std::string(kDot) + fact, kTextSize) > width)
      rows.emplace_back();
    rows.back() += rows.back().empty() ? fact : std::string(kDot) + fact;
  }
  for (std::string& row : rows) row = shortened(row, width, kTextSize);
  return rows;
}

SvgFrame::SvgFrame(Point size, std::string title, std::vector<std::string> facts, std::vector<SvgKey> keys)
    : title_(std::move(title)), facts_(std::move(facts)), keys_(std::move(keys)) {
  width_ = std::max(size.x + 2 * kMargin, kNarrowest);
  const double left = (width_ - size.x) / 2;
  map_ = {{left, kMargin}, {left + size.x, kMargin + size.y}};
  fact_rows_ = wrapped(facts_, width_ - 2 * kMargin);
  const std::vector<KeySlot> places = key_places();
  const std::size_t rows =
      1 + fact_rows_.size() + (places.empty() ? 0 : static_cast<std::size_t>(places.back().row) + 1);
  height_ = map_.max.y + kMargin + static_cast<double>(rows) * kRow + 10;
}

std::vector<SvgFrame::KeySlot> SvgFrame::key_places() const {
  std::vector<KeySlot> places;
  double x = kMargin;
  int row = 0;
  for (const SvgKey& key : keys_) {
    if (x > kMargin && x + key_width(key) > width_ - kMargin + kGap) {
      x = kMargin;
      ++row;
    }
    places.push_back({x, row});
    x += key_width(key);
  }
  return places;
}

std::string SvgFrame::head(const std::string& kind, const std::string& css) const {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"taut{6}\" role=\"img\" width=\"{0}\" height=\"{1}\" "
      "viewBox=\"0 0 {0} {1}\">\n<title>{2}</title>\n<desc>{3}</desc>\n<style>{4}{5}</style>\n"
      "<rect class=\"page\" width=\"{0}\" height=\"{1}\"/>\n",
      svg_number(width_), svg_number(height_), xml_text(title_), xml_text(fmt::format("{}", fmt::join(facts_, ", "))),
      palette(), css, kind.empty() ? "" : " " + kind);
}

std::string SvgFrame::foot() const {
  double y = map_.max.y + kMargin + 16;
  std::string out =
      "<g class=\"legend\">\n" + words("title", kMargin, y, shortened(title_, width_ - 2 * kMargin, kTitleSize));
  for (const std::string& row : fact_rows_) out += words("facts", kMargin, y += kRow, row);
  y += kRow - 5;
  const std::vector<KeySlot> places = key_places();
  for (std::size_t i = 0; i < keys_.size(); ++i) {
    const double at = y + places[i].row * kRow;
    out += sample(keys_[i], places[i].x, at) +
           words("key", places[i].x + sample_width(keys_[i]) + 8, at + 5, keys_[i].label);
  }
  return out + "</g>\n</svg>\n";
}

SvgKey ruler_key(double pixels_per_unit, const std::string& one, const std::string& many) {
  constexpr double kShortest = 50;
  const double power = std::pow(10, std::floor(std::log10(kShortest / pixels_per_unit)));
  double units = 10 * power;
  for (const double factor : {5.0, 2.0, 1.0})
    if (factor * power * pixels_per_unit >= kShortest) units = factor * power;
  SvgKey key{"ruler", fmt::format("{:.6g} {}", units, units == 1 ? one : many), SvgKey::Sample::ruler};
  key.length = units * pixels_per_unit;
  return key;
}

std::string marker(const std::string& kind, Point at, double radius, double room) {
  const std::string x = svg_number(at.x), y = svg_number(at.y);
  const auto shape = [&](const char* attributes, double r) {
    if (kind == "start") return fmt::format(R"(<circle {} cx="{}" cy="{}" r="{}"/>)", attributes, x, y, svg_number(r));
    const std::string d = svg_number(1.2 * r);
    return fmt::format(R"(<path {0} d="M{1} {2}m0-{3}l{3} {3}l-{3} {3}l-{3}-{3}z"/>)", attributes, x, y, d);
  };
  std::string out = fmt::format("<g class=\"{}\">", kind);
  if (2 * radius <= 0.75 * room) {
    out += shape(R"(class="rim" stroke-width="3")", radius) + shape(R"(stroke="none")", radius);
  } else {
    out += shape(R"(class="rim" stroke-width="5")", radius) +
           shape(R"(fill="none" style="fill:none" stroke-width="2.2")", radius) +
           shape(R"(stroke="none")", std::min(0.3 * radius, 0.4 * room));
  }
  return out + "</g>\n";
}

std::string colour_between(std::span<const std::array<double, 3>> stops, double at) {
  const double place = static_cast<double>(stops.size() - 1) * std::clamp(at, 0.0, 1.0);
  const std::size_t i = std::min(static_cast<std::size_t>(place), stops.size() - 2);
  const auto channel = [&](std::size_t k) {
    return static_cast<int>(std::lround(std::lerp(stops[i][k], stops[i + 1][k], place - static_cast<double>(i))));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", channel(0), channel(1), channel(2));
}

}  // namespace taut::detail
