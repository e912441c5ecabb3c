#include <taut/io/pictures/bug_svg.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <taut/io/pictures/svg.h>

namespace taut::bug {

namespace {

constexpr double kFilmSeconds = 20;

/// H1, M1, ... those of one place in one label.
std::vector<SvgLabel> labels_of(const Journey& journey) {
  std::vector<SvgLabel> labels;
  const auto add = [&labels](const std::vector<Contact>& contacts, char letter) {
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const std::string text = fmt::format("{}{}", letter, i + 1);
      const auto same = std::ranges::find(labels, contacts[i].at, &SvgLabel::at);
      if (same == labels.end())
        labels.push_back({contacts[i].at, text});
      else
        same->text += " " + text;
    }
  };
  add(journey.hits, 'H');
  add(journey.minima, 'M');
  add(journey.leaves, 'L');
  return labels;
}

std::vector<SvgLabelKey> label_keys(const Journey& journey) {
  std::vector<SvgLabelKey> keys;
  if (!journey.hits.empty()) keys.push_back({"H", "hit point"});
  if (!journey.minima.empty()) keys.push_back({"M", "follows the contour"});
  if (!journey.leaves.empty()) keys.push_back({"L", "leave point"});
  return keys;
}

/// When the robot is at each point of its path, as a part of the whole.
std::vector<double> times_of(const Path& path) {
  std::vector<double> times{0};
  for (std::size_t i = 1; i < path.points.size(); ++i)
    times.push_back(times.back() +
                    std::hypot(path.points[i].x - path.points[i - 1].x, path.points[i].y - path.points[i - 1].y));
  if (times.back() > 0)
    for (double whole = times.back(); double& t : times) t /= whole;
  return times;
}

}  // namespace

std::string bug_svg(const FreeSpace& space, const Journey& journey, const BugPicture& what) {
  SvgPicture picture;
  picture.title = what.title;
  picture.facts = what.facts;
  picture.path = &journey.path;
  picture.start = what.start;
  picture.moves = what.end_moves;
  picture.goal.point = what.goal;
  if (what.algorithm != Algorithm::tangent) picture.guides = {{what.start, what.goal}};
  picture.seconds = what.moves ? kFilmSeconds : 0;
  picture.labels = labels_of(journey);
  picture.label_keys = label_keys(journey);
  const std::vector<double> times = times_of(journey.path);
  for (const View& view : journey.views) picture.views.push_back({view.ring, times[view.point]});
  return svg(space, picture);
}

}  // namespace taut::bug
