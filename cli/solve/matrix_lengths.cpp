#include <taut/cli/solve/matrix_lengths.h>

#include <algorithm>
#include <cmath>

namespace taut::cli {

namespace {

Json row_json(std::span<const double> row) {
  Json json = Json::array();
  for (const double length : row)
    json.push_back(std::isfinite(length) ? Json(length) : std::isnan(length) ? Json("unproven") : Json());
  return json;
}

}  // namespace

Totals::Totals(const Lengths& lengths, std::size_t rows) {
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t j = i + 1; j < lengths.size; ++j) {
      const double length = lengths(i, j);
      found += std::isfinite(length);
      none += std::isinf(length);
      unproven += std::isnan(length);
      if (std::isfinite(length)) longest = std::max(longest, length);
    }
}

Json matrix_json(const Lengths& lengths, std::size_t rows, bool with_lengths) {
  const Totals totals(lengths, rows);
  Json json{{"points", lengths.size},      {"rows", rows},
            {"found", totals.found},       {"none", totals.none},
            {"unproven", totals.unproven}, {"longest", totals.longest}};
  if (!with_lengths) return json;
  json["lengths"] = Json::array();
  for (std::size_t i = 0; i < rows; ++i)
    json["lengths"].push_back(row_json(lengths.first(rows).subspan(i * lengths.size, lengths.size)));
  return json;
}

}  // namespace taut::cli
