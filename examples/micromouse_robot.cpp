// micromouse_robot MAZE: a robot of one's own in the contest: it keeps a wall to its left, and remembers nothing for run 2.
#include <algorithm>
#include <cstdio>

#include <taut/io/worlds/read_world.h>
#include <taut/robots/micromouse/trial.h>

namespace mouse = taut::micromouse;

class LeftHand : public mouse::Robot {
 public:
  explicit LeftHand(const mouse::Task& task) : task_(task), pose_{task.start, taut::Side::north} {}

  mouse::Action next(const mouse::SensorReading& sight) override {
    if (task_.in_goal(pose_.cell) && !raced_) {
      raced_ = true;
      pose_ = {task_.start, taut::Side::north};
      return mouse::kReset;
    }
    const int rotation = sight.left > 0 ? -90 : sight.front > 0 ? 0 : 90;
    const int cells = std::min(1, sight.at(rotation));
    pose_.heading = mouse::turned(pose_.heading, rotation / 90);
    pose_.cell = mouse::ahead(pose_.cell, pose_.heading, cells);
    return {rotation, cells, false};
  }

 private:
  mouse::Task task_;
  mouse::MousePose pose_;
  bool raced_ = false;
};

int main(int argc, char** argv) {
  if (argc != 2) return std::fprintf(stderr, "usage: micromouse_robot MAZE\n"), 2;
  const taut::World world = taut::read_world_file(argv[1]);
  if (!world.grid()) return std::fprintf(stderr, "%s is no grid maze\n", argv[1]), 3;
  LeftHand robot(mouse::task_of(*world.grid()));
  const mouse::Record record = mouse::run_trial(*world.grid(), robot);
  const auto words = mouse::name(record.status);
  std::printf("%.*s: run 1 took %d steps, run 2 %d\n", int(words.size()), words.data(), record.run1, record.run2);
  if (const auto score = record.score()) std::printf("score %.3f\n", *score);
}
