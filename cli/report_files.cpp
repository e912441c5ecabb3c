#include <taut/cli/report_files.h>

#include <fmt/format.h>

#include <taut/io/results/report.h>

namespace taut::cli {

void add_csv_option(CommandLine& app, ReportOptions& options) {
  app.add_option("--csv", options.csv, "Write all rows as a table").type_name("FILE").group("Output");
}

void add_html_option(CommandLine& app, ReportOptions& options) {
  app.add_option("--html", options.html, "Write a page that needs nothing else: box plots, and tables that sort")
      .type_name("FILE")
      .group("Output");
}

void promise_reports(const ReportOptions& options, Run& run) {
  run.promise(options.csv);
  run.promise(options.html);
}

void add_reports(Answer& answer, const ReportOptions& options, std::string_view title, std::string_view by) {
  if (options.csv.empty() && options.html.empty()) return;
  add_reports(answer, options, title, by, report_rows(answer.result));
}

void add_reports(Answer& answer, const ReportOptions& options, std::string_view title, std::string_view by,
                 const Json& rows) {
  if (!options.csv.empty()) answer.files.push_back({options.csv, report_csv(rows)});
  if (!options.html.empty())
    answer.files.push_back({options.html, report_html(fmt::format("taut: {}", title), rows, by)});
}

}  // namespace taut::cli
