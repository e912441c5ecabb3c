// Why a disc does not get through, and where a way is narrowest, in one line for people.
#pragma once

#include <string>

#include <taut/search/barrier.h>
#include <taut/search/clearance_planner.h>
#include <taut/search/passage.h>

namespace taut {

/// `these walls separate start and goal: ...`
std::string separation_text(const Barrier& barrier);

/// `this gate is narrower than 1: 0.5 between (3, 4) and (3, 5)`, or separation_text() where walls alone are it.
std::string barrier_text(const Barrier& barrier, double r);

/// Why a disc of radius r does not get through: barrier_text(), or what is the matter with an end. Precondition: it
/// does not.
std::string blocked_text(const Gates& gates, const DiscPassage& passage, const Barrier& barrier, Point start,
                         Point goal, double r);

/// `narrowest 1 between (3, 4) and (3, 5), of the walls (3, 0)-(3, 4) and (3, 5)-(3, 9)`; at an end
/// `nearest to a wall at the start (1, 1): 0.5 from the wall (0, 0)-(9, 0)`.
std::string pinch_text(const Pinch& pinch, const FreeSpace& space, const std::string& width = {});

/// What keeps a larger disc out: the gate's name, or `the start (1, 1) is that far from the wall ...`.
std::string limit_text(const Gates& gates, const WidestPassage& widest, Point start, Point goal);

/// `between (3, 4) and (3, 5)`, `at the start, from (0, 0)`: for tables.
std::string place_text(const Pinch& pinch);

/// Length and radius: six decimals where they say something, else nine digits.
std::string plain_length(double length);

/// `no path with clearance 1`
std::string none_text(const ClearanceQuery& query);

/// Why there is none, or why it is not proven; empty when found.
std::string clearance_reason(const ClearanceAnswer& answer, const Gates& gates);

}  // namespace taut
