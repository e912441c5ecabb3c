#include <taut/cli/view/server.h>

#include <dlfcn.h>

#include <exception>
#include <filesystem>
#include <string>
#include <system_error>

#include <taut/cli/stop.h>
#include <taut/geometry/errors.h>

namespace taut::cli {

namespace {

/// Beside the program, or where it is installed; empty: nowhere.
std::string module_path() {
  std::error_code error;
  const std::filesystem::path folder = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
  if (error) return {};
  for (const char* place : {"", TAUT_MODULE_FOLDER})
    if (const auto path = folder / place / kPageServer; std::filesystem::exists(path, error)) return path.string();
  return {};
}

ServePage* loaded() {
  void* const module = dlopen(module_path().c_str(), RTLD_NOW | RTLD_LOCAL);  // until the program ends
  void* const found = module == nullptr ? nullptr : dlsym(module, kServePage);
  if (found == nullptr) throw InputError("", 0, std::string("the server cannot be loaded: ") + dlerror());
  return reinterpret_cast<ServePage*>(found);
}

}  // namespace

bool can_serve() { return !module_path().empty(); }

std::size_t serve(const PageServing& serving) {
  ServePage* const serve_page = loaded();
  try {
    return serve_page(serving);
  } catch (const std::runtime_error& error) {
    throw InputError("", 0, error.what());
  }
}

}  // namespace taut::cli
