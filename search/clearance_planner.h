// Paths that keep away from walls, and how large a disc may be: the Voronoi diagram's answers, checked by the gates.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <taut/search/barrier.h>
#include <taut/search/clearance_search.h>
#include <taut/search/graph_search.h>

namespace taut {

struct ClearanceQuery {
  enum class Kind : std::uint8_t {
    at_least,  ///< the shortest way along the diagram with `clearance`
    widest,    ///< the way with the largest clearance
    tradeoff,  ///< all best ways between the shortest along the diagram and the widest
  };
  Kind kind = Kind::widest;
  double clearance = 0;  ///< >= 0, of Kind::at_least
};

struct ClearanceAnswer {
  /// Why a search that is neither found nor none is not.
  enum class Doubt : std::uint8_t {
    nothing,
    no_witness,  ///< no way in the diagram, and no walls that prove it
    disagree,    ///< the diagram and the gates, by less than the diagram's rounding
  };

  ClearanceQuery query{};
  SearchStatus status = SearchStatus::none;  ///< `stopped` when there is a doubt
  Doubt doubt = Doubt::nothing;
  Point start{};
  Point goal{};                          ///< of several, the one to which the largest disc gets
  std::vector<ClearanceTrade> found{};   ///< one, of a tradeoff several
  std::optional<WidestPassage> limit{};  ///< of Kind::widest, by the gates
  std::optional<std::string> width{};    ///< of the widest's gate, exact where short
  std::optional<DiscPassage> passage{};  ///< none: what the gates say of the disc
  Barrier barrier{};                     ///< why there is none, or of Kind::widest: why no larger disc gets through
  bool verified = false;                 ///< the paths were checked against the walls, their width against the gates
  std::array<std::size_t, 2> places{};   ///< vertices and edges of the diagram
  double max_error = 0;                  ///< VoronoiRoadmap::max_error
  double within = 0;                     ///< rounding_bound of the walled world: radii are right within so much
};

/// Answers questions of clearance between a start and a goal.
class ClearancePlanner {
 public:
  /// `space` is a point's free space of the world, `map` the diagram and `gates` the gates of its walled_world(). Of
  /// several goals that to which the largest disc gets is meant. Precondition: there are goals; neither they nor the
  /// start are outside.
  ClearancePlanner(FreeSpace space, VoronoiRoadmap map, Gates gates, Point start, const std::vector<Point>& goals);

  /// Not yet verified. `told` hears of each way of a tradeoff as it is found.
  ClearanceAnswer answer(const ClearanceQuery& query,
                         const std::function<void(const ClearanceTrade&)>& told = {}) const;

  /// Every path against the walls, its width against the gates, and that nothing wider was missed. Where they differ by
  /// the diagram's rounding, the answer becomes `stopped` (Doubt::disagree).
  void verify(ClearanceAnswer& answer) const;

  /// Legs that stand for a way: no farther from it than 1/10 000 of the mean width of a corridor.
  std::vector<Point> points_of(const ClearancePath& way) const;
  double tolerance() const;  ///< that length

  const VoronoiRoadmap& map() const { return map_; }
  const Gates& gates() const { return gates_; }
  const FreeSpace& walled() const { return map_.space(); }

 private:
  std::vector<ClearanceTrade> ways(const ClearanceQuery& query,
                                   const std::function<void(const ClearanceTrade&)>& told) const;
  void prove_none(ClearanceAnswer& answer) const;
  void name_limit(ClearanceAnswer& answer) const;
  bool is_followed(const ClearancePath& way) const;
  bool gates_agree(const ClearanceAnswer& answer) const;

  FreeSpace space_;
  VoronoiRoadmap map_;
  Gates gates_;
  Point start_, goal_;
};

}  // namespace taut
