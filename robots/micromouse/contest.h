// Scores of several explorers in many mazes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <taut/robots/micromouse/explorers.h>
#include <taut/robots/micromouse/trial.h>
#include <taut/robots/micromouse/yardsticks.h>

namespace taut::micromouse {

/// One explorer in one maze.
struct Score {
  int run1 = 0;
  int run2 = 0;
  std::optional<int> thirtieths{};  ///< nothing when it did not finish
  bool proven = false;              ///< by what run 1 saw
  std::string reason{};             ///< why it did not finish

  static double value_of(int thirtieths) { return static_cast<double>(thirtieths) / kExplorationShare; }
};

/// By the rules, with that many steps for both runs; `seed` as of make_explorer().
Score score_of(Explorer explorer, const GridMaze& maze, int max_steps, std::uint64_t seed);

/// Who ran, and where. Some may not have run everywhere yet: rows of scores may be short, and missing.
struct Contest {
  std::vector<Explorer> explorers;
  std::vector<std::string> mazes;      ///< names
  std::vector<Yardsticks> yardsticks;  ///< one a maze
  std::vector<std::string> without_route;
  std::vector<std::vector<Score>> scores;  ///< by explorer, then maze
  std::vector<double> seconds;             ///< CPU, by explorer

  /// Of an explorer, over all mazes that it finished.
  struct Summary {
    std::size_t finished = 0;
    std::size_t failures = 0;
    std::size_t proven = 0;
    double mean = 0;                     ///< 0 when none was finished
    double mean_floor = 0;               ///< of the same mazes
    std::optional<std::size_t> worst{};  ///< index of a maze
    double worst_score = 0;
  };
  Summary summary(std::size_t explorer) const;

  /// Rows of scores by further seeds, of explorers that draw: by explorer, then seed, then maze. Empty when none was
  /// asked for.
  std::vector<std::vector<std::vector<Score>>> more;

  /// How much seeds matter, over the mazes that all of them finished.
  struct Spread {
    std::vector<double> means;  ///< by seed, the first that of `scores`
    double of_means = 0;        ///< their standard deviation
    double of_a_maze = 0;       ///< the standard deviation of one maze's score (root of the mean variance)
  };
  /// Nothing of an explorer with one seed alone, or when no maze was finished by all.
  std::optional<Spread> spread(std::size_t explorer) const;
};

}  // namespace taut::micromouse
