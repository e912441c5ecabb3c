// Results side by side: as CSV, and as a page with box plots and tables that sort.
#pragma once

#include <string>
#include <string_view>

#include <taut/io/results/json.h>

namespace taut {

/// The rows of a result that compares: an array of flat objects, of texts, numbers, truths and nulls alone.
///
///  1. Where they come from: the first member of `result` that is an array of objects. Where an item holds an array of
///     objects itself (`all_runs`, `runs`, `planners`), those are rows in its place, each with the first text of the
///     item in front; so on inwards.
///  2. Other arrays and objects are left out; order is that of the result.
Json report_rows(const Json& result);

/// For each value of the member `by` (all rows together where it is empty), in the order of their first rows, and for
/// each member with numbers or truths: {by, measure, rows, mean, least, lower, median, upper, most}. A truth counts as
/// 0 or 1, so the mean of `solved` is the rate of success. Quartiles are interpolated between neighbours. A null is
/// left out, so `rows` may be fewer.
Json report_summary(const Json& rows, std::string_view by);

/// RFC 4180, a heading of all members in the order in which they appear first; null is an empty field, a truth 0 or 1.
std::string report_csv(const Json& rows);

/// One page of HTML that needs nothing else, no network either: for each measure that differs a box plot (SVG; whiskers
/// reach to the least and the most; logarithmic where they are a hundredfold apart), then the summary and all rows as
/// tables that are sorted by a click on a heading, or a key. Light and dark.
std::string report_html(std::string_view title, const Json& rows, std::string_view by);

}  // namespace taut
