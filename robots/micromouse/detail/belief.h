// Mazes that agree with what is known: the robot's idea of what it has not seen. Private.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <taut/geometry/draws.h>
#include <taut/robots/micromouse/wall_map.h>

namespace taut::micromouse::detail {

/// A number for each interior wall.
struct WallBoard {
  std::vector<float> north;  // by cell: its wall to the north
  std::vector<float> east;
};

/// A fixed number of sampled mazes, drawn from what mazes look like given the facts.
///
/// The law is a random field: a maze's weight is a product over posts and cells, each by how many of its four walls
/// stand and how they lie (wall_field.h). So walls come in runs, posts hardly ever stand alone, and corridors are more
/// common than walled-in cells. The samples follow it by Gibbs sampling: update() sets the new facts in each and draws
/// the unknown walls anew, one at a time, each given all the others. What has not been seen changes little from one
/// step to the next, as only a few rounds are drawn. Then unknown walls between separate parts are taken down, in
/// random order, until each sample is one piece: mazes are connected. Deterministic: the draws depend on the seed and
/// the facts alone. An update costs O(samples * (kRounds * unknown walls + cells)).
class Belief {
 public:
  Belief(const Task& task, int samples, std::uint64_t seed);

  void update(const WallMap& map);

  int samples() const { return static_cast<int>(samples_.size()); }
  /// What maze `sample` looks like, known walls included.
  const Passages& world(int sample) const { return samples_[static_cast<std::size_t>(sample)].open; }
  /// The same with each unknown wall that stands taken down with probability `share`.
  void thinned(int sample, double share, Passages& into);
  /// In which share of the samples each unknown wall is open (0 for known ones).
  WallBoard open_share() const;

 private:
  static constexpr int kFirstRounds = 30, kRounds = 3;
  static constexpr std::size_t kMostDraws = 8192;  // a sample and update, after the first one

  /// A wall and its factors: the posts at its ends, the cells at its sides, and which of their four arms or sides it
  /// is.
  struct Place {
    std::array<std::uint32_t, 2> post{}, cell{};
    std::array<std::uint8_t, 2> arm{}, side{};
  };
  struct Sample {
    Passages open;
    std::vector<std::uint8_t> posts, cells;  // which arms, which sides stand; in Side's order, as bits
  };

  void set(Sample& sample, std::size_t wall, bool stands) const;
  bool stands(const Sample& sample, std::size_t wall) const;
  void take_over(const WallMap& map, Sample& sample) const;
  void draw(Sample& sample, std::size_t wall);
  void connect(Sample& sample);
  std::uint32_t root(std::uint32_t cell);

  std::size_t cells_;
  std::vector<Place> places_;    // by wall: cell i's to the north is i, to the east cells_ + i
  std::vector<bool> at_border_;  // posts
  std::array<double, 16> post_weight_{}, cell_weight_{};
  double wall_weight_, border_arm_weight_;
  std::vector<Sample> samples_;
  std::vector<std::size_t> unknown_;  // walls, shuffled
  std::vector<std::uint32_t> parent_;
  taut::Draws draws_;
  bool fresh_ = true;
};

/// What a look is worth: from every cell in each direction, the expected weight of the unknown walls that come into
/// sight.
class Outlook {
 public:
  Outlook(const WallMap& map, const WallBoard& weights, const WallBoard& open);
  /// From a cell in one direction.
  float ray(std::size_t cell, Side side) const { return rays_[static_cast<std::size_t>(side)][cell]; }
  /// From a pose: all but what lies behind.
  float at(std::size_t cell, Side heading) const {
    return ray(cell, turned(heading, -1)) + ray(cell, heading) + ray(cell, turned(heading, 1));
  }

 private:
  std::array<std::vector<float>, 4> rays_;
};

}  // namespace taut::micromouse::detail
