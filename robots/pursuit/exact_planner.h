// The least-cost way to meet a moving target, proven.
#pragma once

#include <taut/robots/pursuit/pursuit.h>

namespace taut::pursuit {

/// The least path cost over all meetings, waiting wherever it is cheapest.
///
///  1. found: the plan keeps what ChasePlan says; optimal unless stopped. none: proven, with reason_of_failure.
///     stopped: no plan was found in time.
///  2. When limits stop it after a first plan was found: found, not optimal, with a bound below the cost.
///  3. Deterministic when it is not stopped, on however many cores.
///  4. Memory: about 35 bytes a cell for most maps, 80 at worst, and what PlanLimits allows for labels; never a layer
///     per second.
///
/// The method. All waiting of a best way is at its cheapest cell, of cost m, so the way costs sum(w) + (t - k) m: k
/// moves, t seconds. For u <= m this is at least t u + sum(w - u): one search in the plane, with u =
/// lo, bounds all ways whose cheapest cell costs lo..hi. Ranges of m are split, best bound first, where the bound's own
/// way costs more than the bound; m <= cost of the start leaves few. Seconds come in only by k <= t: where the way of a
/// meeting's bound is too slow for it, u < lo makes moves dearer and raises that bound. Only
/// for meetings that this does not settle a search with two criteria (reduced cost, moves) is run, pruned by the latest
/// departure in time and by the cost to meet, for u = lo and for a second, Lagrangian u. Two searches run side by side:
/// the two breadth-first ones it begins with, two values of u for the first range, then two ranges at a time;
/// by two threads where PlanLimits::jobs allows them.
/// Precondition: chase.from is free.
ChasePlan exact_plan(const Chase& chase, const PlanLimits& limits = {}, PlanEffort* effort = nullptr);

/// Some way in time: the one that comes to its meeting's cell with the most seconds to spare. Not optimal, O(cells).
ChasePlan first_plan(const Chase& chase);

/// The best way that the first bounds lead along: mostly near the optimum. A few searches in the plane, O(cells log
/// cost) each.
ChasePlan rough_plan(const Chase& chase);

}  // namespace taut::pursuit
