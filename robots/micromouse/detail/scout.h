// Our explorer: looks where looking most likely cuts, or finds, a shorter plan. Private.
#pragma once

#include <taut/robots/micromouse/detail/belief.h>
#include <taut/robots/micromouse/mapping_robot.h>
#include <taut/robots/micromouse/steps.h>

namespace taut::micromouse::detail {

enum class ScoutGoal { proof, score };

/// The constants of the policy: chosen on generated mazes and on competition mazes (bench/micromouse_bench.cpp).
struct ScoutTuning {
  int samples = 96;
  double thin = 0.3;       ///< the thinnest samples have this share of the walls expected, the others up to all of them
  double gain_weight = 1;  ///< a plan counts 1 + this * the steps it would save
  double prior_share = 0.4;
  double prior_weight = 15;
  double reach_look = 1.0;   ///< before the goal: steps that seeing one relevant wall is worth
  double side_looks = 0.4;   ///< what looks on the way count, again for each step after them
  double patience = 0.3;     ///< added to the steps to a look before what it shows is divided by them
  double stop_factor = 0.5;  ///< share of the gain that knowing everything would bring, that looking does bring
  double stop_steps = 6;     ///< steps that looking takes at least
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
  std::optional<Action> best_look(const Outlook& outlook, const std::vector<float>* to_goal);

  ScoutGoal goal_;
  ScoutTuning tuning_;
  Belief belief_;
};

}  // namespace taut::micromouse::detail
