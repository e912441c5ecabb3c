#include <taut/robots/roadblocks/replanning_driver.h>

#include <utility>

namespace taut::roadblocks {

namespace {

class ReplanningDriver : public Driver {
 public:
  explicit ReplanningDriver(Planning planning) : planning_(std::move(planning)) {}

  std::optional<double> next(const ObservedMap& map, const Pose& pose) override {
    if (!attempt_ || map.closed() != closed_) {
      replans_ += attempt_.has_value();
      closed_ = map.closed();
      attempt_ = planning_(pose, closed_);
      at_ = 0;
    }
    if (!attempt_->plan || at_ == attempt_->plan->controls.size()) return std::nullopt;
    return attempt_->plan->controls[at_++];
  }

  int replans() const override { return replans_; }
  bool gave_up() const override { return attempt_ && !attempt_->proven_none; }

 private:
  Planning planning_;
  std::optional<Attempt> attempt_;
  RoadblockSet closed_ = 0;
  std::size_t at_ = 0;
  int replans_ = 0;
};

}  // namespace

std::unique_ptr<Driver> replanning_driver(Planning planning) {
  return std::make_unique<ReplanningDriver>(std::move(planning));
}

}  // namespace taut::roadblocks
