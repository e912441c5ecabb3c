#include <taut/robots/micromouse/speed_facts.h>

#include <algorithm>
#include <map>

#include <taut/robots/micromouse/detail/speed_profile.h>

namespace taut::micromouse {

std::size_t turns_of(const SpeedRun& run) {
  return static_cast<std::size_t>(std::count_if(run.drives.begin(), run.drives.end(),
                                                [](const Drive& d) { return d.kind != Drive::Kind::straight; }));
}

double top_speed_of(const SpeedRun& run, const SpeedModel& model) {
  double top = 0;
  for (const Drive& d : run.drives) {
    const auto pieces = detail::pieces_of(model, d);
    if (pieces.empty()) continue;
    std::vector<double> speeds(pieces.size() + 1);
    detail::fill_fastest(pieces, d.speed_in, d.speed_out, speeds);
    for (std::size_t i = 0; i < pieces.size(); ++i)
      top = std::max(top, detail::peak_over(pieces[i], speeds[i], speeds[i + 1]));
  }
  return top;
}

const char* heading_name(Eighth heading) {
  static constexpr const char* kNames[] = {"N", "NE", "E", "SE", "S", "SW", "W", "NW"};
  return kNames[heading & 7];
}

std::vector<Parting> partings(const std::vector<Cell>& fastest, const std::vector<Cell>& shortest) {
  std::map<Cell, std::size_t> place;
  for (std::size_t k = 0; k < shortest.size(); ++k) place.emplace(shortest[k], k);
  std::vector<Parting> all;
  std::size_t f = 0, s = 0;
  while (f + 1 < fastest.size() && s + 1 < shortest.size()) {
    if (fastest[f + 1] == shortest[s + 1]) {
      ++f, ++s;
      continue;
    }
    std::size_t k = f + 1;
    while (k + 1 < fastest.size() && !(place.contains(fastest[k]) && place[fastest[k]] > s)) ++k;
    const auto met = place.find(fastest[k]);
    const std::size_t again = met != place.end() && met->second > s ? met->second : shortest.size() - 1;
    all.push_back({fastest[f], fastest[k], k - f, again - s});
    f = k, s = again;
  }
  return all;
}

}  // namespace taut::micromouse
