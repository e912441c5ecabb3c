#include <taut/search/passage_map.h>

#include <algorithm>
#include <cmath>

#include <taut/geometry/expects.h>

namespace taut {

namespace {

/// Without what is passed forth and back.
Ring without_spikes(const Ring& walk) {
  Ring ring;
  for (const Point p : walk) {
    if (!ring.empty() && ring.back() == p) continue;
    if (ring.size() >= 2 && ring[ring.size() - 2] == p)
      ring.pop_back();
    else
      ring.push_back(p);
  }
  std::size_t first = 0;
  while (ring.size() - first > 2 &&
         (ring.back() == ring[first] || ring[ring.size() - 2] == ring[first] || ring.back() == ring[first + 1])) {
    if (ring.back() == ring[first]) {
      ring.pop_back();
    } else if (ring[ring.size() - 2] == ring[first]) {
      ring.pop_back();
    } else {
      ++first;
    }
  }
  ring.erase(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(first));
  return ring;
}

double radius_between(const PassageIndex& index, const PassagePlace& s, const PassagePlace& g) {
  const auto widest = index.widest(s, g);
  return widest ? widest->radius : 0;
}

}  // namespace

std::vector<PassageFace> passage_map(const PassageIndex& index, Point start) {
  std::vector<PassageFace> faces;
  const PassagePlace place = index.place(start);
  if (place.face == kNone || place.outside) return faces;
  const double room = index.radius_at(place);
  for (const PassageIndex::Reach& reach : index.reach(place)) {
    const bool narrow = reach.gate != kNone && index.gate_radius(reach.gate) < room;
    faces.push_back({without_spikes(index.outline(reach.face)), narrow ? index.gate_radius(reach.gate) : room,
                     narrow ? reach.gate : kNone});
  }
  std::erase_if(faces, [](const PassageFace& face) { return face.outline.size() < 3; });
  std::stable_sort(faces.begin(), faces.end(),
                   [](const PassageFace& a, const PassageFace& b) { return a.radius > b.radius; });
  return faces;
}

PassageRaster passage_raster(const PassageIndex& index, Point start, std::size_t cells) {
  TAUT_EXPECTS(cells > 0);
  const Box box = index.gates().space().world().box();
  const double width = box.max.x - box.min.x, height = box.max.y - box.min.y;
  PassageRaster raster;
  raster.side = std::max(width, height) / static_cast<double>(cells);
  raster.columns = std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(width / raster.side - 1e-9)));
  raster.rows = std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(height / raster.side - 1e-9)));
  raster.min = box.min;
  raster.radii.reserve(raster.columns * raster.rows);
  const PassagePlace from = index.place(start);
  for (std::size_t row = raster.rows; row-- > 0;)
    for (std::size_t column = 0; column < raster.columns; ++column) {
      const Point centre{box.min.x + (static_cast<double>(column) + 0.5) * raster.side,
                         box.min.y + (static_cast<double>(row) + 0.5) * raster.side};
      raster.radii.push_back(radius_between(index, from, index.place(centre)));
    }
  return raster;
}

std::vector<double> passage_matrix(const PassageIndex& index, std::span<const Point> points) {
  std::vector<PassagePlace> places;
  places.reserve(points.size());
  for (const Point p : points) places.push_back(index.place(p));
  const std::size_t n = places.size();
  std::vector<double> radii(n * n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    if (!places[i].outside) radii[i * n + i] = index.radius_at(places[i]);
    for (std::size_t j = i + 1; j < n; ++j)
      radii[i * n + j] = radii[j * n + i] = radius_between(index, places[i], places[j]);
  }
  return radii;
}

}  // namespace taut
