#include <taut/robots/roadblocks/detail/disc_distance.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>

#include <taut/robots/roadblocks/lattice_planner.h>

namespace taut::roadblocks::detail {

namespace {

constexpr double kHalfDiagonal = 0.5 * std::numbers::sqrt2 / kRaster;
constexpr double kCircumscribed = 1.803;                              // more than half the car's diagonal
constexpr double kReach = 1.5 * std::numbers::sqrt2;                  // more than half the car's diagonal, and a step
constexpr double kInscribed = kHalfWidth - 2 * kHalfDiagonal - 1e-3;  // room below it: a disc in the car collides
constexpr float kRoomSeen = 2.8F;                                     // more room is not measured

double distance_to(Cell c, Point p, WallReading reading) {
  const double half = reading == WallReading::squares ? 0.5 : 0;
  const double dx = std::max(std::abs(p.x - c.x) - half, 0.0), dy = std::max(std::abs(p.y - c.y) - half, 0.0);
  return std::sqrt(dx * dx + dy * dy);
}

}  // namespace

Obstacles::Obstacles(const Course& course, RoadblockSet closed, WallReading reading)
    : course_(&course), reading_(reading), closed_(course.walls) {
  room_.assign(closed_.size() * kRaster * kRaster, kRoomSeen);
  for (int y = 1; y <= course.height; ++y)
    for (int x = 1; x <= course.width; ++x)
      if (is_closed({x, y})) lessen_room({x, y});
  *this = with(closed);
}

Obstacles Obstacles::with(RoadblockSet closed) const {
  Obstacles more = *this;
  for (std::size_t i = 0; i < course_->roadblocks.size(); ++i)
    if ((closed >> i) & 1)
      for (const Cell c : course_->roadblocks[i].cells) {
        more.closed_[course_->index(c)] = 1;
        more.lessen_room(c);
      }
  return more;
}

void Obstacles::lessen_room(Cell closed) {
  const int columns = course_->width * kRaster, rows = course_->height * kRaster, reach = 4 * kRaster;
  const int x = raster(closed.x), y = raster(closed.y);
  for (int j = std::max(0, y - reach); j < std::min(rows, y + reach); ++j)
    for (int i = std::max(0, x - reach); i < std::min(columns, x + reach); ++i) {
      float& room =
          room_[static_cast<std::size_t>(j) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(i)];
      const double distance = distance_to(closed, {middle(i), middle(j)}, reading_) - kHalfDiagonal - 1e-4;
      room = std::min(room, static_cast<float>(std::max(0.0, distance)));
    }
}

double Obstacles::room(Point p) const {
  const int i = raster(p.x), j = raster(p.y), columns = course_->width * kRaster;
  if (i < 0 || j < 0 || i >= columns || j >= course_->height * kRaster) return 0;
  return room_[static_cast<std::size_t>(j) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(i)];
}

template <typename Test>
bool Obstacles::none_near(Point p, double reach, Test test) const {
  const int left = std::max(1, static_cast<int>(std::ceil(p.x - reach)));
  const int right = std::min(course_->width, static_cast<int>(std::floor(p.x + reach)));
  const int top = std::max(1, static_cast<int>(std::ceil(p.y - reach)));
  const int bottom = std::min(course_->height, static_cast<int>(std::floor(p.y + reach)));
  for (int y = top; y <= bottom; ++y)
    for (int x = left; x <= right; ++x)
      if (closed_[course_->index({x, y})] && test(Cell{x, y})) return false;
  return true;
}

bool Obstacles::is_clear(const Pose& from, double control, const Pose& to, double slack) const {
  const double space = room({to.x, to.y});
  if (space > kReach) return true;
  if (reading_ == WallReading::points) return is_free(to, slack);
  if (space < kInscribed + slack && is_inside({to.x, to.y})) return false;
  const Step step(from, control);
  return none_near({to.x, to.y}, 2.7, [&](Cell c) { return step.meets(c, reading_, slack); });
}

bool Obstacles::is_inside(Point p) const {
  return p.x >= 0.5 && p.y >= 0.5 && p.x < course_->width + 0.5 && p.y < course_->height + 0.5;
}

bool Obstacles::is_free(const Pose& pose, double slack) const {
  const double space = room({pose.x, pose.y});
  if (space > kCircumscribed + slack) return true;
  if (space < kInscribed + slack && is_inside({pose.x, pose.y})) return false;
  if (reading_ == WallReading::squares)
    return none_near({pose.x, pose.y}, 2.6, [&](Cell cell) { return touches(pose, cell, reading_, slack); });
  const double c = std::cos(pose.heading), s = std::sin(pose.heading);
  return none_near({pose.x, pose.y}, kCircumscribed + slack, [&](Cell cell) {
    const double dx = cell.x - pose.x, dy = cell.y - pose.y;
    return std::abs(c * dx + s * dy) <= kHalfLength + slack && std::abs(c * dy - s * dx) <= kHalfWidth + slack;
  });
}

namespace {

/// Where the disc may be, and between which raster cells it may pass.
class DiscRoom {
 public:
  explicit DiscRoom(const Obstacles& obstacles)
      : columns_(obstacles.course().width * kRaster), rows_(obstacles.course().height * kRaster) {
    free_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    for (int j = 0; j < rows_; ++j)
      for (int i = 0; i < columns_; ++i)
        free_[at(i, j)] = obstacles.room({middle(i), middle(j)}) > kHalfWidth - 2 * kHalfDiagonal - 2e-4;
    // A gate of two centres at most 2 apart (squares: of facing sides) lets no car through, though raster cells in its
    // middle are wider.
    obstacles.each_gate([&](const Box& band) {
      for (int j = std::max(0, raster(band.min.y)); j < std::min(rows_, raster(band.max.y)); ++j)
        for (int i = std::max(0, raster(band.min.x)); i < std::min(columns_, raster(band.max.x)); ++i)
          free_[at(i, j)] = 0;
    });
  }

  bool is_free(int i, int j) const { return i >= 0 && j >= 0 && i < columns_ && j < rows_ && free_[at(i, j)] != 0; }
  std::size_t at(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(i);
  }
  int columns() const { return columns_; }
  int rows() const { return rows_; }

 private:
  int columns_, rows_;
  std::vector<std::uint8_t> free_;
};

}  // namespace

DiscDistance::DiscDistance(const Obstacles& obstacles, Point goal) {
  const DiscRoom room(obstacles);
  columns_ = room.columns();
  rows_ = room.rows();
  std::vector<double> length(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_),
                             std::numeric_limits<double>::infinity());
  using Entry = std::tuple<double, int, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const auto reach = [&](int i, int j, double by) {
    if (!room.is_free(i, j) || by >= length[room.at(i, j)]) return;
    length[room.at(i, j)] = by;
    open.emplace(by, i, j);
  };
  const double reach_of_car = std::hypot(kHalfLength, kHalfWidth) + kHalfDiagonal;
  for (int j = raster(goal.y - 2); j <= raster(goal.y + 2); ++j)
    for (int i = raster(goal.x - 2); i <= raster(goal.x + 2); ++i)
      if (std::hypot(middle(i) - goal.x, middle(j) - goal.y) <= reach_of_car) reach(i, j, 0);
  while (!open.empty()) {
    const auto [by, i, j] = open.top();
    open.pop();
    if (by > length[room.at(i, j)]) continue;
    for (int dj = -1; dj <= 1; ++dj)
      for (int di = -1; di <= 1; ++di)
        if (di != 0 || dj != 0) reach(i + di, j + dj, by + (di != 0 && dj != 0 ? std::numbers::sqrt2 : 1.0) / kRaster);
  }
  steps_.reserve(length.size());
  for (const double way : length) steps_.push_back(std::isfinite(way) ? static_cast<int>(way / kForward) : kFar);
}

int DiscDistance::steps_from(Point p) const {
  const int i = raster(p.x), j = raster(p.y);
  if (i < 0 || j < 0 || i >= columns_ || j >= rows_) return kFar;
  return steps_[static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(i)];
}

}  // namespace taut::roadblocks::detail
