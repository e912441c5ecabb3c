#include <taut/cli/solve/query_source.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <system_error>

#include <taut/cli/ranks.h>
#include <taut/geometry/errors.h>
#include <taut/io/worlds/gzip.h>

namespace taut::cli {

namespace {

void require_file(const std::string& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) throw InputError(path, 0, "is a directory, not a file");
  if (!std::filesystem::exists(path, error)) throw InputError(path, 0, "no such file");
}

}  // namespace

QuerySource::QuerySource(const std::string& path) : name_(path == "-" ? "<stdin>" : path) {
  if (are_ranks_joined()) {
    unpacked_.str(bytes_for_all(path));
    in_ = &unpacked_;
  } else if (path != "-") {
    require_file(path);
    file_.open(path, std::ios::binary);
    if (!file_) throw InputError(name_, 0, std::string("cannot be opened: ") + std::strerror(errno));
    in_ = &file_;
  }
  std::error_code ignored;
  is_all_there_ = std::filesystem::is_regular_file(path == "-" ? "/dev/stdin" : path, ignored);
  if (in_->peek() == 0x1f) unpack();
}

bool QuerySource::next(std::string& line) {
  if (std::getline(*in_, line)) return true;
  if (in_->bad()) throw InputError(name_, 0, "cannot be read");
  return false;
}

std::size_t QuerySource::line_count() {
  if (in_ == &std::cin || !is_all_there_) return 0;
  const auto at = in_->tellg();
  const auto lines = std::count(std::istreambuf_iterator<char>(*in_), {}, '\n');
  in_->clear();
  in_->seekg(at);
  return static_cast<std::size_t>(lines);
}

void QuerySource::unpack() {
  std::ostringstream all;
  all << in_->rdbuf();
  unpacked_.clear();
  unpacked_.str(gunzip(all.str(), name_));
  in_ = &unpacked_;
}

}  // namespace taut::cli
