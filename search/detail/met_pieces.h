// The pieces of a free space that the legs of a path meet: what verify() looks at.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <taut/geometry/cell_plan.h>
#include <taut/geometry/free_space.h>
#include <taut/search/detail/leg_contacts.h>

namespace taut::detail {

/// What stops a path, leg by leg.
class Pieces {
 public:
  /// What a leg meets: of a vector of pieces, those that it touches, ascending, and the lowest that it crosses.
  struct Met {
    std::span<const Constraint> pieces;
    std::span<const std::uint32_t> touching;
    std::uint32_t crossed = kNone;
    bool are_all = false;  ///< the pieces are the space's, by its own numbers
  };

  virtual ~Pieces() = default;
  /// Until it is asked for another leg.
  virtual Met met(std::size_t leg) = 0;
  /// One that some leg meets: the lowest, where their numbers say more than for one leg. kNone: there is none.
  virtual std::uint32_t any_met() = 0;
  /// Can a path begin there?
  virtual bool holds(Point p) const = 0;
  /// Of legs that meet nothing.
  virtual NearestPiece nearest() const = 0;
};

/// All constraints, by a tree over the legs.
class AllPieces : public Pieces {
 public:
  AllPieces(const FreeSpace& space, const std::vector<Segment>& legs)
      : space_(space), tree_(legs, space.constraints()), contacts_(tree_.contacts()) {}

  Met met(std::size_t leg) override {
    return {space_.constraints(), contacts_.touching[leg], contacts_.crossed[leg], true};
  }
  std::uint32_t any_met() override;
  bool holds(Point p) const override;
  NearestPiece nearest() const override { return tree_.nearest(); }

 private:
  const FreeSpace& space_;
  LegTree tree_;
  LegContacts contacts_;
};

/// Those of the cells that a leg passes, nothing else of the space is looked at.
class PiecesAlong : public Pieces {
 public:
  PiecesAlong(const CellPlan& plan, const std::vector<Segment>& legs) : plan_(plan), legs_(legs) {}

  Met met(std::size_t leg) override;
  std::uint32_t any_met() override;
  bool holds(Point p) const override { return plan_.around(p).free != 0; }
  NearestPiece nearest() const override;

 private:
  const CellPlan& plan_;
  const std::vector<Segment>& legs_;
  std::vector<Constraint> pieces_;
  std::vector<std::uint32_t> touching_;
};

}  // namespace taut::detail
