#include <taut/io/worlds/grid_formula.h>

#include <muParser.h>

#include <algorithm>
#include <cctype>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include <taut/geometry/errors.h>

namespace taut {

namespace {

class Expression {
 public:
  explicit Expression(const std::string& text) {
    parser_.DefineVar("cx", &cx_);
    parser_.DefineVar("cy", &cy_);
    parser_.DefineVar("gx", &gx_);
    parser_.DefineVar("gy", &gy_);
    parser_.SetExpr(text);
    parser_.Eval();  // throws now rather than later
    if (parser_.GetNumResults() != 1) throw InputError("", 0, "'" + text + "' is several expressions");
  }

  double value(GridPlace cell, GridPlace goal) {
    const std::lock_guard lock(mutex_);
    cx_ = cell.column;
    cy_ = cell.row;
    gx_ = goal.column;
    gy_ = goal.row;
    return parser_.Eval();
  }

 private:
  std::mutex mutex_;
  double cx_ = 0, cy_ = 0, gx_ = 0, gy_ = 0;
  mu::Parser parser_;
};

// At commas outside parentheses.
std::vector<std::string_view> split(std::string_view text) {
  std::vector<std::string_view> parts;
  std::size_t from = 0;
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    depth += text[i] == '(' ? 1 : text[i] == ')' ? -1 : 0;
    if (text[i] != ',' || depth > 0) continue;
    parts.push_back(text.substr(from, i - from));
    from = i + 1;
  }
  parts.push_back(text.substr(from));
  return parts;
}

// Of letters and hyphens alone: meant as a name.
bool is_word(std::string_view text) {
  return std::ranges::all_of(text, [](unsigned char c) { return std::isalpha(c) != 0 || c == '-'; });
}

}  // namespace

GridFormula grid_formula(std::string_view text) {
  try {
    const auto expression = std::make_shared<Expression>(std::string(text));
    return {std::string(text), [expression](GridPlace cell, GridPlace goal) { return expression->value(cell, goal); }};
  } catch (const mu::ParserError& error) {
    throw InputError("", 0, "'" + std::string(text) + "' is no expression of cx, cy, gx and gy: " + error.GetMsg());
  }
}

GridHeuristic grid_heuristic(std::string_view text) {
  GridHeuristic heuristic{{}};
  for (const std::string_view part : split(text)) {
    if (const auto named = grid_heuristic_named(part)) {
      heuristic.members.insert(heuristic.members.end(), named->members.begin(), named->members.end());
    } else if (is_word(part) && part != "cx" && part != "cy" && part != "gx" && part != "gy") {
      throw InputError("", 0,
                       "'" + std::string(part) + "' is no heuristic; they are " + grid_estimate_names() +
                           ", expressions of cx, cy, gx and gy, and several joined by commas for their maximum");
    } else {
      heuristic.formulas.push_back(grid_formula(part));
    }
  }
  return heuristic;
}

}  // namespace taut
