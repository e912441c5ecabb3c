#include <taut/cli/mouse/robot_lines.h>

#include <unistd.h>

#include <cerrno>

#include <taut/cli/output.h>
#include <taut/geometry/errors.h>

namespace taut::cli {

namespace {

constexpr std::size_t kLongest = 1000;

class StandardLines : public RobotLines {
 public:
  void say(const std::string& text) override { print(text); }
  std::string name() const override { return "<stdin>"; }
  std::string ended() override { return "ends"; }
  void close(const std::string&) override {}

 protected:
  bool more(std::string& buffer) override {
    char bytes[512];
    ssize_t n = 0;
    do n = ::read(STDIN_FILENO, bytes, sizeof bytes);
    while (n < 0 && errno == EINTR);
    if (n < 0) refuse("cannot be read");
    buffer.append(bytes, static_cast<std::size_t>(n));
    return n > 0;
  }
};

}  // namespace

bool RobotLines::next(std::string& line) {
  ++number_;
  std::size_t end = 0;
  while ((end = buffer_.find('\n')) == std::string::npos) {
    if (buffer_.size() > kLongest) refuse("the line is too long");
    if (!more(buffer_)) break;
  }
  if (end == std::string::npos && buffer_.empty()) return false;
  line = buffer_.substr(0, end);
  buffer_.erase(0, end == std::string::npos ? end : end + 1);
  return true;
}

void RobotLines::refuse(const std::string& why) const {
  throw InputError(name(), static_cast<std::size_t>(number_), why);
}

std::unique_ptr<RobotLines> standard_lines() { return std::make_unique<StandardLines>(); }

}  // namespace taut::cli
