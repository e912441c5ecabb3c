#include <taut/robots/micromouse/detail/poses.h>

#include <algorithm>
#include <limits>

namespace taut::micromouse::detail {

Poses::Poses(const GridMaze& maze, const Task& task) : maze_(maze), task_(task) {
  const std::size_t cells = static_cast<std::size_t>(task.width) * static_cast<std::size_t>(task.height);
  moves_.resize(cells * 8);
  for (std::size_t c = 0; c < cells; ++c)
    for (unsigned heading = 0; heading < 4; ++heading) {
      auto& from = moves_[c * 8 + heading];
      add_moves(cell_of(task.width, c), static_cast<Side>(heading), from);
      std::sort(from.begin(), from.end());
      from.erase(std::unique(from.begin(), from.end()), from.end());
      moves_[c * 8 + 4 + heading] = from;
    }
}

Poses::MousePose Poses::id(Cell c, Side heading, bool felt) const {
  return static_cast<MousePose>(index_of(task_.width, c) * 8 + static_cast<std::size_t>(heading) + (felt ? 4 : 0));
}

void Poses::add_moves(Cell cell, Side heading, std::vector<MousePose>& into) const {
  for (const int quarters : {-1, 0, 1}) {
    const Side h = turned(heading, quarters);
    into.push_back(id(cell, h, maze_.wall(cell, opposite(h))));
    for (const bool back : {false, true}) {
      const Side side = back ? opposite(h) : h;
      Cell c = cell;
      for (int i = 0; i < kLongestMove && !maze_.wall(c, side); ++i) {
        c = ahead(c, side);
        into.push_back(id(c, h, back && i + 1 < kLongestMove && maze_.wall(c, side)));
      }
    }
  }
}

std::vector<Poses::MousePose> shortest_walk(const Poses& poses, const std::vector<PoseGroup>& groups) {
  const std::size_t n = poses.count();
  std::vector<std::uint32_t> meets(n);
  for (std::size_t g = 0; g < groups.size(); ++g)
    for (const Poses::MousePose p : groups[g]) meets[p] |= 1U << g;
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  const std::uint32_t all = (1U << groups.size()) - 1;
  std::vector<std::uint32_t> from((std::size_t{all} + 1) * n, kNone);
  const auto state = [&](std::uint32_t met, Poses::MousePose p) { return static_cast<std::uint32_t>(met * n + p); };
  const std::uint32_t root = state(meets[poses.start()], poses.start());
  std::vector<std::uint32_t> queue{root};
  from[root] = root;
  for (std::size_t head = 0; head < queue.size(); ++head) {
    const std::uint32_t here = queue[head];
    const auto met = static_cast<std::uint32_t>(here / n);
    if (met == all) {
      std::vector<Poses::MousePose> walk;
      for (std::uint32_t s = here;; s = from[s]) {
        walk.push_back(static_cast<Poses::MousePose>(s % n));
        if (from[s] == s) break;
      }
      std::reverse(walk.begin(), walk.end());
      return walk;
    }
    for (const Poses::MousePose p : poses.moves(static_cast<Poses::MousePose>(here % n))) {
      const std::uint32_t next = state(met | meets[p], p);
      if (from[next] != kNone) continue;
      from[next] = here;
      queue.push_back(next);
    }
  }
  return {};
}

}  // namespace taut::micromouse::detail
