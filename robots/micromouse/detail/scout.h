// Our explorer: looks where looking most likely cuts, or finds, a shorter plan. Private.
#pragma once

#include <taut/robots/micromouse/detail/belief.h>
#include <taut/robots/micromouse/mapping_robot.h>
#include <taut/robots/micromouse/steps.h>

namespace taut::micromouse::detail {

enum class ScoutGoal { proof, score };

/// The constants of the policy: chosen on generated mazes and on competition mazes (bench/micromouse_bench.cpp).
struct ScoutTuning {
  int samples = 200;
  double prior_share = 0.4;  ///< of the interior walls that stand, and how many seen walls that counts for
  double prior_weight = 30;
  // Mazes are made to have routes: along plans fewer walls stand than anywhere.
  double reach_density = 0.6;  ///< before the goal: plans are sampled at this part of the density believed in
  double look_density = 0.7;   ///< afterwards
  double reach_look = 10;      ///< before the goal: steps that seeing every relevant wall is worth
  double patience = 0.5;       ///< added to the steps to a look before its worth is divided by them
  double look_power = 0.5;     ///< of what a look shows: below 1 near looks are preferred
  // Stops when the mean gain is small and no gain can be large: sampled gains are too small where mazes have long loops.
  double stop_gain = 0.15;
  int stop_gap = 6;  ///< of the optima with unknown walls closed and open
};

class Scout final : public MappingRobot {
 public:
  Scout(const Task& task, ScoutGoal goal, const ScoutTuning& tuning = {});

 private:
  Action explore() override;

  struct Plans {
    WallWeights weights;         ///< of the walls that plans shorter than the known one need
    double gain = 0;             ///< mean over the samples, at the density believed in
    double total = 0;            ///< sum of all weights
    std::vector<float> to_goal;  ///< mean steps to the goal, by cell
  };
  Plans sample_plans(std::optional<int> hi, double density);
  Action approach(const Plans& plans, const Outlook& outlook);
  std::optional<Action> best_look(const Outlook& outlook, const std::vector<float>* to_goal);

  ScoutGoal goal_;
  ScoutTuning tuning_;
  Belief belief_;
};

}  // namespace taut::micromouse::detail
