#include <taut/io/saved/index_file.h>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <memory>
#include <span>
#include <stdexcept>
#include <string_view>

#include <taut/geometry/errors.h>
#include <taut/io/saved/detail/saved_words.h>
#include <taut/io/saved/roadmap_file.h>

namespace taut {

namespace {

constexpr std::string_view kMagic = "taut index ";
constexpr int kVersion = 1;
constexpr std::size_t kAligned = 64;
constexpr std::size_t kLongest = 1 << 16;  // of the lines

/// A file's bytes for as long as this lives.
class Mapping {
 public:
  explicit Mapping(const std::string& path) {
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    struct stat status {};
    if (file < 0 || ::fstat(file, &status) != 0) fail(path, file, std::strerror(errno));
    if (!S_ISREG(status.st_mode)) fail(path, file, "is no regular file");
    size_ = static_cast<std::size_t>(status.st_size);
    if (size_ > 0) bytes_ = ::mmap(nullptr, size_, PROT_READ, MAP_PRIVATE, file, 0);
    if (bytes_ == MAP_FAILED) fail(path, file, std::strerror(errno));
    ::close(file);
  }
  Mapping(const Mapping&) = delete;
  Mapping& operator=(const Mapping&) = delete;
  ~Mapping() {
    if (bytes_) ::munmap(bytes_, size_);
  }

  std::string_view text() const { return {static_cast<const char*>(bytes_), size_}; }

 private:
  [[noreturn]] static void fail(const std::string& path, int file, const char* why) {
    const std::string reason = why;
    if (file >= 0) ::close(file);
    throw InputError(path, 0, file < 0 ? "cannot be opened: " + reason : reason);
  }

  void* bytes_ = nullptr;
  std::size_t size_ = 0;
};

/// What stands behind the key in the next line.
std::string value(std::string_view& rest, std::string_view key, const std::string& name) {
  const std::size_t end = rest.substr(0, kLongest).find('\n');
  if (end == std::string_view::npos || !rest.starts_with(key))
    throw InputError(name, 0, fmt::format("is damaged: '{}' should stand in its head", key));
  const std::string_view line = rest.substr(0, end);
  rest.remove_prefix(end + 1);
  return std::string(line.substr(std::min(line.size(), key.size() + 1)));
}

std::size_t aligned(std::size_t size) { return (size + kAligned - 1) / kAligned * kAligned; }

}  // namespace

std::string index_file(const Index& index) {
  const FreeSpace& space = index.space();
  std::string file = fmt::format("{}{}\nsource {}\nworld {}\nrobot {}\nend\n", kMagic, kVersion,
                                 detail::one_line(space.world().source()), fingerprint(space.world()),
                                 detail::robot_text(space.footprint()));
  file.resize(aligned(file.size()), ' ');
  const auto* bytes = reinterpret_cast<const char*>(index.bytes().data());
  return file.append(bytes, index.bytes().size());
}

Index load_index(const std::string& path, const FreeSpace& space) {
  const auto mapping = std::make_shared<const Mapping>(path);
  std::string_view rest = mapping->text();
  if (!rest.starts_with(kMagic)) throw InputError(path, 0, "is no saved index");
  const std::string version = value(rest, kMagic.substr(0, kMagic.size() - 1), path);
  if (version != std::to_string(kVersion))
    throw InputError(path, 0,
                     fmt::format("is a saved index of version {}; this program reads version {}",
                                 detail::one_line(version.substr(0, 20)), kVersion));
  const std::string source = value(rest, "source", path), world = value(rest, "world", path),
                    robot = value(rest, "robot", path);
  value(rest, "end", path);
  detail::require_same_world(path, space, source, world, robot);
  const std::size_t head = aligned(mapping->text().size() - rest.size());
  const std::span all(reinterpret_cast<const std::byte*>(mapping->text().data()), mapping->text().size());
  try {
    return Index(space, all.subspan(std::min(head, all.size())), mapping);
  } catch (const InputError&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw InputError(path, 0, error.what());
  }
}

}  // namespace taut
