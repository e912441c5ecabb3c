// Files written whole or not at all, and stdout.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace taut::cli {

/// Writing began and failed, as on a full disk. what() is one line.
struct WriteError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Can a file of this name be made? Found out before the work begins, without touching anything. Throws InputError
/// when not: a folder, no such folder, no permission, or asked before (each output is asked for once). `-` and an empty
/// name are fine.
void require_writable(const std::string& path);

/// A pipe, a device: written directly, and where somebody has to read it, writing may take for ever.
bool is_stream(const std::string& path);

/// How long to wait until somebody reads a stream.
enum class Patience { endless, a_second };

/// Replaces the file at once: written beside it under another name, then renamed, so that nobody ever sees half of it
/// and a failure leaves the old one. Keeps an old file's owner, group and permissions and follows links. Where that
/// cannot be (a file of several hard links, or an owner that one may not give it) the old file's content is replaced
/// instead, after room was found for all of it. What is no regular file is written directly; `-` is stdout; an empty
/// name is nothing at all. Throws InputError when it cannot be made, WriteError when writing fails or nobody reads.
void write_file(const std::string& path, std::string_view bytes, Patience patience = Patience::endless);

/// Writes to stdout. Throws WriteError.
void print(std::string_view text);

/// Removes what write_file has not yet renamed. For the thread that stops the program; write_file will not go on.
void abandon_files() noexcept;

}  // namespace taut::cli
