#include <taut/io/results/snap_json.h>

#include <taut/io/results/plane_json.h>

namespace taut {

namespace {

Json line_json(int line) { return line > 0 ? Json(line) : Json(); }

}  // namespace

Json near_json(const std::vector<NearContact>& contacts) {
  Json json = Json::array();
  for (const NearContact& c : contacts)
    json.push_back({{"end", c.end},
                    {"wall", c.wall},
                    {"distance", c.distance},
                    {"line", line_json(c.line)},
                    {"wall_line", line_json(c.wall_line)}});
  return json;
}

Json snap_json(const SnapReport& report) {
  return {{"tolerance", report.tolerance},
          {"joined", report.joined},
          {"displacement", report.displacement},
          {"remaining", near_json(report.remaining)}};
}

}  // namespace taut
