// What answers the queries of `taut batch`.
#pragma once

#include <cstddef>
#include <utility>
#include <variant>
#include <vector>

#include <taut/search/changing_world.h>
#include <taut/search/index.h>
#include <taut/search/no_path.h>
#include <taut/search/polyanya.h>

namespace taut::cli {

/// One query after the other, by cones and bends, by an index, or in a world that changes.
class Finder {
 public:
  explicit Finder(const Polyanya& polyanya) : search_(PolyanyaSearch(polyanya)) {}
  explicit Finder(const Index& index) : search_(IndexSearch(index)) {}
  explicit Finder(ChangingWorld world) : search_(std::move(world)) {}

  ChangingWorld* changing() { return std::get_if<ChangingWorld>(&search_); }

  SearchStatus find(Point from, Point to) {
    return std::visit([&](auto& search) { return search.find(from, to); }, search_);
  }
  const std::vector<Point>& points() const {
    return std::visit([](const auto& search) -> const std::vector<Point>& { return search.points(); }, search_);
  }
  /// 0 where it is not by cones and bends.
  std::size_t expanded() const {
    const auto* const cones = std::get_if<PolyanyaSearch>(&search_);
    return cones ? cones->expanded() : 0;
  }

  /// Is it proven that there is no path? `no_path` is of the world as it was read.
  bool proves_none(const NoPath& no_path, Point from, Point to) {
    const Goal goal{to, {}};
    return changing() ? NoPath(changing()->space()).holds(from, goal) : no_path.holds(from, goal);
  }

 private:
  std::variant<PolyanyaSearch, IndexSearch, ChangingWorld> search_;
};

}  // namespace taut::cli
