#include <taut/cli/world/foreign.h>

#include <algorithm>

namespace taut::cli {

namespace {

std::string_view reader_of(FileKind kind) {
  switch (kind) {
    case FileKind::unknown: return "";
    case FileKind::world: return "`taut solve` reads it";
    case FileKind::cost_map: return "`taut chase` reads it";
    case FileKind::roadblock_map: return "`taut drive` reads it";
    case FileKind::grid_csv: return "`taut grid solve` reads it";
    case FileKind::scenarios: return "`taut grid scen MAP SCEN` and `taut batch MAP SCEN` read it";
    case FileKind::certificate: return "`taut mouse check MAZE --certificate` reads it";
    case FileKind::saved_roadmap: return "`taut solve MAZE --load` reads it";
    case FileKind::result: return "`taut check MAZE --path` reads what `taut solve` wrote";
  }
  return "";
}

}  // namespace

void redirect(std::string_view bytes, const std::string& source, std::initializer_list<FileKind> own) {
  const FileKind kind = file_kind(bytes);
  if (kind == FileKind::unknown || std::ranges::find(own, kind) != own.end()) return;
  throw InputError(source, 0, std::string("is ").append(name(kind)).append(": ").append(reader_of(kind)));
}

}  // namespace taut::cli
