// The explorer of `prove` and `score`: looks where looking most likely cuts, or finds, a shorter plan. Private.
#pragma once

#include <taut/robots/micromouse/detail/belief.h>
#include <taut/robots/micromouse/mapping_robot.h>

namespace taut::micromouse::detail {

enum class ScoutGoal { proof, score };

/// The constants of the policy: chosen on generated mazes and on competition mazes (bench/micromouse_bench.cpp).
struct ScoutTuning {
  int samples = 48;
  double gain_weight = 1;   ///< a plan counts 1 + this * the steps it would save
  double reach_look = 10;   ///< before the goal: steps that seeing all relevant walls is worth
  double side_looks = 0.4;  ///< what looks on the way count, again for each step after them
  double patience = 0.3;    ///< added to the steps to a look before what it shows is divided by them
  double leisure = 3;       ///< steps a cell of width and height after which the goal is sought alone
  double foresight = 2;     ///< what a look brings that is not seen at once: it tells where to look next
  int tour = 4;             ///< `prove`, after the goal: looks planned as one tour; 0: each for itself
};

class Scout final : public MappingRobot {
 public:
  Scout(const Task& task, ScoutGoal goal, std::uint64_t seed = 1, const ScoutTuning& tuning = {});

 private:
  Action explore() override;

  struct Plans {
    WallBoard weights;           ///< of the walls that plans shorter than the known one need; 1 in all, or 0
    double gain = 0;             ///< steps of run 2 that knowing all would save: mean over the samples
    std::vector<float> to_goal;  ///< before the goal: mean steps to it, by cell
  };
  struct Look {
    std::vector<Action> way;  ///< to it, the last action first
    double value = 0;         ///< after the goal: weight a step
  };
  /// The way to the next look, the last action first; nothing: run 1 ends here.
  std::optional<std::vector<Action>> decide();
  Plans sample_plans(std::optional<int> hi);
  std::vector<float> steps_to_goal() const;
  /// The goal has to be reached at all: after some time it is all that is sought, as a flood fill does.
  bool hurried() const;
  std::optional<Look> next_look(const Plans& plans) const;
  std::optional<Look> best_look(const Outlook& outlook, const Plans& plans) const;

  ScoutGoal goal_;
  ScoutTuning tuning_;
  Belief belief_;
  std::vector<Action> way_;  ///< to the look decided on
  int idle_ = 0;             ///< steps since the last news
};

}  // namespace taut::micromouse::detail
