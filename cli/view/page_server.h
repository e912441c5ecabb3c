// The server behind `taut view --serve`, a module of its own: what it stands on, TLS and compression, would take as
// long to load as all else that the program needs. It knows nothing of taut.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace taut::cli {

struct PageServing {
  std::function<std::string(const std::string& question)> answer;  ///< to a POST at ask; one at a time
  std::function<std::string(const std::string& ask)> page;         ///< given the address of questions; what GET answers
  std::function<void(const std::string& address)> begun;           ///< told once it listens
  std::function<void(std::function<void()>)> when_ended;           ///< keeps what is to be called when a signal came
  std::optional<double> seconds;                                   ///< how long; absent: until a signal
};

/// Answers at http://127.0.0.1:PORT/TOKEN/, port and token drawn anew each time. Other addresses are 404; a Host that
/// is not this one, and an Origin that is another's, are 403, so no page of the web gets in, not even by a name that
/// was made to point here. Returns when the time is over or a signal came. Throws std::runtime_error where no port can
/// be had. Gives how many questions were answered.
using ServePage = std::size_t(const PageServing& serving);

constexpr const char* kServePage = "taut_serve_page";  ///< its name in the module
constexpr const char* kPageServer = "taut_page_server.so";

}  // namespace taut::cli
