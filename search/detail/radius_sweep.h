// The shortest way between two places of the disc, from one radius to another. Private.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <taut/search/detail/radius_rivals.h>
#include <taut/search/radius_tradeoff.h>

namespace taut::detail {

class RadiusSweep {
 public:
  /// `tell` hears of each stretch. Precondition: s != g.
  RadiusSweep(const AllRadii& radii, const PassageIndex& index, Point s, Point g,
              const std::function<void(TradeoffStretch)>& tell);

  /// Precondition: the disc gets from s to g for all radii up to `most`.
  void sweep(double from, double most);

  std::size_t graphs() const { return graphs_; }

 private:
  struct Piece {
    double from = 0, to = 0;
    DiscWord word{};
    LengthFormula length{};
  };
  struct Rival {
    double at = 0;
    DiscWord word{};
  };

  void follow(DiscWord word, double from, double most);
  double length(double r) const;
  std::optional<Rival> first_rival(const TangentGraph& graph, double from, double& to);
  std::optional<double> first_below(const LengthFormula& rival, double from, double to) const;
  std::optional<double> below(const LengthFormula& rival, const LengthFormula& best, double from, double to) const;
  std::pair<double, double> enclosed(const Rival& rival, double to) const;
  void tell_until(double to, TradeoffStretch::End end);
  std::uint32_t gate_at(double r) const;

  const AllRadii& radii_;
  const PassageIndex& index_;
  Point s_, g_;
  const std::function<void(TradeoffStretch)>& tell_;
  std::optional<DiscWords> words_;
  std::vector<Piece> way_;  // of one class, as far as it goes
  double slack_ = 0;
  double window_ = 0;
  std::size_t graphs_ = 0;
};

}  // namespace taut::detail
