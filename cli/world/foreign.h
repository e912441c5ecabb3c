// Files that were given to the wrong subcommand.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

#include <taut/geometry/errors.h>
#include <taut/io/worlds/file_kind.h>

namespace taut::cli {

/// Throws InputError where these bytes are something that another subcommand reads: `is a cost map: taut chase reads
/// it`. `own`: the kinds that are read here.
void redirect(std::string_view bytes, const std::string& source, std::initializer_list<FileKind> own);

/// What `read` gives; where it refuses what another subcommand reads, redirect() speaks instead.
template <typename Read>
auto read_own(std::string_view bytes, const std::string& source, std::initializer_list<FileKind> own, Read read) {
  try {
    return read();
  } catch (const InputError&) {
    redirect(bytes, source, own);
    throw;
  }
}

}  // namespace taut::cli
