#include <pugixml.hpp>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include <taut/geometry/mend_rings.h>
#include <taut/io/worlds/detail/formats.h>
#include <taut/io/worlds/detail/shapes.h>
#include <taut/io/worlds/detail/svg_attributes.h>

namespace taut::detail {

namespace {

constexpr int kDeepest = 64;

bool is_one_of(std::string_view name, std::initializer_list<std::string_view> names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// Of `style="fill:none;stroke:#000"`.
std::optional<std::string_view> css(const pugi::xml_node& node, std::string_view name) {
  std::string_view style = node.attribute("style").value();
  while (!style.empty()) {
    const std::string_view part = style.substr(0, style.find(';'));
    style.remove_prefix(std::min(style.size(), part.size() + 1));
    const std::size_t colon = part.find(':');
    if (colon != std::string_view::npos && trimmed(part.substr(0, colon)) == name)
      return trimmed(part.substr(colon + 1));
  }
  return std::nullopt;
}

// There, or in an attribute of that name.
std::string_view property(const pugi::xml_node& node, std::string_view name) {
  return css(node, name).value_or(node.attribute(std::string(name).c_str()).value());
}

class Plan {
 public:
  Plan(std::string_view bytes, const ReadOptions& options) : bytes_(bytes), source_(options.source), shapes_(options) {
    for (std::size_t i = 0; i < bytes.size(); ++i)
      if (bytes[i] == '\n') line_ends_.push_back(static_cast<std::ptrdiff_t>(i));
  }

  WorldParts read(ReadNotes& notes) {
    pugi::xml_document document;
    const auto result = document.load_buffer(bytes_.data(), bytes_.size());
    if (!result)
      SourceLine{source_, line_at(result.offset)}.fail(std::string("not valid XML: ") + result.description());
    const pugi::xml_node root = document.document_element();
    if (local_name(root) != "svg") SourceLine{source_, line_of(root)}.fail("is XML, but no SVG drawing");
    read_children(root, {}, false, 0);
    for (const auto& [name, count] : left_out_)
      notes.remarks.push_back(std::to_string(count) + " <" + name + "> left out");
    WorldParts parts = shapes_.take(Shapes::Alone::two, notes);
    parts.y_down = true;
    return parts;
  }

 private:
  static std::string_view local_name(const pugi::xml_node& node) {
    const std::string_view name = node.name();
    const std::size_t colon = name.find(':');
    return colon == std::string_view::npos ? name : name.substr(colon + 1);
  }

  int line_at(std::ptrdiff_t offset) const {
    return static_cast<int>(std::lower_bound(line_ends_.begin(), line_ends_.end(), offset) - line_ends_.begin()) + 1;
  }
  int line_of(const pugi::xml_node& node) const { return line_at(node.offset_debug()); }

  void read_children(const pugi::xml_node& parent, const SvgTransform& outer, bool unfilled, int depth) {
    if (depth > kDeepest) SourceLine{source_, line_of(parent)}.fail("groups are nested more than 64 deep");
    for (const pugi::xml_node& node : parent.children())
      if (node.type() == pugi::node_element) read_element(node, outer, unfilled, depth);
  }

  void read_element(const pugi::xml_node& node, const SvgTransform& outer, bool unfilled, int depth) {
    const std::string_view name = local_name(node);
    const SourceLine place{source_, line_of(node)};
    // What is not drawn, and what others keep in the file.
    if (is_one_of(name, {"defs", "title", "desc", "metadata", "script", "symbol", "clipPath", "mask", "pattern",
                         "marker", "linearGradient", "radialGradient", "filter", "namedview"}) ||
        property(node, "display") == "none")
      return;
    if (is_one_of(name, {"text", "image", "style"})) {
      ++left_out_[std::string(name)];
      return;
    }
    if (node.attribute("transform-origin") || css(node, "transform") || css(node, "transform-origin"))
      place.fail("of what transforms <" + std::string(name) + "> only an attribute transform=\"...\" is read");
    const SvgTransform transform = outer.after(svg_transform(node.attribute("transform").value(), place));
    const std::string_view fill = property(node, "fill");
    if (!fill.empty()) unfilled = fill == "none" || fill == "transparent";
    if (name == "g" || name == "a") return read_children(node, transform, unfilled, depth + 1);
    read_shape(node, name, transform, unfilled, place);
  }

  void read_shape(const pugi::xml_node& node, std::string_view name, const SvgTransform& transform, bool unfilled,
                  const SourceLine& place) {
    const auto number = [&](const char* key) {
      const pugi::xml_attribute value = node.attribute(key);
      return value ? svg_length(value.value(), place) : 0;
    };
    if (name == "line")
      return add({{{number("x1"), number("y1")}, {number("x2"), number("y2")}}, false}, transform, true, place);
    if (name == "polyline")
      return add({svg_points(node.attribute("points").value(), place), false}, transform, true, place);
    if (name == "polygon")
      return add({svg_points(node.attribute("points").value(), place), true}, transform, unfilled, place);
    if (name == "rect") {
      if (number("rx") > 0 || number("ry") > 0) place.fail("<rect> with round corners is not read");
      const double x = number("x"), y = number("y"), w = number("width"), h = number("height");
      if (!(w > 0) || !(h > 0)) return;
      const SvgTransform corner{1, 0, 0, 1, x, y};
      return add({{{x, y}, {corner({w, 0}).x, y}, corner({w, h}), {x, corner({0, h}).y}}, true}, transform, unfilled,
                 place);
    }
    if (name == "path") return read_path(svg_subpaths(node.attribute("d").value(), place), transform, unfilled, place);
    place.fail("<" + std::string(name) + "> is not read; line, polyline, polygon, rect and path are");
  }

  // Closed pieces of one path are holes in each other.
  void read_path(const std::vector<SvgSubpath>& pieces, const SvgTransform& transform, bool unfilled,
                 const SourceLine& place) {
    std::vector<Area> closed;
    for (const SvgSubpath& piece : pieces) {
      if (piece.closed && !unfilled)
        closed.push_back({{placed(piece.points, transform), {}}, place.line});
      else
        add(piece, transform, true, place);
    }
    if (closed.size() == 1) return shapes_.add_polygon(std::move(closed[0].polygon), place.line);
    for (Area& area : even_odd_areas(closed, source_)) shapes_.add_polygon(std::move(area.polygon), place.line);
  }

  static Ring placed(Ring points, const SvgTransform& transform) {
    std::transform(points.begin(), points.end(), points.begin(), transform);
    return points;
  }

  void add(const SvgSubpath& piece, const SvgTransform& transform, bool as_walls, const SourceLine& place) {
    Ring points = placed(piece.points, transform);
    if (points.size() < 2) return;
    if (!as_walls) return shapes_.add_polygon({std::move(points), {}}, place.line);
    if (piece.closed) points.push_back(points.front());
    shapes_.add_walls(points, 0, place.line);
  }

  std::string_view bytes_;
  std::string source_;
  Shapes shapes_;
  std::vector<std::ptrdiff_t> line_ends_;
  std::map<std::string, int> left_out_;
};

}  // namespace

WorldParts read_svg(std::string_view bytes, const ReadOptions& options, ReadNotes& notes) {
  return Plan(bytes, options).read(notes);
}

}  // namespace taut::detail
