#include <taut/cli/mouse/table.h>

#include <fmt/format.h>

#include <taut/cli/messages.h>
#include <taut/cli/mouse/mouse.h>

namespace taut::cli {

namespace {

using micromouse::TrialStatus;

std::string row(const char* what, const std::string& value, const std::string& remark) {
  const std::string line = fmt::format("{:<18}{:>9}  {}", what, value, remark);
  return "  " + line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
}

std::string score_text(double value) { return fmt::format("{:.3f}", value); }

std::string run1_remark(const MouseTrial& t) {
  if (!t.record.goal_at) return "the goal was not reached";
  return fmt::format("{} cells moved, {} of {} cells visited, goal after {}", t.cells_of(1), t.visited(),
                     t.record.task.width * t.record.task.height,
                     count_text(static_cast<std::size_t>(*t.record.goal_at), "step"));
}

std::string run2_remark(const MouseTrial& t) {
  if (t.record.status != TrialStatus::finished) return "";
  const int over = t.record.run2 - t.yardsticks.optimum;
  return fmt::format("{} cells moved, {}", t.cells_of(2),
                     over == 0 ? "optimal" : fmt::format("{} more than needed", over));
}

std::string goal_text(const std::vector<Cell>& goal) {
  std::string out;
  for (std::size_t i = 0; i < goal.size() && i < 4; ++i) out += (i > 0 ? " " : "") + cell_text(goal[i]);
  return goal.size() > 4 ? out + fmt::format(" and {} more", goal.size() - 4) : out;
}

// Of those that looked on after the goal.
std::string insurance_row(const MouseTrial& t) {
  if (!t.insurance || t.insurance->paid == 0) return "";
  const micromouse::Insurance& i = *t.insurance;
  return row("insurance", fmt::format("{:+.3f}", i.balance()),
             fmt::format("{} after the goal cost {:.3f}, run 2 got {} shorter ({:.1f} expected of knowing all)",
                         count_text(static_cast<std::size_t>(i.paid), "step"), i.price(), i.back, i.expected));
}

std::string yardstick_rows(const micromouse::Yardsticks& y) {
  std::string out = row("floor", score_text(y.floor), "of a robot that knows the maze");
  if (y.with_proof)
    out += row(
        "floor with proof", score_text(y.with_proof->score()),
        y.with_proof->exact ? "of one that has to see a proof" : "of one that has to see a proof; it may be higher");
  out += row("benchmark 1", score_text(y.every_cell), "run 1 sees every cell once");
  if (y.walked)
    out += row("benchmark 2", y.random_walkers ? score_text(*y.random_walkers) : "-",
               y.random_walkers ? "mean of ten random walkers" : "not ten of 1000 random walkers finish");
  return out;
}

}  // namespace

std::string mouse_table(const MouseTrial& t, const std::string& source) {
  const micromouse::Record& record = t.record;
  const micromouse::WallMap map = known_after_run1(record);
  std::string out =
      fmt::format("{}: {} x {}, goal {}, {}\n", source, record.task.width, record.task.height,
                  goal_text(record.task.goal), t.explorer.empty() ? "a robot of its own" : "explorer " + t.explorer);
  out += row("run 1", std::to_string(record.run1), run1_remark(t));
  out += row("run 2", std::to_string(record.run2), run2_remark(t));
  out += row("score", record.score() ? score_text(*record.score()) : "-",
             record.score() ? "run 2 + run 1 / 30" : std::string(name(record.status)));
  out += row("optimum", std::to_string(t.yardsticks.optimum), "fewest steps of run 2");
  out += row("proven", t.certificate ? "yes" : "no",
             fmt::format("by what run 1 saw ({} of {} walls)", map.seen(), map.seen() + map.unknown()));
  return out + insurance_row(t) + yardstick_rows(t.yardsticks);
}

}  // namespace taut::cli
