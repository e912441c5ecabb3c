// What moves in a picture (SMIL), and how its reader stops it.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <taut/io/pictures/detail/svg_path.h>

namespace taut::detail {

/// For an element of opacity 0: it is to be seen from one moment to another, both parts of the `seconds` that a round
/// takes.
std::string shown_between(double from, double until, double seconds);

/// A dot that runs along the line in that time, again and again; the radius in pixels.
std::string runner_along(const SvgPath& line, double radius, double seconds);

/// A dot of that class at places (in pixels), each with when, a part of the `seconds` that a round takes; from 0 to 1.
std::string dot_by_clock(const std::vector<std::pair<double, Point>>& places, double radius, double seconds,
                         const std::string& kind);

/// What makes a picture a film, to be put before the frame's foot: a button, its right upper corner there, that pauses
/// and goes on (a click, or Enter or the space bar once it has the focus; a film that plays once starts again after
/// `ends` seconds, 0: it never ends), and rules for readers who prefer reduced motion. Those see a still picture until
/// they press the button: elements of class `moving` are hidden, those of class `appears` are there from the beginning
/// (visible, opaque, without a dash offset). The script does no more than that: where none may run, as in an <img>, the
/// button is not shown, the film plays and the rules hold.
std::string film_controls(Point corner, double ends = 0);

}  // namespace taut::detail
