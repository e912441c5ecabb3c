#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <taut/io/results/detail/report_table.h>
#include <taut/io/results/report.h>

namespace taut {

namespace {

constexpr const char* kStyle = R"(
:root { color-scheme: light dark; --ink: #1f2430; --paper: #fff; --line: #c9ced8; --box: #2f6db5; --fill: #dbe8f7; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e4e7ee; --paper: #171a21; --line: #454c5a; --box: #8ab4f8; --fill: #24405f; } }
body { font: 15px/1.5 system-ui, sans-serif; color: var(--ink); background: var(--paper); margin: 1.5rem; }
svg { display: block; max-width: 100%; height: auto; margin: 0 0 1.5rem; }
svg text { fill: var(--ink); font-size: 12px; }
.grid { stroke: var(--line); } .whisker { stroke: var(--box); } .box { stroke: var(--box); fill: var(--fill); }
.middle { stroke: var(--box); stroke-width: 3; }
.table { overflow-x: auto; } table { border-collapse: collapse; font-variant-numeric: tabular-nums; }
th, td { border-bottom: 1px solid var(--line); padding: .2rem .7rem; text-align: right; white-space: nowrap; }
td.text, th.text { text-align: left; }
th button { font: inherit; font-weight: 600; color: inherit; background: none; border: 0;
  padding: 0; cursor: pointer; } th[aria-sort=ascending] button::after { content: " \2191"; }
th[aria-sort=descending] button::after { content: " \2193"; }
)";

constexpr const char* kScript = R"(
for (const heading of document.querySelectorAll("th")) heading.firstChild.addEventListener("click", () => {
  const body = heading.closest("table").tBodies[0], column = heading.cellIndex;
  const up = heading.getAttribute("aria-sort") !== "ascending";
  for (const other of heading.parentNode.cells) other.removeAttribute("aria-sort");
  heading.setAttribute("aria-sort", up ? "ascending" : "descending");
  const key = row => row.cells[column].textContent;
  const order = (a, b) => (a === "") - (b === "") || (up ? 1 : -1) * (a - b || (isNaN(a - b) ? a.localeCompare(b) : 0));
  body.append(...[...body.rows].sort((a, b) => order(key(a), key(b))));
});
)";

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '"': out += "&quot;"; break;
      default: out += c;
    }
  return out;
}

std::string table_of(const Json& rows) {
  const std::vector<std::string> columns = detail::columns_of(rows);
  const auto kind = [&](const std::string& column) {
    const bool is_text = std::ranges::any_of(*rows.items(), [&](const Json& row) {
      const Json* value = detail::member(row, column);
      return value && value->text();
    });
    return is_text ? " class=\"text\"" : "";
  };
  std::string head;
  std::vector<std::string> kinds;
  for (const std::string& column : columns) {
    kinds.emplace_back(kind(column));
    head += fmt::format("<th scope=\"col\"{}><button>{}</button></th>", kinds.back(), escaped(column));
  }
  std::string body;
  for (const Json& row : *rows.items()) {
    body += "<tr>";
    for (std::size_t i = 0; i < columns.size(); ++i)
      body += fmt::format("<td{}>{}</td>", kinds[i], escaped(detail::cell_text(detail::member(row, columns[i]))));
    body += "</tr>\n";
  }
  return fmt::format("<div class=\"table\"><table>\n<thead><tr>{}</tr></thead>\n<tbody>\n{}</tbody></table></div>\n",
                     head, body);
}

// The box plot of one measure, a line a group.
class BoxPlot {
 public:
  BoxPlot(std::string measure, std::vector<const Json*> groups, std::string_view by)
      : measure_(std::move(measure)), groups_(std::move(groups)), by_(by) {
    for (const Json* group : groups_) {
      least_ = std::min(least_, number(*group, "least"));
      most_ = std::max(most_, number(*group, "most"));
    }
    is_logarithmic_ = least_ > 0 && most_ / least_ >= kHundredfold;
  }

  bool differs() const { return least_ < most_; }

  std::string svg() const {
    std::string out = fmt::format(
        "<h3>{}{}</h3>\n<svg viewBox=\"0 0 {} {}\" width=\"{}\" role=\"img\" aria-label=\"{}\">\n", escaped(measure_),
        is_logarithmic_ ? ", logarithmic" : "", kWidth, height(), kWidth, "Box plots of " + escaped(measure_));
    for (int i = 0; i <= kTicks; ++i) out += tick(i);
    for (std::size_t i = 0; i < groups_.size(); ++i) out += box(*groups_[i], kRow * (static_cast<double>(i) + 0.5) + 4);
    return out + "</svg>\n";
  }

 private:
  static constexpr double kHundredfold = 100;
  static constexpr int kWidth = 760, kLeft = 170, kRight = 40, kRow = 26, kTicks = 4;

  static double number(const Json& row, std::string_view name) {
    return *detail::number_of(*detail::member(row, name));
  }

  int height() const { return kRow * static_cast<int>(groups_.size()) + 28; }

  double x(double value) const {
    const double part =
        is_logarithmic_ ? std::log(value / least_) / std::log(most_ / least_) : (value - least_) / (most_ - least_);
    return kLeft + part * (kWidth - kLeft - kRight);
  }

  std::string tick(int i) const {
    const double part = static_cast<double>(i) / kTicks;
    const double value = is_logarithmic_ ? least_ * std::pow(most_ / least_, part) : least_ + part * (most_ - least_);
    return fmt::format(
        "<path class=\"grid\" d=\"M{0:.1f} 4V{1}\"/><text x=\"{0:.1f}\" y=\"{2}\" "
        "text-anchor=\"middle\">{3:.3g}</text>\n",
        x(value), height() - 22, height() - 6, value);
  }

  std::string box(const Json& row, double y) const {
    const Json* name = by_.empty() ? nullptr : detail::member(row, by_);
    const double lower = x(number(row, "lower")), upper = x(number(row, "upper"));
    return fmt::format(
        "<text x=\"{}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text><path class=\"whisker\" d=\"M{:.1f} {:.1f}H{:.1f}\"/>"
        "<rect class=\"box\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"14\"/>"
        "<path class=\"middle\" d=\"M{:.1f} {:.1f}v14\"/>\n",
        kLeft - 8, y + 4, escaped(detail::cell_text(name)), x(number(row, "least")), y, x(number(row, "most")), lower,
        y - 7, std::max(upper - lower, 1.0), x(number(row, "median")), y - 7);
  }

  std::string measure_;
  std::vector<const Json*> groups_;
  std::string by_;
  double least_ = HUGE_VAL;
  double most_ = -HUGE_VAL;
  bool is_logarithmic_ = false;
};

std::string plots_of(const Json& summary, const std::vector<std::string>& measures, std::string_view by) {
  std::string out;
  for (const std::string& measure : measures) {
    std::vector<const Json*> groups;
    for (const Json& row : *summary.items())
      if (*detail::member(row, "measure")->text() == measure) groups.push_back(&row);
    if (groups.empty() || measure == "seed" || measure == "sample") continue;
    if (const BoxPlot plot(measure, groups, by); plot.differs()) out += plot.svg();
  }
  return out;
}

}  // namespace

std::string report_html(std::string_view title, const Json& rows, std::string_view by) {
  const Json summary = report_summary(rows, by);
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
      "content=\"width=device-width\">"
      "<title>{0}</title><style>{1}</style></head>\n<body><main><h1>{0}</h1>\n{2}<h2>Summary</h2>\n{3}<h2>All "
      "rows</h2>\n{4}"
      "</main><script>{5}</script></body></html>\n",
      escaped(title), kStyle, plots_of(summary, detail::columns_of(rows), by), table_of(summary), table_of(rows),
      kScript);
}

}  // namespace taut
