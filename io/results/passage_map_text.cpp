#include <taut/io/results/passage_map_text.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <taut/io/results/json.h>

namespace taut {

std::string passage_map_geojson(const std::vector<PassageFace>& faces, const Gates& gates) {
  Json features = Json::array();
  for (const PassageFace& face : faces) {
    Json ring = Json::array();
    for (const Point p : face.outline) ring.push_back(p);
    ring.push_back(face.outline.front());
    Json properties{{"radius", face.radius}};
    if (face.gate != kNone) properties["gate"] = gates.name(face.gate);
    features.push_back({{"type", "Feature"},
                        {"properties", properties},
                        {"geometry", {{"type", "Polygon"}, {"coordinates", Json::array({ring})}}}});
  }
  return json_text({{"type", "FeatureCollection"}, {"features", features}});
}

std::string passage_raster_csv(const PassageRaster& raster) {
  std::string text;
  for (std::size_t i = 0; i < raster.radii.size(); ++i)
    text += fmt::format("{}{}", raster.radii[i], (i + 1) % raster.columns == 0 ? '\n' : ',');
  return text;
}

std::string passage_raster_pgm(const PassageRaster& raster) {
  double most = 0;
  for (const double r : raster.radii)
    if (std::isfinite(r)) most = std::max(most, r);
  std::string bytes = fmt::format("P5\n# radius {} a step\n{} {}\n255\n", most / 255, raster.columns, raster.rows);
  for (const double r : raster.radii) {
    const double step = std::isfinite(r) && most > 0 ? std::floor(255 * r / most) : r > 0 ? 255 : 0;
    // What a disc gets to is not black.
    bytes += static_cast<char>(static_cast<unsigned char>(r > 0 ? std::max(1.0, step) : 0));
  }
  return bytes;
}

}  // namespace taut
