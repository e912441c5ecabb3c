#include <taut/search/prm_request.h>

namespace taut {

namespace {

constexpr double kSecondsWhenNothingIsSaid = 60;

/// A lattice goes on row by row, all over; a forest has one way from place to place.
bool can_be_refined(const PrmPlan& plan) {
  return !plan.exactly && plan.roadmap.sampler != PrmSampler::lattice &&
         plan.roadmap.connection.rule != PrmConnection::Rule::forest;
}

}  // namespace

PrmPlan plan_of(const PrmRequest& request, PrmSampler sampler, std::uint64_t seed, bool is_limited) {
  PrmPlan plan;
  plan.lazy = request.lazy.value_or(false);
  plan.exactly = request.exactly;
  plan.roadmap.sampler = request.sampler.value_or(sampler);
  plan.roadmap.samples = request.samples;
  plan.roadmap.seed = seed;
  plan.roadmap.clearance = request.clearance.value_or(0);
  plan.roadmap.connection.rule = plan.lazy ? PrmConnection::Rule::nearest : PrmConnection::Rule::visible;
  if (request.connection) plan.roadmap.connection = *request.connection;
  plan.refine = can_be_refined(plan) ? 1 : 0;
  if (!is_limited && !request.samples) plan.seconds = kSecondsWhenNothingIsSaid;
  return plan;
}

}  // namespace taut
