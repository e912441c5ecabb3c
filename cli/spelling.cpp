#include <taut/cli/spelling.h>

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace taut::cli {

namespace {

// Damerau's and Levenshtein's, no letter in two edits ("optimal string alignment"), by rows.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before.swap(last);
    last.swap(row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row.back();
}

}  // namespace

std::string_view nearest_name(std::string_view text, const std::vector<std::string_view>& names) {
  std::string_view nearest;
  std::size_t least = text.size() / 3 + 1;
  for (const std::string_view name : names) {
    const std::size_t distance = edit_distance(text, name);
    if (distance > least || (distance == least && !nearest.empty())) continue;
    least = distance;
    nearest = name;
  }
  if (!nearest.empty()) return nearest;
  const auto begins = std::find_if(names.begin(), names.end(), [&](std::string_view name) {
    return std::min(text.size(), name.size()) >= 3 && (text.starts_with(name) || name.starts_with(text));
  });
  return begins == names.end() ? std::string_view() : *begins;
}

std::string meant(std::string_view text, const std::vector<std::string_view>& names) {
  const std::string_view nearest = nearest_name(text, names);
  return nearest.empty() ? "" : "; did you mean '" + std::string(nearest) + "'?";
}

}  // namespace taut::cli
