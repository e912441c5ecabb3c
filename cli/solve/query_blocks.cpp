#include <taut/cli/solve/query_blocks.h>

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include <taut/geometry/errors.h>

namespace taut::cli {

namespace {

constexpr std::size_t kLongest = 4096;

}  // namespace

bool QueryBlocks::next(std::vector<QueryLine>& block) {
  std::string line;
  for (const std::size_t before = block.size(); block.size() < before + length_;) {
    wall_.reset();
    if (!source_.next(line)) return false;
    wall_ = wall_line(line, source_.name(), ++line_);
    if (wall_) return true;
    if (const std::optional<QueryLine> query = reader_.read(line, line_)) {
      require_for_this_map(*query);
      block.push_back(*query);
    }
    if (source_.may_wait()) return true;
  }
  length_ = std::min(2 * length_, kLongest);
  return true;
}

void QueryBlocks::require_for_this_map(const QueryLine& query) const {
  const Box box = input_.world.box();
  if (query.map != Point{} && query.map != box.max)
    throw InputError(source_.name(), line_,
                     fmt::format("is for a map of {} x {} cells, {} has {} x {}", query.map.x, query.map.y, input_.name,
                                 box.max.x, box.max.y));
  if (!shown_) return;
  for (const Point p : {query.from, query.to})
    shown_.geographic()->require_end(p, fmt::format("line {} of the queries: end", line_));
}

}  // namespace taut::cli
