// The robot as a program that is started here.
#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>

#include <taut/cli/mouse/robot_lines.h>
#include <taut/cli/stop.h>

namespace taut::cli {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double kFarewell = 0.5;  // s, to read the score and end
constexpr double kTerm = 0.2;      // s, from SIGTERM to SIGKILL

// In the child, between fork and exec: nothing but system calls.
[[noreturn]] void become(const char* command, int input, int output) {
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  ::dup2(input, STDIN_FILENO);
  ::dup2(output, STDOUT_FILENO);
  ::signal(SIGPIPE, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  ::execl("/bin/sh", "sh", "-c", command, static_cast<char*>(nullptr));
  ::_exit(127);
}

void close_once(int& file) {
  if (file >= 0) ::close(file);
  file = -1;
}

class ProgramLines : public RobotLines {
 public:
  ProgramLines(std::string command, double seconds) : command_(std::move(command)), seconds_(seconds) { start(); }
  ~ProgramLines() override { end(0); }

  void say(const std::string& text) override {
    // A full pipe is a robot that does not read: what it misses shows in what it does not answer.
    if (in_ >= 0 && ::write(in_, text.data(), text.size()) < 0 && errno != EAGAIN) close_once(in_);
  }
  std::string name() const override { return command_; }

  std::string ended() override {
    if (!end(1)) return "closed its output";
    if (WIFSIGNALED(status_)) return fmt::format("was ended by signal {}", WTERMSIG(status_));
    const int code = WEXITSTATUS(status_);
    return fmt::format("ended with exit code {}{}", code, code == 127 ? " (is there such a command?)" : "");
  }

  void close(const std::string& last) override {
    say(last);
    end(last.empty() ? 0 : kFarewell);
  }

 protected:
  bool more(std::string& buffer) override {
    const auto deadline = Clock::now() + std::chrono::duration<double>(seconds_);
    while (true) {
      const double left = std::chrono::duration<double>(deadline - Clock::now()).count();
      pollfd wait{out_, POLLIN, 0};
      const int ready = ::poll(&wait, 1, left > 0 ? static_cast<int>(left * 1000) + 1 : 0);
      if (ready < 0 && errno == EINTR) continue;
      if (ready == 0) refuse(fmt::format("no answer within {:g} s", seconds_));
      std::array<char, 4096> bytes;
      const ssize_t n = ::read(out_, bytes.data(), bytes.size());
      if (n < 0 && errno == EINTR) continue;
      if (n > 0) buffer.append(bytes.data(), static_cast<std::size_t>(n));
      return n > 0;
    }
  }

 private:
  void start() {
    std::array<int, 2> to{-1, -1}, from{-1, -1};
    if (::pipe2(to.data(), O_CLOEXEC) == 0 && ::pipe2(from.data(), O_CLOEXEC) == 0) pid_ = ::fork();
    if (pid_ == 0) become(command_.c_str(), to[0], from[1]);
    const int error = errno;
    close_once(to[0]);
    close_once(from[1]);
    in_ = to[1];
    out_ = from[0];
    if (pid_ < 0) {
      close_once(in_);
      close_once(out_);
      refuse(std::string("cannot be started: ") + std::strerror(error));
    }
    ::setpgid(pid_, pid_);  // whichever of the two comes first
    kill_with_us(pid_);
    ::fcntl(in_, F_SETFL, O_NONBLOCK);
  }

  bool gone_within(double seconds) {
    const auto deadline = Clock::now() + std::chrono::duration<double>(seconds);
    while (::waitpid(pid_, &status_, WNOHANG) == 0) {
      if (Clock::now() >= deadline) return false;
      ::poll(nullptr, 0, 2);
    }
    return true;
  }

  // Did it end by itself, in that time?
  bool end(double patience) {
    if (pid_ < 0) return true;
    close_once(in_);
    const bool by_itself = gone_within(patience);
    if (!by_itself) {
      ::kill(-pid_, SIGTERM);
      if (!gone_within(kTerm)) {
        ::kill(-pid_, SIGKILL);
        ::waitpid(pid_, &status_, 0);
      }
    }
    ::kill(-pid_, SIGKILL);  // what it started and left behind
    kill_with_us(0);
    close_once(out_);
    pid_ = -1;
    return by_itself;
  }

  std::string command_;
  double seconds_;
  pid_t pid_ = -1;
  int in_ = -1, out_ = -1;  // what it reads, what it writes
  int status_ = 0;
};

}  // namespace

std::unique_ptr<RobotLines> program_lines(const std::string& command, double seconds) {
  return std::make_unique<ProgramLines>(command, seconds);
}

}  // namespace taut::cli
