// The planner behind a page, on this machine alone.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include <taut/web/session.h>

namespace taut::cli {

/// Was the program built with a server?
bool can_serve();

struct Serving {
  std::function<std::string(const std::string& ask)> page;  ///< given the address of questions; what GET answers
  std::function<void(const std::string& address)> begun;    ///< told once it listens
  std::optional<double> seconds;                            ///< how long; absent: until SIGINT or SIGTERM
};

/// Answers at http://127.0.0.1:PORT/TOKEN/, port and token drawn anew each time, what the session answers to POST at
/// ask. Other addresses are 404; a Host that is not this one, and an Origin that is another's, are 403, so no page of
/// the web gets in, not even by a name that was made to point here. Returns when the time is over or a signal came.
/// Precondition: can_serve(). Throws InputError where no port can be had. Gives how many questions were answered.
std::size_t serve(web::Session& session, const Serving& serving);

}  // namespace taut::cli
