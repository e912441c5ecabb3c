#include <taut/io/pictures/rasterised.h>

#ifdef TAUT_HAS_RSVG

#include <dlfcn.h>
#include <librsvg/rsvg.h>
#include <sys/mman.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <new>

namespace taut {

namespace {

constexpr double kFiner = 2, kLongestSide = 8192;
constexpr std::size_t kRoom = std::size_t{640} << 20;  // of address space: libraries, fonts, the picture take 460 MB

// The functions of librsvg and of what it stands on, found by name. Never unloaded: GLib cannot be.
struct Rsvg {
  void* library = dlopen("librsvg-2.so.2", RTLD_NOW | RTLD_LOCAL);
  std::string fault;

  template <typename Function>
  Function* find(Function*& function, const char* name) {
    function = library ? reinterpret_cast<Function*>(dlsym(library, name)) : nullptr;
    if (!function && fault.empty()) {
      const char* const why = dlerror();
      fault = "librsvg cannot be loaded: " + std::string(why ? why : name);
    }
    return function;
  }

#define TAUT_FUNCTION(name) decltype(::name)* name = find(name, #name)
  TAUT_FUNCTION(rsvg_handle_new_with_flags);
  TAUT_FUNCTION(rsvg_handle_read_stream_sync);
  TAUT_FUNCTION(rsvg_handle_get_intrinsic_size_in_pixels);
  TAUT_FUNCTION(rsvg_handle_render_document);
  TAUT_FUNCTION(g_memory_input_stream_new_from_data);
  TAUT_FUNCTION(g_object_unref);
  TAUT_FUNCTION(g_error_free);
  TAUT_FUNCTION(g_log_set_default_handler);
  TAUT_FUNCTION(cairo_image_surface_create);
  TAUT_FUNCTION(cairo_create);
  TAUT_FUNCTION(cairo_status);
  TAUT_FUNCTION(cairo_status_to_string);
  TAUT_FUNCTION(cairo_destroy);
  TAUT_FUNCTION(cairo_surface_destroy);
  TAUT_FUNCTION(cairo_surface_write_to_png_stream);
#undef TAUT_FUNCTION
};

const Rsvg& rsvg() {
  static const Rsvg functions;
  return functions;
}

// GLib ends the program when it gets no memory; so it must not come to that.
void require_room() {
  void* const room = mmap(nullptr, kRoom, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (room == MAP_FAILED) throw std::bad_alloc();
  munmap(room, kRoom);
}

void say_nothing(const char*, GLogLevelFlags, const char*, void*) {}

struct Free {
  void operator()(void* object) const { rsvg().g_object_unref(object); }
  void operator()(cairo_t* context) const { rsvg().cairo_destroy(context); }
  void operator()(cairo_surface_t* surface) const { rsvg().cairo_surface_destroy(surface); }
};
template <typename Object>
using Owned = std::unique_ptr<Object, Free>;

void require(bool well, GError* error, const char* what) {
  if (well) return;
  const std::string why = error ? error->message : "no reason given";
  if (error) rsvg().g_error_free(error);
  throw RasterError(std::string(what) + ": " + why);
}

void require(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS)
    throw RasterError(std::string("cannot draw pixels: ") + rsvg().cairo_status_to_string(status));
}

Owned<RsvgHandle> handle_of(const std::string& svg) {
  Owned<RsvgHandle> handle(rsvg().rsvg_handle_new_with_flags(RSVG_HANDLE_FLAG_UNLIMITED));
  const Owned<GInputStream> bytes(
      rsvg().g_memory_input_stream_new_from_data(svg.data(), static_cast<gssize>(svg.size()), nullptr));
  GError* error = nullptr;
  const bool well = rsvg().rsvg_handle_read_stream_sync(handle.get(), bytes.get(), nullptr, &error) != 0;
  require(well, error, "the picture cannot be read");
  return handle;
}

cairo_status_t append(void* out, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(out)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

}  // namespace

std::string why_not_rasterised() { return rsvg().fault; }

std::string rasterised(const std::string& svg) {
  require_room();
  if (!rsvg().fault.empty()) throw RasterError(rsvg().fault);
  rsvg().g_log_set_default_handler(say_nothing, nullptr);
  const Owned<RsvgHandle> handle = handle_of(svg);
  double width = 0, height = 0;
  if (!rsvg().rsvg_handle_get_intrinsic_size_in_pixels(handle.get(), &width, &height) || !(width > 0 && height > 0))
    throw RasterError("the picture has no size");
  const double scale = std::min(kFiner, kLongestSide / std::max(width, height));
  const RsvgRectangle page{0, 0, std::ceil(width * scale), std::ceil(height * scale)};
  const Owned<cairo_surface_t> surface(rsvg().cairo_image_surface_create(
      CAIRO_FORMAT_ARGB32, static_cast<int>(page.width), static_cast<int>(page.height)));
  const Owned<cairo_t> context(rsvg().cairo_create(surface.get()));
  require(rsvg().cairo_status(context.get()));
  GError* error = nullptr;
  const bool well = rsvg().rsvg_handle_render_document(handle.get(), context.get(), &page, &error) != 0;
  require(well, error, "the picture cannot be drawn");
  std::string png;
  require(rsvg().cairo_surface_write_to_png_stream(surface.get(), append, &png));
  return png;
}

}  // namespace taut

#else

namespace taut {

std::string why_not_rasterised() { return "this taut was built without librsvg"; }

std::string rasterised(const std::string&) { throw RasterError(why_not_rasterised()); }

}  // namespace taut

#endif
