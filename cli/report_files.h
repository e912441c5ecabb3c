// What all subcommands that compare write: rows as CSV, a page of box plots and tables.
#pragma once

#include <string>
#include <string_view>

#include <taut/cli/command_line.h>
#include <taut/cli/run.h>

namespace taut::cli {

/// Files that are wished for; empty: none.
struct ReportOptions {
  std::string csv;
  std::string html;
};

void add_csv_option(CommandLine& app, ReportOptions& options);
void add_html_option(CommandLine& app, ReportOptions& options);
void promise_reports(const ReportOptions& options, Run& run);

/// The files, from the rows of answer.result (report_rows), compared by the member `by`.
void add_reports(Answer& answer, const ReportOptions& options, std::string_view title, std::string_view by);
/// The same from rows that say what the result says at more length.
void add_reports(Answer& answer, const ReportOptions& options, std::string_view title, std::string_view by,
                 const Json& rows);

}  // namespace taut::cli
