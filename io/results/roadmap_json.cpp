#include <taut/io/results/roadmap_json.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <iterator>

#include <taut/io/results/detail/result_values.h>

namespace taut {

namespace {

std::string quoted(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace

// Written by hand: a tree of millions of edges would take gigabytes.
std::string roadmap_json(const Roadmap& roadmap, const std::string& kind, const std::string& source, double seconds,
                         const std::optional<PrmConnectivity>& prm) {
  fmt::memory_buffer out;
  const auto put = std::back_inserter(out);
  fmt::format_to(put, "{{\n  \"program\": \"taut\",\n  \"kind\": {},\n  \"source\": {},\n  \"seconds\": {},\n",
                 quoted(kind), quoted(source), seconds);
  if (prm) fmt::format_to(put, "  \"prm\": {},\n", detail::json_of(*prm).dump());
  fmt::format_to(put, "  \"vertices\": [");
  const char* separator = "\n    ";
  for (const Point& p : roadmap.points()) {
    fmt::format_to(put, "{}[{}, {}]", separator, p.x, p.y);
    separator = ",\n    ";
  }
  fmt::format_to(put, "\n  ],\n  \"edges\": [");
  separator = "\n    ";
  for (Roadmap::Vertex v = 0; v < roadmap.vertex_count(); ++v)
    for (const Roadmap::Vertex w : roadmap.neighbours(v)) {
      if (w <= v) continue;
      fmt::format_to(put, "{}[{}, {}]", separator, v, w);
      separator = ",\n    ";
    }
  fmt::format_to(put, "\n  ]\n}}\n");
  return {out.data(), out.size()};
}

}  // namespace taut
