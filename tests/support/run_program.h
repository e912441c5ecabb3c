// Runs the program `taut` as its users do.
#pragma once

#include <string>
#include <string_view>

#include <filesystem>

namespace taut::test {

/// An empty folder of its own, gone with the object.
class Folder {
 public:
  Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder();

  std::filesystem::path operator/(std::string_view name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }
  /// Writes a file and gives its path.
  std::string file(std::string_view name, std::string_view bytes) const;

 private:
  std::filesystem::path path_;
};

struct Outcome {
  int code = -1;  ///< exit code; 128 + n when ended by signal n
  std::string out;
  std::string err;
};

/// `taut ARGUMENTS`, words separated and quoted as in a shell; redirections work. SIGINT is sent after
/// `interrupt_after` seconds when > 0.
Outcome run_taut(const std::string& arguments, std::string_view input = {}, double interrupt_after = 0);

/// A script for /bin/sh, in which "$taut" is the program.
Outcome run_script(const std::string& script, std::string_view input = {}, double interrupt_after = 0);

/// A file of data/, as an argument.
std::string data_file(std::string_view name);

std::string contents(const std::filesystem::path& file);

}  // namespace taut::test
