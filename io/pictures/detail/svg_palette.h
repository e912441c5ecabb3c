// The colours of all pictures: one meaning each, on every sheet, on light and on dark pages.
#pragma once

#include <string_view>

namespace taut::detail {

/// Rules of a <style> for classes under svg.taut, `prefers-color-scheme` included. Strokes carry no widths.
///
///  | class                    | colour        | meaning                                                       |
///  |--------------------------|---------------|---------------------------------------------------------------|
///  | path .line, forward      | orange        | where the robot goes, ahead; `runner`, `discs`: the robot     |
///  | path .casing             | the page      | sets a path off from what it crosses                          |
///  | backward                 | teal          | where it goes in reverse                                      |
///  | start                    | green         | where it begins                                               |
///  | goal, rooms, target      | purple        | where it is to go; a target is a goal that moves              |
///  | obstacle, walls          | slate         | what cannot be entered; `solid` (pale): nor by its middle     |
///  | free                     | white, night  | what can                                                      |
///  | views, frontier          | amber         | what was seen: from a place on the path; cells not yet taken  |
///  | separation               | crimson       | the walls that leave no path                                  |
///  | gates                    | blue          | narrow places                                                 |
///  | roadmap, milestones      | pale blue     | ways that were considered, and where they meet                |
///  | guides, moves, openings, grid | grey          | lines that help the eye                                       |
std::string_view palette();

}  // namespace taut::detail
