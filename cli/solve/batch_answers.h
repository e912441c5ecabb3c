// The answers of `taut batch`: streamed to standard output, kept for --json, counted.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <taut/cli/run.h>
#include <taut/io/results/end_moves.h>
#include <taut/io/results/json.h>
#include <taut/io/worlds/query_lines.h>

namespace taut::cli {

/// What came of one query.
struct QueryAnswer {
  enum class Status : std::uint8_t { found, none, blocked, unproven };
  Status status = Status::none;  ///< none: proven; blocked: an end is no free place
  double length = 0;
  const char* measure = "length";      ///< what `length` is
  std::string limit{};                 ///< what keeps it from being larger, where that was asked
  double cpu = 0;                      ///< seconds of the search
  std::size_t nodes = 0;               ///< that it looked at
  double straight = 0;                 ///< the distance of the ends
  const char* blocked = "";            ///< "start" or "goal"
  std::optional<FreePlace> nearest{};  ///< to the blocked end, where it is wanted
  std::vector<EndMove> moves{};        ///< --snap-ends
  std::vector<Point> points{};         ///< where they are wanted
};

/// How answers are written.
struct AnswerForm {
  bool prints = true;  ///< to standard output
  bool json = false;   ///< an object a line
  bool path = false;   ///< the points as well
  bool keeps = false;  ///< for the result
};

/// Safe against the thread that stops the program: what was added is printed and kept then, too.
class BatchAnswers {
 public:
  explicit BatchAnswers(const AnswerForm& form);
  ~BatchAnswers();

  /// A mismatch is complained of; `source` is the queries' name.
  void add(const QueryLine& query, const QueryAnswer& answer, const std::string& source);
  /// To standard output, once there is much or `now`.
  void flush(bool now);
  void prepared_in(const Seconds& seconds);

  Outcome outcome() const;
  std::string reason() const;  ///< empty when all is well
  /// `3 queries, 0 without an answer, 2 compared, 1 mismatch; 12.5 us CPU a query, 0.004 s CPU to prepare`
  std::string totals() const;
  /// {queries, unanswered, unproven, compared, mismatches, seconds_a_query, seconds_to_prepare (both CPU), answers:
  /// [{line, status, blocked, nearest, distance, length (or radius, limit), expected, matches, path, moved_ends}, ...]}
  Json json() const;

  /// For Run::when_stopped: the result, and what is not yet printed; says the totals.
  std::function<std::pair<Json, std::string>()> last_words() const;

 private:
  struct State;
  std::shared_ptr<State> state_;  // with the thread that stops the program
};

}  // namespace taut::cli
