#include <taut/io/pictures/svg_sheet.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>

#include <taut/io/pictures/detail/svg_path.h>

namespace taut {

namespace {

constexpr double kWidest = 1920;

/// The value of the first attribute of that name.
double attribute(const std::string& picture, std::string_view name) {
  const std::size_t at = picture.find(name);
  return at == std::string::npos ? 0 : std::strtod(picture.c_str() + at + name.size(), nullptr);
}

}  // namespace

std::string svg_sheet(std::span<const std::string> pictures, std::size_t columns) {
  double width = 0, height = 0;
  for (const std::string& picture : pictures) {
    width = std::max(width, attribute(picture, " width=\""));
    height = std::max(height, attribute(picture, " height=\""));
  }
  columns = std::min(columns, std::max<std::size_t>(1, pictures.size()));
  const std::size_t rows = (pictures.size() + columns - 1) / columns;
  const double page_width = width * static_cast<double>(columns), page_height = height * static_cast<double>(rows);
  const double scale = std::min(1.0, page_width > 0 ? kWidest / page_width : 1.0);
  std::string out =
      fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}\" height=\"{}\" viewBox=\"0 0 {} {}\">\n",
                  detail::svg_number(page_width * scale), detail::svg_number(page_height * scale),
                  detail::svg_number(page_width), detail::svg_number(page_height));
  // The pictures' own style colours the page.
  out += "<g class=\"taut\"><rect class=\"page\" width=\"100%\" height=\"100%\"/></g>\n";
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const std::string x = detail::svg_number(static_cast<double>(i % columns) * width);
    const std::string y = detail::svg_number(static_cast<double>(i / columns) * height);
    out += fmt::format("<svg x=\"{}\" y=\"{}\" {}", x, y, std::string_view(pictures[i]).substr(sizeof "<svg"));
  }
  return out + "</svg>\n";
}

}  // namespace taut
