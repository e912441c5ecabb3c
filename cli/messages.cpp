#include <taut/cli/messages.h>

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>

namespace taut::cli {

namespace {

constexpr std::size_t kWidestProgress = 79;
// Of a word of a complaint, a name or what stands in the place of a number, so much is shown at its beginning and its
// end.
constexpr std::size_t kWordBegin = 200;
constexpr std::size_t kWordEnd = 60;
std::atomic<std::size_t> progress_width{0};  // of the line on the terminal; the watching thread may complain

/// Nothing else is written to stderr as long as this lives.
class Hold {
 public:
  Hold() noexcept { flockfile(stderr); }
  ~Hold() { funlockfile(stderr); }
  Hold(const Hold&) = delete;
  Hold& operator=(const Hold&) = delete;
};

// How many bytes of a control character begin at i: 0 where none does. U+0080 to U+009F are two bytes of UTF-8.
std::size_t control_length(std::string_view text, std::size_t i) noexcept {
  const auto byte = [&](std::size_t at) { return at < text.size() ? static_cast<unsigned char>(text[at]) : 0U; };
  if (byte(i) < ' ' || byte(i) == 0x7f) return 1;
  return byte(i) == 0xc2 && byte(i + 1) >= 0x80 && byte(i + 1) < 0xa0 ? 2 : 0;
}

bool is_within_letter(char c) noexcept { return (static_cast<unsigned char>(c) & 0xc0U) == 0x80; }  // of UTF-8

// The part [begin, end) of the word at i that is not shown, as is the whole of a short one: begin == end.
struct Gap {
  std::size_t begin;
  std::size_t end;
};

Gap gap_of_word(std::string_view text, std::size_t i) noexcept {
  const std::size_t end = std::min(text.find(' ', i), text.size());
  if (end - i <= kWordBegin + kWordEnd) return {end, end};
  Gap gap{i + kWordBegin, end - kWordEnd};
  while (gap.begin > i && is_within_letter(text[gap.begin])) --gap.begin;
  while (gap.end < end && is_within_letter(text[gap.end])) ++gap.end;
  return gap;
}

bool colour() noexcept {
  const char* wish = std::getenv("NO_COLOR");
  const char* terminal = std::getenv("TERM");
  if ((wish && *wish) || (terminal && std::string_view(terminal) == "dumb")) return false;
  return isatty(STDERR_FILENO) == 1;
}

}  // namespace

void complain(std::string_view message) noexcept {
  const Hold hold;
  end_progress();
  char line[4096];
  std::size_t n = 0;
  const auto put = [&](std::string_view text) {
    for (const char c : text)
      if (n + 8 < sizeof line) line[n++] = c;
  };
  put(colour() ? "\033[1;31mtaut:\033[0m " : "taut: ");
  Gap gap = gap_of_word(message, 0);
  for (std::size_t i = 0; i < message.size(); ++i) {
    if (i == gap.begin && gap.begin < gap.end) {
      put("...");
      i = gap.end;
    }
    if (message[i] == ' ') gap = gap_of_word(message, i + 1);
    const std::size_t control = control_length(message, i);
    put(control > 0 ? "?" : message.substr(i, 1));
    if (control > 1) ++i;
  }
  put("\n");
  std::fwrite(line, 1, n, stderr);
  std::fflush(stderr);
}

std::string printable(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::size_t control = text[i] == '\n' || text[i] == '\t' ? 0 : control_length(text, i);
    out += control > 0 ? '?' : text[i];
    if (control > 1) ++i;
  }
  return out;
}

void note(std::string_view line) noexcept {
  const Hold hold;
  end_progress();
  try {
    const std::string text = printable(line) + "\n";
    std::fwrite(text.data(), 1, text.size(), stderr);
  } catch (...) {  // no memory: nothing that must be said
  }
}

bool is_progress_shown() noexcept {
  const char* terminal = std::getenv("TERM");
  return isatty(STDERR_FILENO) == 1 && !(terminal && std::string_view(terminal) == "dumb");
}

void progress(std::string_view line) noexcept {
  if (!is_progress_shown()) return note(line);
  if (ftrylockfile(stderr) != 0) return;
  const auto width = static_cast<int>(std::min(line.size(), kWidestProgress));
  const std::size_t before = progress_width.exchange(static_cast<std::size_t>(width));
  std::fprintf(stderr, "\r%-*.*s", static_cast<int>(std::max(before, static_cast<std::size_t>(width))), width,
               line.data());
  std::fflush(stderr);
  funlockfile(stderr);
}

void end_progress() noexcept {
  const auto width = static_cast<int>(progress_width.exchange(0));
  if (width == 0) return;
  std::fprintf(stderr, "\r%*s\r", width, "");
  std::fflush(stderr);
}

std::string cpu_text(const Seconds& seconds) {
  const std::string cpu = seconds_text(seconds.cpu) + " CPU";
  return seconds.cpu > 0.01 && seconds.wall < 0.9 * seconds.cpu ? cpu + ", " + seconds_text(seconds.wall) + " wall"
                                                                : cpu;
}

std::string peak_memory_text() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return fmt::format("{:.1f} MB", static_cast<double>(usage.ru_maxrss) / 1024);
}

}  // namespace taut::cli
