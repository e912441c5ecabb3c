#include <taut/cli/output.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <climits>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <mutex>
#include <set>
#include <utility>

#include <taut/cli/growing_file.h>
#include <taut/cli/messages.h>
#include <taut/geometry/errors.h>

namespace taut::cli {

namespace {

namespace fs = std::filesystem;

// The file being written under its other name. Held by a mutex that lives as long as the process.
struct Unfinished {
  std::mutex mutex;
  char name[PATH_MAX] = "";
};

Unfinished& unfinished() {
  static auto* const instance = new Unfinished;
  return *instance;
}

std::string reason() { return std::strerror(errno); }

fs::path folder_of(const fs::path& path) { return path.has_parent_path() ? path.parent_path() : fs::path("."); }

// Where a link leads, as far as it does.
fs::path resolved(const std::string& path) {
  std::error_code error;
  fs::path target = path;
  for (int hops = 0; hops < 40 && fs::is_symlink(fs::symlink_status(target, error)); ++hops) {
    const fs::path link = fs::read_symlink(target, error);
    target = link.is_absolute() ? link : folder_of(target) / link;
  }
  return target;
}

void write_all(int file, std::string_view bytes, const std::string& path) {
  while (!bytes.empty()) {
    const ssize_t n = ::write(file, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) throw WriteError(path + ": cannot write: " + reason());
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
}

void rest_a_bit() { ::usleep(10'000); }

// Of a file that does not block: what nobody takes within a second is given up.
void write_soon(int file, std::string_view bytes, const std::string& path) {
  for (int tries = 0; !bytes.empty() && tries < 100;) {
    const ssize_t n = ::write(file, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0 && errno != EAGAIN) throw WriteError(path + ": cannot write: " + reason());
    if (n > 0) bytes.remove_prefix(static_cast<std::size_t>(n));
    if (n < 0) {
      ++tries;
      rest_a_bit();
    }
  }
  if (!bytes.empty()) throw WriteError(path + ": cannot write: nobody reads it");
}

class OpenFile {
 public:
  OpenFile(int file, std::string path) : file_(file), path_(std::move(path)) {
    if (file_ < 0) throw InputError(path_, 0, "cannot write: " + reason());
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  ~OpenFile() {
    if (file_ >= 0) ::close(file_);
  }

  int file() const { return file_; }
  void close() {
    const int file = std::exchange(file_, -1);
    if (::close(file) != 0) throw WriteError(path_ + ": cannot write: " + reason());
  }

 private:
  int file_;
  std::string path_;
};

mode_t usual_permissions() {
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return 0666 & ~mask;
}

// Does the new file get the old one's owner, group and permissions? Only root may give a file away.
bool is_alike(int file, const struct stat& old) {
  struct stat now {};
  if (::fstat(file, &now) != 0) return false;
  if ((now.st_uid != old.st_uid || now.st_gid != old.st_gid) && ::fchown(file, old.st_uid, old.st_gid) != 0)
    return false;
  return ::fchmod(file, old.st_mode & 07777) == 0;
}

// Other names of the file, and its owner, keep what it holds.
void overwrite(const fs::path& target, const std::string& path, std::string_view bytes) {
  OpenFile file(::open(target.c_str(), O_WRONLY | O_CLOEXEC), path);
  const auto size = static_cast<off_t>(bytes.size());
  if (const int error = size > 0 ? ::posix_fallocate(file.file(), 0, size) : 0; error != 0)
    throw WriteError(path + ": cannot write: " + std::strerror(error));
  write_all(file.file(), bytes, path);
  if (::ftruncate(file.file(), size) != 0) throw WriteError(path + ": cannot write: " + reason());
  file.close();
}

// `old`: what is there now, if anything is.
void replace(const fs::path& target, const std::string& path, std::string_view bytes, const struct stat* old) {
  if (old && old->st_nlink > 1) return overwrite(target, path, bytes);
  Unfinished& other = unfinished();
  const std::lock_guard lock(other.mutex);
  const std::string pattern = (folder_of(target) / ".taut-XXXXXX").string();
  if (pattern.size() >= sizeof other.name) throw InputError(path, 0, "cannot write: the name is too long");
  std::strcpy(other.name, pattern.c_str());
  OpenFile file(::mkstemp(other.name), path);
  bool is_renamed = false;
  try {
    const bool fits = old ? is_alike(file.file(), *old) : ::fchmod(file.file(), usual_permissions()) == 0;
    if (!old && !fits) throw WriteError(path + ": cannot write: " + reason());
    if (fits) write_all(file.file(), bytes, path);
    file.close();
    if (fits && ::rename(other.name, target.c_str()) != 0) throw WriteError(path + ": cannot write: " + reason());
    is_renamed = fits;
  } catch (...) {
    ::unlink(other.name);
    other.name[0] = 0;
    throw;
  }
  if (!is_renamed) ::unlink(other.name);
  other.name[0] = 0;
  if (!is_renamed) overwrite(target, path, bytes);
}

// The reader of a pipe may come late, or never.
int opened_soon(const std::string& path) {
  for (int tries = 0;; ++tries) {
    const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NONBLOCK);
    if (file >= 0 || errno != ENXIO) return file;
    if (tries == 100) throw WriteError(path + ": cannot write: nobody reads it");
    rest_a_bit();
  }
}

void write_stream(const std::string& path, std::string_view bytes, Patience patience) {
  const bool hurries = patience == Patience::a_second;
  OpenFile file(hurries ? opened_soon(path) : ::open(path.c_str(), O_WRONLY | O_CLOEXEC), path);
  hurries ? write_soon(file.file(), bytes, path) : write_all(file.file(), bytes, path);
  file.close();
}

}  // namespace

namespace {

void refuse_unwritable(const std::string& path) {
  const auto refuse = [&](const std::string& why) { throw InputError(path, 0, "cannot write: " + why); };
  std::error_code error;
  const fs::file_status status = fs::status(path, error);             // through links, /dev/stdout among them
  if (status.type() == fs::file_type::none) refuse(error.message());  // links in a circle
  if (fs::is_directory(status) || !fs::path(path).has_filename()) refuse("it is a folder");
  if (fs::exists(status) && ::access(path.c_str(), W_OK) != 0) refuse(reason());
  if (fs::exists(status) && !fs::is_regular_file(status)) return;
  const fs::path folder = folder_of(resolved(path));
  if (!fs::is_directory(folder, error)) refuse("there is no folder " + folder.string());
  if (::access(folder.c_str(), W_OK | X_OK) != 0) refuse(reason());
}

}  // namespace

void require_writable(const std::string& path) {
  static std::set<fs::path> promised;
  if (path.empty() || path == "-") return;
  refuse_unwritable(path);
  std::error_code error;
  if (fs::is_other(path, error)) return;  // /dev/null
  if (!promised.insert(fs::weakly_canonical(resolved(path), error)).second)
    throw InputError(path, 0, "cannot write: two outputs have this name");
}

bool is_stream(const std::string& path) {
  struct stat old {};
  return !path.empty() && path != "-" && ::stat(path.c_str(), &old) == 0 && !S_ISREG(old.st_mode);
}

void write_file(const std::string& path, std::string_view bytes, Patience patience) {
  if (path.empty()) return;
  if (path == "-") return print(bytes);
  refuse_unwritable(path);
  if (is_stream(path)) return write_stream(path, bytes, patience);
  struct stat old {};
  const bool exists = ::stat(path.c_str(), &old) == 0;
  replace(resolved(path), path, bytes, exists ? &old : nullptr);
}

void print(std::string_view text) {
  end_progress();
  write_all(STDOUT_FILENO, text, "<stdout>");
}

void abandon_files() noexcept {
  // Not locked: the writer may be in the middle, and the process ends right after this.
  if (const char* name = unfinished().name; *name) ::unlink(name);
  abandon_growing_file();
}

}  // namespace taut::cli
