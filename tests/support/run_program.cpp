#include "support/run_program.h"

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <thread>

#include "support/paths.h"
#include "support/sanitized.h"

namespace taut::test {

namespace {

namespace fs = std::filesystem;

std::string in_quotes(const fs::path& path) { return "'" + path.string() + "'"; }

int wait_for(pid_t child) {
  int status = 0;
  if (waitpid(child, &status, 0) != child) throw std::runtime_error("cannot wait for the program");
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

Folder::Folder() {
  std::string pattern = (fs::temp_directory_path() / "taut-test-XXXXXX").string();
  if (!mkdtemp(pattern.data())) throw std::runtime_error("cannot make a folder " + pattern);
  path_ = pattern;
}

Folder::~Folder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::string Folder::file(std::string_view name, std::string_view bytes) const {
  const fs::path path = path_ / name;
  std::ofstream(path, std::ios::binary) << bytes;
  return path.string();
}

std::string data_file(std::string_view name) { return (data_dir() / name).string(); }

std::string contents(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

Outcome run_taut(const std::string& arguments, std::string_view input, double interrupt_after) {
  return run_script("exec \"$taut\" " + arguments, input, interrupt_after);
}

Outcome run_script(const std::string& script, std::string_view input, double interrupt_after) {
  const Folder folder;
  const std::string line = "exec <" + in_quotes(folder.file("in", input)) + " >" + in_quotes(folder / "out") + " 2>" +
                           in_quotes(folder / "err") + "\ntaut=" + in_quotes(program().value()) + "\n" + script;
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("cannot fork");
  if (child == 0) {
    std::signal(SIGINT, SIG_DFL);
    setenv("TAUT_PROGRESS", "0", 1);  // on a busy machine anything takes long
    execl("/bin/sh", "sh", "-c", line.c_str(), static_cast<char*>(nullptr));
    _exit(127);
  }
  if (interrupt_after > 0) {
    std::this_thread::sleep_for(std::chrono::duration<double>(kSanitized ? 10 * interrupt_after : interrupt_after));
    kill(child, SIGINT);
  }
  const int code = wait_for(child);
  return {code, contents(folder / "out"), contents(folder / "err")};
}

}  // namespace taut::test
