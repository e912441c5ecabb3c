#include <taut/robots/micromouse/free_speed_run.h>

#include <algorithm>
#include <iterator>

#include <taut/robots/micromouse/detail/speed_profile.h>

namespace taut::micromouse {

namespace {

using detail::Piece;

/// Those between two stops, and their pieces.
void drive_fast(std::span<Drive> drives, const SpeedModel& model) {
  std::vector<Piece> pieces;
  for (const Drive& d : drives) std::ranges::copy(detail::pieces_of(model, d), std::back_inserter(pieces));
  if (pieces.empty()) return;
  std::vector<double> speeds(pieces.size() + 1);
  detail::fill_fastest(pieces, 0, 0, speeds);
  std::size_t i = 0;
  for (Drive& d : drives) {
    d.speed_in = speeds[i];
    d.seconds = 0;
    for (const std::size_t end = i + detail::pieces_of(model, d).size(); i < end; ++i)
      d.seconds += detail::seconds_over(pieces[i], speeds[i], speeds[i + 1]);
    d.speed_out = speeds[i];
  }
}

}  // namespace

SpeedRun at_full_speed(const SpeedRun& run, const SpeedModel& model) {
  SpeedRun fast = run;
  const auto is_pivot = [](const Drive& d) { return d.kind == Drive::Kind::pivot; };
  for (auto begin = fast.drives.begin(); begin != fast.drives.end();) {
    const auto end = std::find_if(begin, fast.drives.end(), is_pivot);
    drive_fast({begin, end}, model);
    begin = std::find_if_not(end, fast.drives.end(), is_pivot);
  }
  fast.seconds = 0;
  for (const Drive& d : fast.drives) fast.seconds += d.seconds;
  return fast;
}

}  // namespace taut::micromouse
