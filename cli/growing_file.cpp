#include <taut/cli/growing_file.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <climits>
#include <cstring>
#include <filesystem>
#include <utility>

#include <taut/cli/output.h>
#include <taut/geometry/errors.h>

namespace taut::cli {

namespace {

// The one under its other name; lives as long as the process.
char unfinished[PATH_MAX] = "";

std::string target_of(const std::string& path) {
  std::error_code error;
  const std::filesystem::path target = std::filesystem::weakly_canonical(path, error);
  return error ? path : target.string();
}

bool is_replaceable(const std::string& path, const struct stat* old) {
  return path != "-" && !is_stream(path) && (!old || (old->st_nlink == 1 && old->st_uid == ::geteuid()));
}

int made_beside(const std::string& target, const struct stat* old) {
  const std::string pattern = (std::filesystem::path(target).parent_path() / ".taut-XXXXXX").string();
  if (pattern.size() >= sizeof unfinished) return errno = ENAMETOOLONG, -1;
  std::strcpy(unfinished, pattern.c_str());
  const int file = ::mkstemp(unfinished);
  if (file < 0) unfinished[0] = 0;
  if (file < 0) return file;
  const mode_t mask = ::umask(0);
  ::umask(mask);
  ::fchmod(file, old ? old->st_mode & 07777 : 0666 & ~mask);
  return file;
}

}  // namespace

GrowingFile::GrowingFile(const std::string& path) : path_(path) {
  struct stat found {};
  const struct stat* old = path != "-" && ::stat(path.c_str(), &found) == 0 ? &found : nullptr;
  if (is_replaceable(path, old)) {
    target_ = target_of(path);
    file_ = made_beside(target_, old);
  } else {
    file_ = path == "-" ? ::dup(STDOUT_FILENO) : ::open(path.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC);
  }
  if (file_ < 0) throw InputError(path, 0, std::string("cannot write: ") + std::strerror(errno));
}

GrowingFile::~GrowingFile() {
  if (file_ < 0) return;
  ::close(file_);
  if (!target_.empty()) abandon_growing_file();
}

void GrowingFile::fail() const {
  throw WriteError((path_ == "-" ? "<stdout>" : path_) + ": cannot write: " + std::strerror(errno));
}

void GrowingFile::add(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::write(file_, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail();
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
}

void GrowingFile::finish() {
  const int file = std::exchange(file_, -1);
  const bool is_closed = ::close(file) == 0;
  const bool is_in_place = is_closed && (target_.empty() || ::rename(unfinished, target_.c_str()) == 0);
  const int why = errno;
  if (!target_.empty() && !is_in_place) abandon_growing_file();
  unfinished[0] = 0;
  errno = why;
  if (!is_in_place) fail();
}

void abandon_growing_file() noexcept {
  if (*unfinished) ::unlink(unfinished);
  unfinished[0] = 0;
}

}  // namespace taut::cli
