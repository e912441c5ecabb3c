#include <taut/io/pictures/detail/mouse_film.h>

#include <fmt/format.h>

#include <algorithm>

#include <taut/io/pictures/detail/svg_path.h>

namespace taut::detail {

namespace {

using micromouse::MousePose;
using micromouse::Record;
using micromouse::Step;

constexpr double kPause = 3;    // s, before it begins again
constexpr double kTurn = 0.35;  // of a step

std::string number(double key) {
  std::string text = fmt::format("{:.5f}", std::min(key, 1.0));
  text.erase(text.find_last_not_of('0') + 1);
  return text.ends_with('.') ? text.substr(0, text.size() - 1) : text;
}

std::string position(const MouseSheet& sheet, Cell cell) {
  const Point p = sheet.pixel(cell);
  return svg_number(p.x) + " " + svg_number(p.y);
}

}  // namespace

double degrees(Side heading) { return 90.0 * static_cast<int>(heading); }

MousePose last_pose(const Record& record) {
  return record.steps.empty() ? MousePose{record.task.start, Side::north} : record.steps.back().after;
}

/// Values and their key times.
struct MouseFilm::Track {
  std::string values, keys, last;

  void add(double key, const std::string& value) {
    values += (values.empty() ? "" : ";") + value;
    keys += (keys.empty() ? "" : ";") + number(keys.empty() ? 0 : key);
    last = value;
  }
  void end() {
    if (!last.empty()) add(1, last);
  }
};

MouseFilm::MouseFilm(const Record& record) : record_(record) {
  const double steps = static_cast<double>(std::max<std::size_t>(record.steps.size(), 1));
  step_ = std::clamp(60 / steps, 0.1, 0.4);
  total_ = steps * step_ + kPause;
}

std::string MouseFilm::from(double steps) const { return steps <= 0 ? "" : shown("0;1", "0;" + number(key(steps))); }

std::string MouseFilm::between(double steps, double end) const {
  if (steps <= 0) return shown("1;0", "0;" + number(key(end)));
  return shown("0;1;0", "0;" + number(key(steps)) + ";" + number(key(end)));
}

std::string MouseFilm::mouse(const MouseSheet& sheet) const {
  Track at, turn;
  double angle = 0;
  for (std::size_t i = 0; i < record_.steps.size(); ++i) {
    const Step& s = record_.steps[i];
    const double begin = static_cast<double>(i), end = begin + 1;
    const int rotation = s.action.reset || s.before.heading == s.after.heading ? 0 : s.action.rotation;
    at.add(key(begin), position(sheet, s.before.cell));
    turn.add(key(begin), svg_number(angle));
    if (rotation != 0) at.add(key(begin + kTurn), position(sheet, s.before.cell));
    turn.add(key(begin + kTurn), svg_number(angle += rotation));
    if (s.run == 1 && s.action.reset && s.after.cell != s.before.cell) {
      at.add(key(end), position(sheet, s.before.cell));
      turn.add(key(end), svg_number(angle));
    }
    if (s.action.reset && s.offence == micromouse::Offence::none) angle = 0;
    at.add(key(end), position(sheet, s.after.cell));
    turn.add(key(end), svg_number(angle));
  }
  const MousePose last = last_pose(record_);
  at.end();
  turn.end();
  return "<g class=\"moving\" transform=\"translate(" + position(sheet, last.cell) + ")\">" +
         transform("translate", at) + "<g transform=\"rotate(" + svg_number(degrees(last.heading)) + ")\">" +
         transform("rotate", turn) + sheet.wedge() + "</g></g>\n";
}

std::string MouseFilm::duration() const {
  return fmt::format("dur=\"{}s\" repeatCount=\"indefinite\"", svg_number(total_));
}

std::string MouseFilm::shown(const std::string& values, const std::string& keys) const {
  return fmt::format("<animate attributeName=\"opacity\" calcMode=\"discrete\" values=\"{}\" keyTimes=\"{}\" {}/>",
                     values, keys, duration());
}

std::string MouseFilm::transform(const char* type, const Track& track) const {
  if (track.values.empty()) return "";
  return fmt::format("<animateTransform attributeName=\"transform\" type=\"{}\" values=\"{}\" keyTimes=\"{}\" {}/>",
                     type, track.values, track.keys, duration());
}

}  // namespace taut::detail
