#include <taut/cli/messages.h>

#include <unistd.h>

#include <cstdio>
#include <cstdlib>

namespace taut::cli {

namespace {

bool colour() noexcept {
  const char* wish = std::getenv("NO_COLOR");
  const char* terminal = std::getenv("TERM");
  if ((wish && *wish) || (terminal && std::string_view(terminal) == "dumb")) return false;
  return isatty(STDERR_FILENO) == 1;
}

}  // namespace

void complain(std::string_view message) noexcept {
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
  std::fwrite(line.data(), 1, line.size(), stderr);
  std::fputc('\n', stderr);
}

}  // namespace taut::cli
