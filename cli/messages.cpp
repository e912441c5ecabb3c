#include <taut/cli/messages.h>

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>

namespace taut::cli {

namespace {

constexpr std::size_t kWidestProgress = 79;
std::atomic<std::size_t> progress_width{0};  // of the line on the terminal; the watching thread may complain

bool colour() noexcept {
  const char* wish = std::getenv("NO_COLOR");
  const char* terminal = std::getenv("TERM");
  if ((wish && *wish) || (terminal && std::string_view(terminal) == "dumb")) return false;
  return isatty(STDERR_FILENO) == 1;
}

}  // namespace

void complain(std::string_view message) noexcept {
  end_progress();
  char line[4096];
  std::size_t n = 0;
  const auto put = [&](std::string_view text) {
    for (const char c : text)
      if (n + 8 < sizeof line) line[n++] = c;
  };
  put(colour() ? "\033[1;31mtaut:\033[0m " : "taut: ");
  for (const char c : message) {
    const bool control = static_cast<unsigned char>(c) < ' ' || c == 0x7f;
    put(std::string_view(control ? "?" : &c, 1));
  }
  put("\n");
  std::fwrite(line, 1, n, stderr);
  std::fflush(stderr);
}

void note(std::string_view line) noexcept {
  end_progress();
  std::fwrite(line.data(), 1, line.size(), stderr);
  std::fputc('\n', stderr);
}

bool is_progress_shown() noexcept {
  const char* terminal = std::getenv("TERM");
  return isatty(STDERR_FILENO) == 1 && !(terminal && std::string_view(terminal) == "dumb");
}

void progress(std::string_view line) noexcept {
  if (!is_progress_shown()) return;
  const auto width = static_cast<int>(std::min(line.size(), kWidestProgress));
  const std::size_t before = progress_width.exchange(static_cast<std::size_t>(width));
  std::fprintf(stderr, "\r%-*.*s", static_cast<int>(std::max(before, static_cast<std::size_t>(width))), width,
               line.data());
  std::fflush(stderr);
}

void end_progress() noexcept {
  const auto width = static_cast<int>(progress_width.exchange(0));
  if (width == 0) return;
  std::fprintf(stderr, "\r%*s\r", width, "");
  std::fflush(stderr);
}

}  // namespace taut::cli
