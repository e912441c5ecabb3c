#include <taut/roadmaps/prm_samples.h>

#include <algorithm>
#include <cmath>

#include <taut/geometry/expects.h>

namespace taut {

namespace {

PrmLattice lattice_of(const World& world) {
  if (!world.grid()) return {};
  const Box box = world.box();
  const double side = (box.max.x - box.min.x) / world.grid()->width();
  return {{box.min.x + side / 2, box.min.y + side / 2}, side};
}

double spread_of(const FreeSpace& space) {
  const Box box = space.world().box();
  const double area = (box.max.x - box.min.x) * (box.max.y - box.min.y);
  return std::sqrt(area / static_cast<double>(space.constraints().size() + 1)) / 2;
}

std::vector<Point> bends(const Triangulation& tri) {
  std::vector<Point> result;
  for (const Triangulation::Sector& sector : tri.sectors)
    if (sector.reflex) result.push_back(tri.points[sector.vertex]);
  return result;
}

Point foot(Point p, const Constraint& c) {
  const double ux = c.b.x - c.a.x, uy = c.b.y - c.a.y;
  const double t = std::clamp(((p.x - c.a.x) * ux + (p.y - c.a.y) * uy) / (ux * ux + uy * uy), 0.0, 1.0);
  return {c.a.x + t * ux, c.a.y + t * uy};
}

bool is_even(double whole) { return std::floor(whole / 2) * 2 == whole; }

}  // namespace

PrmLatticeWalk::PrmLatticeWalk(const Box& box, const PrmLattice& lattice) : box_(box), lattice_(lattice) {
  TAUT_EXPECTS(lattice.spacing > 0);
  begin_level();
  const double size = std::max(0.0, last_i_ - first_i_ + 1) * std::max(0.0, last_j_ - j_ + 1);
  if (!(size < 4294967296.0)) throw InputError("", 0, "the lattice has too many points in the world: space them wider");
  first_size_ = static_cast<std::size_t>(size);
}

void PrmLatticeWalk::begin_level() {
  const double h = lattice_.spacing;
  first_i_ = std::ceil((box_.min.x - lattice_.origin.x) / h);
  last_i_ = std::floor((box_.max.x - lattice_.origin.x) / h);
  j_ = std::ceil((box_.min.y - lattice_.origin.y) / h);
  last_j_ = std::floor((box_.max.y - lattice_.origin.y) / h);
  i_ = first_i_ - 1;
}

/// To the next point of this level; false at its end.
bool PrmLatticeWalk::advance() {
  if (first_i_ > last_i_) return false;
  if (++i_ > last_i_) {
    i_ = first_i_;
    ++j_;
  }
  return j_ <= last_j_;
}

Point PrmLatticeWalk::next() {
  do {
    while (!advance()) {
      ++level_;
      lattice_.spacing /= 2;
      begin_level();
    }
  } while (level_ > 0 && is_even(i_) && is_even(j_));
  return {lattice_.origin.x + i_ * lattice_.spacing, lattice_.origin.y + j_ * lattice_.spacing};
}

PrmSamples::PrmSamples(const PrmClear& clear, const PrmOptions& options)
    : clear_(clear),
      sampler_(options.sampler),
      draws_(options.seed),
      box_(clear.space().world().box()),
      spread_(options.spread ? *options.spread : spread_of(clear.space())) {
  const FreeSpace& space = clear.space();
  if (sampler_ == PrmSampler::corners) corners_ = bends(space.triangulation());
  if (sampler_ == PrmSampler::sobol) {
    flips_x_ = draws_.below(0xFFFFFFFFu);
    flips_y_ = draws_.below(0xFFFFFFFFu);
  }
  if (sampler_ == PrmSampler::lattice) walk_.emplace(box_, options.lattice.value_or(lattice_of(space.world())));
}

std::optional<PrmSample> PrmSamples::placed(Point p) const {
  const auto at = clear_.place(p);
  return at ? std::optional(PrmSample{p, *at}) : std::nullopt;
}

std::optional<Point> PrmSamples::candidate() {
  switch (sampler_) {
    case PrmSampler::uniform: break;
    case PrmSampler::lattice: return walk_->next();
    case PrmSampler::gaussian: return gaussian();
    case PrmSampler::bridge: return bridge();
    case PrmSampler::medial: return medial();
    case PrmSampler::corners: return corner();
    case PrmSampler::sobol: return sobol();
  }
  return uniform();
}

Point PrmSamples::uniform() {
  const double x = draws_.unit();
  const double y = draws_.unit();
  return in_box(x, y);
}

Point PrmSamples::in_box(double x, double y) const {
  return {box_.min.x + x * (box_.max.x - box_.min.x), box_.min.y + y * (box_.max.y - box_.min.y)};
}

/// By the direction numbers of the first dimension, a bit each, and of the second, the rows of Pascal's triangle, odd
/// or even (Kollig and Keller 2002).
Point PrmSamples::sobol() {
  std::uint32_t x = flips_x_, y = flips_y_, column = 1u << 31, row = 1u << 31;
  for (std::uint32_t n = number_++; n > 0; n >>= 1, column >>= 1, row ^= row >> 1) {
    if (n % 2 == 0) continue;
    x ^= column;
    y ^= row;
  }
  return in_box((x + 0.5) * 0x1p-32, (y + 0.5) * 0x1p-32);
}

/// Nearly normal, without a logarithm or a cosine, which differ between libraries: twelve uniform draws have variance
/// 1.
double PrmSamples::normal() {
  double sum = -6;
  for (int i = 0; i < 12; ++i) sum += draws_.unit();
  return sum;
}

Point PrmSamples::near(Point p) {
  const double dx = normal();
  const double dy = normal();
  return {p.x + spread_ * dx, p.y + spread_ * dy};
}

std::optional<Point> PrmSamples::gaussian() {
  const Point p = uniform();
  const Point q = near(p);
  return clear_.point(p) && !(clear_.point(q) && clear_.leg(p, q)) ? std::optional(p) : std::nullopt;
}

std::optional<Point> PrmSamples::bridge() {
  const Point p = uniform();
  const Point q = near(p);
  const Point mirrored{p.x - (q.x - p.x), p.y - (q.y - p.y)};
  if (!clear_.point(p)) return std::nullopt;
  for (const Point end : {q, mirrored})
    if (clear_.point(end) && clear_.leg(p, end)) return std::nullopt;
  return p;
}

std::optional<Point> PrmSamples::medial() {
  const FreeSpace& space = clear_.space();
  const Point p = uniform();
  if (space.locate(p).kind == Location::Kind::outside) return std::nullopt;
  const Clearance nearest = space.clearance(p);
  if (nearest.constraint == kNone || nearest.distance == 0) return p;
  const Point from = foot(p, space.constraints()[nearest.constraint]);
  const auto away = [&](double t) -> Point { return {p.x + t * (p.x - from.x), p.y + t * (p.y - from.y)}; };
  // The discs grow, each in the next: as long as one is empty its centre is free and joined to p.
  const auto is_empty = [&](double t) { return !is_any_nearer(away(t), nearest.distance * (1 + t) * (1 - 1e-9)); };
  double low = 0, high = 1;
  for (; is_empty(high) && high < 1e9; high *= 2) low = high;
  for (int i = 0; i < 20; ++i) {
    const double middle = (low + high) / 2;
    (is_empty(middle) ? low : high) = middle;
  }
  return away(low);
}

/// Rounded, in operations that are the same everywhere.
bool PrmSamples::is_any_nearer(Point p, double distance) const {
  bool is_any = false;
  clear_.near({p, p}, distance, [&](std::uint32_t i) {
    const Point q = foot(p, clear_.space().constraints()[i]);
    is_any = is_any || (p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y) < distance * distance;
  });
  return is_any;
}

Point PrmSamples::corner() {
  near_corner_ = !near_corner_;
  if (near_corner_ || corners_.empty()) return uniform();
  const std::uint32_t chosen = draws_.below(static_cast<std::uint32_t>(corners_.size()));
  return near(corners_[chosen]);
}

}  // namespace taut
