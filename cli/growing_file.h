// A file written piece by piece.
#pragma once

#include <string>
#include <string_view>

namespace taut::cli {

/// For what is too large to be held until it is finished: written beside the file under another name, which replaces it
/// by finish() at once; dropped unfinished, or stopped, it leaves no trace. What cannot be replaced (standard output
/// `-`, pipes and devices, files of several hard links or of another owner) is written directly. One at a time.
class GrowingFile {
 public:
  /// Throws InputError where it cannot be made.
  explicit GrowingFile(const std::string& path);
  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;
  ~GrowingFile();

  void add(std::string_view bytes);  ///< throws WriteError
  void finish();                     ///< likewise

 private:
  [[noreturn]] void fail() const;

  std::string path_;
  std::string target_;  ///< what is replaced in the end; empty where it is written directly
  int file_ = -1;
};

/// Removes the file under its other name; of the thread that stops the program.
void abandon_growing_file() noexcept;

}  // namespace taut::cli
