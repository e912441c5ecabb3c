#include "support/geos_opinion.h"

#include <geos_c.h>

#include <memory>
#include <stdexcept>

namespace taut::test {

namespace {

class Geos {
 public:
  Geos() : context_(GEOS_init_r()) {}
  ~Geos() { GEOS_finish_r(context_); }
  Geos(const Geos&) = delete;
  Geos& operator=(const Geos&) = delete;

  struct Drop {
    GEOSContextHandle_t context;
    void operator()(GEOSGeometry* g) const { GEOSGeom_destroy_r(context, g); }
  };
  using Geometry = std::unique_ptr<GEOSGeometry, Drop>;

  Geometry nothing() const { return own(GEOSGeom_createEmptyPolygon_r(context_)); }

  Geometry valid(const Ring& ring) const {
    GEOSGeometry* outline = GEOSGeom_createLinearRing_r(context_, points(ring));
    const Geometry raw = own(GEOSGeom_createPolygon_r(context_, outline, nullptr, 0));
    return own(GEOSMakeValid_r(context_, raw.get()));
  }

  // The faces between its lines around which a ring winds an odd number of times.
  Geometry inside(const Ring& ring) const {
    const Geometry line = own(GEOSGeom_createLineString_r(context_, points(ring)));
    const Geometry noded = own(GEOSUnaryUnion_r(context_, line.get()));
    const GEOSGeometry* lines[] = {noded.get()};
    const Geometry faces = own(GEOSPolygonize_r(context_, lines, 1));
    Geometry result = nothing();
    for (int i = 0; i < GEOSGetNumGeometries_r(context_, faces.get()); ++i) {
      const GEOSGeometry* face = GEOSGetGeometryN_r(context_, faces.get(), i);
      const Geometry middle = own(GEOSPointOnSurface_r(context_, face));
      Point p;
      GEOSGeomGetX_r(context_, middle.get(), &p.x);
      GEOSGeomGetY_r(context_, middle.get(), &p.y);
      if (is_odd(p, ring)) result = own(GEOSUnion_r(context_, result.get(), face));
    }
    return result;
  }

  template <class Inside>
  Geometry inside(const Polygon& polygon, Inside of) const {
    Geometry result = of(polygon.outer);
    for (const Ring& hole : polygon.holes) result = minus(result, of(hole));
    return result;
  }
  Geometry inside(const Polygon& polygon) const {
    return inside(polygon, [this](const Ring& ring) { return inside(ring); });
  }

  Geometry minus(const Geometry& a, const Geometry& b) const {
    return own(GEOSDifference_r(context_, areas(a).get(), areas(b).get()));
  }
  Geometry either(const Geometry& a, const Geometry& b) const {
    return own(GEOSSymDifference_r(context_, areas(a).get(), areas(b).get()));
  }

  double area(const Geometry& g) const {
    double value = 0;
    if (GEOSArea_r(context_, g.get(), &value) != 1) throw std::runtime_error("GEOS: no area");
    return value;
  }

 private:
  GEOSCoordSequence* points(const Ring& ring) const {
    GEOSCoordSequence* all = GEOSCoordSeq_create_r(context_, static_cast<unsigned>(ring.size() + 1), 2);
    for (unsigned i = 0; i <= ring.size(); ++i) {
      const Point p = ring[i % ring.size()];
      GEOSCoordSeq_setXY_r(context_, all, i, p.x, p.y);
    }
    return all;
  }

  // By a ray to the right, in doubles.
  static bool is_odd(Point p, const Ring& ring) {
    bool odd = false;
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
      const Point a = ring[j], b = ring[i];
      if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) * (b.x - a.x) / (b.y - a.y)) odd = !odd;
    }
    return odd;
  }

  Geometry own(GEOSGeometry* g) const {
    if (!g) throw std::runtime_error("GEOS failed");
    return {g, Drop{context_}};
  }

  // Without the lines and points that make-valid keeps.
  Geometry areas(const Geometry& g) const {
    Geometry result = nothing();
    for (int i = 0; i < GEOSGetNumGeometries_r(context_, g.get()); ++i) {
      const GEOSGeometry* part = GEOSGetGeometryN_r(context_, g.get(), i);
      if (GEOSGeom_getDimensions_r(context_, part) == 2) result = own(GEOSUnion_r(context_, result.get(), part));
    }
    return result;
  }

  GEOSContextHandle_t context_;
};

}  // namespace

double geos_area(const Polygon& polygon) {
  const Geos geos;
  return geos.area(geos.inside(polygon));
}

double geos_valid_area(const Polygon& polygon) {
  const Geos geos;
  return geos.area(geos.inside(polygon, [&](const Ring& ring) { return geos.valid(ring); }));
}

double geos_even_odd_area(const std::vector<Polygon>& polygons) {
  const Geos geos;
  Geos::Geometry result = geos.nothing();
  for (const Polygon& polygon : polygons) {
    result = geos.either(result, geos.inside(polygon.outer));
    for (const Ring& hole : polygon.holes) result = geos.either(result, geos.inside(hole));
  }
  return geos.area(result);
}

bool geos_covers(const Polygon& outer, const Polygon& inner) {
  const Geos geos;
  return geos.area(geos.minus(geos.inside(inner), geos.inside(outer))) < 1e-9;
}

}  // namespace taut::test
