#include <taut/io/results/roadmap_json.h>

#include <taut/io/results/detail/long_list.h>
#include <taut/io/results/plane_json.h>

namespace taut {

Json roadmap_json(const Roadmap& roadmap, const std::string& kind, const std::optional<PrmConnectivity>& prm) {
  Json json{{"kind", kind}};
  if (prm) json["prm"] = prm_json(*prm);
  detail::LongList vertices, edges;
  for (const Point& p : roadmap.points()) vertices.add("[{}, {}]", p.x, p.y);
  for (Roadmap::Vertex v = 0; v < roadmap.vertex_count(); ++v)
    for (const Roadmap::Vertex w : roadmap.neighbours(v))
      if (v < w) edges.add("[{}, {}]", v, w);
  json["vertices"] = vertices.json();
  json["edges"] = edges.json();
  return json;
}

}  // namespace taut
