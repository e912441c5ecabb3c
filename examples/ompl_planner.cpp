// ompl_planner MAZE: RRT* of OMPL with taut's exact validity of states and motions, and how far its path is from the shortest.
#include <cstdio>
#include <memory>

#include <ompl/base/MotionValidator.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>

#include <taut/io/worlds/read_world.h>
#include <taut/search/shortest_path.h>

namespace ob = ompl::base;

taut::Point point(const ob::State* state) {
  const auto* at = state->as<ob::RealVectorStateSpace::StateType>();
  return {at->values[0], at->values[1]};
}

/// A motion is valid when its straight leg is, without steps.
class ExactMotions : public ob::MotionValidator {
 public:
  ExactMotions(const ob::SpaceInformationPtr& information, taut::FreeSpace space)
      : MotionValidator(information), space_(std::move(space)) {}

  bool checkMotion(const ob::State* from, const ob::State* to) const override {
    return space_.sees(point(from), point(to));
  }
  bool checkMotion(const ob::State* from, const ob::State* to, std::pair<ob::State*, double>& last) const override {
    if (checkMotion(from, to)) return true;
    last.second = 0;
    if (last.first != nullptr) si_->copyState(last.first, from);
    return false;
  }

 private:
  taut::FreeSpace space_;
};

int main(int argc, char** argv) {
  if (argc != 2) return std::fprintf(stderr, "usage: ompl_planner MAZE\n"), 2;
  const taut::World world = taut::read_world_file(argv[1]);
  const taut::FreeSpace space(world);
  const auto plane = std::make_shared<ob::RealVectorStateSpace>(2);
  const taut::Box box = world.box();
  ob::RealVectorBounds bounds(2);
  bounds.setLow(0, box.min.x), bounds.setHigh(0, box.max.x), bounds.setLow(1, box.min.y), bounds.setHigh(1, box.max.y);
  plane->setBounds(bounds);
  ompl::geometric::SimpleSetup setup(plane);
  setup.setStateValidityChecker(
      [&](const ob::State* s) { return space.locate(point(s)).kind != taut::Location::Kind::outside; });
  setup.getSpaceInformation()->setMotionValidator(std::make_shared<ExactMotions>(setup.getSpaceInformation(), space));
  ob::ScopedState<> start(plane), goal(plane);
  start[0] = world.start()->x, start[1] = world.start()->y, goal[0] = world.goal().point->x,
  goal[1] = world.goal().point->y;
  setup.setStartAndGoalStates(start, goal);
  setup.setPlanner(std::make_shared<ompl::geometric::RRTstar>(setup.getSpaceInformation()));
  const auto shortest = taut::shortest_path(space, *world.start(), world.goal());
  if (!setup.solve(5.0) || !setup.haveExactSolutionPath() || !shortest) return std::puts("none found"), 1;
  const double length = setup.getSolutionPath().length();
  std::printf("RRT* %.6f, the shortest %.6f: %.2f %% longer\n", length, shortest->length.value(),
              100 * (length / shortest->length.value() - 1));
}
