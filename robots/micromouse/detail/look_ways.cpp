#include <taut/robots/micromouse/detail/look_ways.h>

#include <taut/robots/micromouse/detail/boards.h>

namespace taut::micromouse::detail {

std::vector<Action> LookWays::way_to(std::size_t node) const {
  std::vector<Action> way;
  for (; node != order.front(); node = from[node]) way.push_back(by[node]);
  return way;
}

std::size_t node_of(const WallMap& map, const MousePose& pose) {
  return index_of(map.width(), pose.cell) * 4 + static_cast<std::size_t>(pose.heading);
}

LookWays look_ways(const WallMap& map, std::size_t root, const Outlook& outlook, double side_looks) {
  const std::size_t nodes = static_cast<std::size_t>(map.width()) * static_cast<std::size_t>(map.height()) * 4;
  LookWays w{std::vector<int>(nodes, -1),
             std::vector<float>(nodes, 0),
             std::vector<Action>(nodes),
             std::vector<std::size_t>(nodes),
             {root}};
  w.steps[root] = 0;
  const Passages& certain = map.certain();
  for (std::size_t head = 0; head < w.order.size(); ++head) {
    const std::size_t node = w.order[head];
    const Cell c = cell_of(map.width(), node / 4);
    const auto arrive = [&](Cell to, Side h, Action a) {
      const std::size_t next = node_of(map, {to, h});
      if (w.steps[next] >= 0 && w.steps[next] <= w.steps[node]) return;
      const float sum = static_cast<float>(side_looks) * w.collected[node] + outlook.at(next / 4, h);
      if (w.steps[next] < 0)
        w.steps[next] = w.steps[node] + 1, w.order.push_back(next);
      else if (sum <= w.collected[next])
        return;
      w.collected[next] = sum;
      w.from[next] = node;
      w.by[next] = a;
    };
    for (const int rotation : {0, -90, 90}) {
      const Side h = turned(static_cast<Side>(node % 4), rotation / 90);
      if (rotation != 0) arrive(c, h, {rotation, 0});
      for (const int sign : {1, -1}) {
        const Side side = sign > 0 ? h : opposite(h);
        Cell to = c;
        for (int i = 1; i <= kLongestMove && certain.open(to, side); ++i) {
          to = ahead(to, side);
          arrive(to, h, {rotation, sign * i});
        }
      }
    }
  }
  return w;
}

}  // namespace taut::micromouse::detail
