// What is written into the cells of a micromouse maze: how far the goal is as the map has it, and what a robot wrote.
#pragma once

#include <map>
#include <string>

#include <taut/io/pictures/detail/mouse_film.h>
#include <taut/io/pictures/detail/mouse_sheet.h>
#include <taut/robots/micromouse/mms.h>

namespace taut::detail {

/// In each cell the fewest steps to the goal, unknown walls open, as run 1 has it in the end.
std::string mouse_values(const MouseSheet& sheet, const micromouse::Record& record);

/// The same step by step: each number from the step that brings it to the one that changes it. Before the first step no
/// wall is known but the border.
std::string film_values(const MouseSheet& sheet, const micromouse::Record& record, const MouseFilm& film);

/// A robot's own colours, as small squares, and words.
std::string mouse_marks(const MouseSheet& sheet, const std::map<Cell, micromouse::CellMark>& marks);

}  // namespace taut::detail
