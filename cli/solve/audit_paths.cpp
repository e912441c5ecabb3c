// taut audit: paths of a point, a disc or a square.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <taut/cli/solve/audit.h>
#include <taut/cli/solve/certify.h>
#include <taut/cli/world/claimed_length.h>
#include <taut/geometry/errors.h>
#include <taut/io/pictures/svg.h>
#include <taut/io/results/words.h>
#include <taut/io/worlds/read_path.h>
#include <taut/search/path_audit.h>
#include <taut/search/shortest_path.h>
#include <taut/search/verify_arcs.h>

namespace taut::cli {

namespace {

struct Audited {
  ClaimedPath plan;
  PathAudit audit;
  std::optional<double> clearance{};  ///< when it is known and there are walls
  double length = 0;
  std::optional<ShortestLength> shortest{};
  std::optional<double> bound{};  ///< that the judge of certificates confirmed

  double gap() const { return std::max(0.0, length - shortest->value); }
};

class PathsAudit {
 public:
  PathsAudit(const AuditOptions& options, const Input& input, std::string name, Run& run)
      : options_(options), input_(input), name_(std::move(name)), run_(run), robot_(options.robot) {}

  int judge(std::string_view bytes) {
    std::vector<ClaimedPath> plans = read_paths(bytes, name_, Breaks::blank_lines);
    std::vector<Point> places;
    for (const ClaimedPath& plan : plans) {
      places.insert(places.end(), plan.points.begin(), plan.points.end());
      if (plan.arcs && robot_.kind() == Footprint::Kind::point) robot_ = Footprint::disc(plan.arcs->radius);
    }
    const PathAuditor auditor = run_.stage("space", [&] { return PathAuditor(input_.world, robot_, places); });
    for (ClaimedPath& plan : plans) {
      audited_.push_back(audit(std::move(plan), auditor));
      keeping_.tell([&] { run_.so_far(result(auditor), lines()); });
    }
    return end(auditor);
  }

 private:
  Audited audit(ClaimedPath plan, const PathAuditor& auditor) {
    Audited one{.plan = std::move(plan), .audit = {}};
    run_.stage("verify", [&] { one.plan.arcs ? audit_arcs(one, auditor) : audit_legs(one, auditor); });
    if (one.audit.valid && options_.ends) require_ends_of(one);
    if (one.audit.valid && !options_.no_gap) find_gap(one, auditor);
    return one;
  }

  static void audit_legs(Audited& one, const PathAuditor& auditor) {
    one.audit = auditor.audit(one.plan.points);
    one.length = one.audit.length.value();
    if (!one.audit.valid) return;
    if (std::isfinite(one.audit.clearance)) one.clearance = one.audit.clearance;
    refuse_where(one, false_claim(one.plan, one.audit.length));
  }

  static void audit_arcs(Audited& one, const PathAuditor& auditor) {
    const ArcPath& path = *one.plan.arcs;
    const ArcVerdict verdict = verify_arcs(path, Gates(auditor.space()), path.start, path.goal);
    one.audit.valid = verdict.valid;
    one.audit.reason = verdict.reason;
    one.length = path.value();
  }

  static void refuse_where(Audited& one, std::string reason) {
    if (reason.empty()) return;
    one.audit.valid = false;
    one.audit.reason = std::move(reason);
  }

  static Point first(const Audited& one) { return one.plan.arcs ? one.plan.arcs->start : one.plan.points.front(); }
  static Point last(const Audited& one) { return one.plan.arcs ? one.plan.arcs->goal : one.plan.points.back(); }

  void require_ends_of(Audited& one) const {
    const std::optional<Point>& start = input_.world.start();
    const Goal& goal = input_.world.goal();
    if (start && first(one) != *start)
      return refuse_where(one, fmt::format("it starts at {}, not at {}", point_text(first(one)), point_text(*start)));
    const auto holds = [&](const Box& box) { return box.contains(last(one)); };
    if ((!goal.point && goal.room.empty()) || goal.point == last(one) || std::ranges::any_of(goal.room, holds)) return;
    refuse_where(one, fmt::format("it ends at {}, not in the goal", point_text(last(one))));
  }

  void find_gap(Audited& one, const PathAuditor& auditor) {
    one.shortest = run_.stage("shortest", [&] { return auditor.shortest(first(one), last(one)); });
    if (!options_.prove || !one.shortest) return;
    PlanResult result;
    result.status = SearchStatus::found;
    result.path = *shortest_path(auditor.space(), first(one), last(one));
    result.start = first(one);
    result.goal.point = last(one);
    const Certified proof = certified(auditor.space(), result, true, run_);
    if (!proof.text.empty()) one.bound = proof.bound;
  }

  std::size_t invalid() const {
    return static_cast<std::size_t>(std::ranges::count_if(audited_, [](auto& one) { return !one.audit.valid; }));
  }

  std::string text_of(const Audited& one) const {
    if (!one.audit.valid) {
      std::string line = "not valid: " + one.audit.reason;
      if (one.audit.contact)
        line += fmt::format("; first at {}, {}", point_text(one.audit.contact->at), text(one.audit.contact->wall));
      return line;
    }
    std::string line = fmt::format("valid, length {:.6f}", one.length);
    if (one.clearance) line += fmt::format(", clearance {}", number_text(*one.clearance));
    if (!one.shortest) return line;
    if (one.gap() == 0) return line + ", no path is shorter" + proven(one);
    return line + fmt::format(", {:.6g} ({:.4g} %) longer than the shortest{}", one.gap(),
                              100 * one.gap() / one.shortest->value, proven(one));
  }

  std::string proven(const Audited& one) const {
    if (!options_.prove) return "";
    return one.bound ? ", proven" : ", without a proof";
  }

  std::string lines() const {
    std::string out;
    std::size_t named = 0;
    for (std::size_t i = 0; i < audited_.size(); ++i) {
      if (audited_.size() > kPlansNamed && (audited_[i].audit.valid || named++ >= kPlansNamed)) continue;
      out += fmt::format("{}: path {}: {}\n", name_, i + 1, text_of(audited_[i]));
    }
    const std::size_t wrong = invalid();
    return out + fmt::format("{}: {}, {} valid, {} not\n", name_, count_text(audited_.size(), "path"),
                             audited_.size() - wrong, wrong);
  }

  static Json json_of(const PathContact& contact) {
    return {{"leg", contact.leg}, {"at", contact.at}, {"on", contact.on}, {"wall", wall_json(contact.wall)}};
  }

  static Json json_of(const Audited& one) {
    Json json{{"valid", one.audit.valid},
              {"reason", one.audit.valid ? Json() : Json(one.audit.reason)},
              {"contact", one.audit.contact ? json_of(*one.audit.contact) : Json()},
              {"points", one.plan.points.size()},
              {"length", one.length},
              {"clearance", one.clearance},
              {"nearest", one.audit.nearest ? wall_json(*one.audit.nearest) : Json()},
              {"shortest", one.shortest ? Json(one.shortest->value) : Json()},
              {"gap", one.shortest ? Json(one.gap()) : Json()},
              {"bound", one.bound}};
    return json;
  }

  Json result(const PathAuditor& auditor) const {
    Json plans = Json::array();
    for (const Audited& one : audited_) plans.push_back(json_of(one));
    return {{"kind", "paths"},
            {"plans", std::move(plans)},
            {"valid", audited_.size() - invalid()},
            {"invalid", invalid()},
            {"displacement", auditor.space().report().displacement}};
  }

  std::string picture(const PathAuditor& auditor) const {
    SvgPicture picture;
    picture.title = title_of(name_);
    picture.facts = {count_text(audited_.size(), "path"), fmt::format("{} not valid", invalid())};
    std::vector<Path> paths;
    for (const Audited& one : audited_) {
      SvgShade shade{{}, one.audit.valid ? 0.2 : 0.9};
      for (std::size_t i = 0; i + 1 < one.plan.points.size(); ++i) {
        const Point a = one.plan.points[i], b = one.plan.points[i + 1];
        shade.curves.push_back({a, {a.x / 2 + b.x / 2, a.y / 2 + b.y / 2}, b});
      }
      if (!shade.curves.empty()) picture.shades.push_back(std::move(shade));
      if (!one.audit.contact) continue;
      const PathContact& contact = *one.audit.contact;
      picture.separation.push_back(contact.wall.side);
      picture.labels.push_back({contact.on, fmt::format("{}", &one - audited_.data() + 1)});
      if (robot_.kind() == Footprint::Kind::disc) picture.discs.push_back({contact.at, robot_.radius()});
    }
    picture.start = input_.world.start();
    picture.goal = input_.world.goal();
    return svg(auditor.space(), picture);
  }

  std::string fault() const {
    for (const Audited& one : audited_)
      if (!one.audit.valid)
        return fmt::format("path {}: {}{}", &one - audited_.data() + 1, one.audit.reason,
                           invalid() > 1 ? fmt::format("; {} not valid in all", invalid()) : "");
    return {};
  }

  int end(const PathAuditor& auditor) {
    Answer answer{.outcome = invalid() > 0 ? Outcome::invalid : Outcome::done,
                  .reason = fault(),
                  .result = result(auditor),
                  .line = lines()};
    if (!options_.svg.empty()) answer.files.push_back({options_.svg, picture(auditor)});
    return run_.end(std::move(answer));
  }

  const AuditOptions& options_;
  const Input& input_;
  std::string name_;
  Run& run_;
  Footprint robot_;
  std::vector<Audited> audited_;
  Keeping keeping_;
};

}  // namespace

int audit_paths(const AuditOptions& options, const Input& input, std::string_view bytes, const std::string& name,
                Run& run) {
  return PathsAudit(options, input, name, run).judge(bytes);
}

}  // namespace taut::cli
