#include <taut/io/pictures/detail/mouse_values.h>

#include <fmt/format.h>

#include <vector>

#include <taut/io/pictures/detail/svg_path.h>
#include <taut/robots/micromouse/steps.h>

namespace taut::detail {

namespace {

using micromouse::Record;
using micromouse::StepField;

std::vector<int> values_of(const micromouse::WallMap& known, const micromouse::Task& task) {
  const StepField field(known.possible(), task.goal);
  std::vector<int> values;
  for (int y = 0; y < task.height; ++y)
    for (int x = 0; x < task.width; ++x) values.push_back(field({x, y}));
  return values;
}

std::string number(const MouseSheet& sheet, Cell cell, int value, const char* kind, const std::string& motion) {
  const Point p = sheet.pixel(Point{cell.x + 0.12, cell.y + 0.66});
  return fmt::format("<text{} x=\"{}\" y=\"{}\">{}{}</text>", kind, svg_number(p.x), svg_number(p.y), value, motion);
}

/// A number that stands in its cell from one moment on.
struct Standing {
  int value = micromouse::kUnreached;
  std::size_t since = 0;
};

class ValuesFilm {
 public:
  ValuesFilm(const MouseSheet& sheet, const Record& record, const MouseFilm& film)
      : sheet_(sheet), record_(record), film_(film) {}

  std::string draw() {
    micromouse::WallMap known(record_.task);
    show(known, 0);
    for (std::size_t k = 0; k < record_.steps.size(); ++k) {
      const micromouse::Step& step = record_.steps[k];
      if (step.run != 1 || (step.seen.empty() && step.felt.empty())) continue;
      for (const auto* facts : {&step.seen, &step.felt})
        for (const micromouse::WallSeen& fact : *facts) known.learn(fact.wall.cell, fact.wall.side, fact.closed);
      show(known, k + 1);
    }
    for (std::size_t i = 0; i < standing_.size(); ++i) write(i, std::nullopt);
    return MouseSheet::group("flood", out_);
  }

 private:
  void show(const micromouse::WallMap& known, std::size_t moment) {
    const std::vector<int> values = values_of(known, record_.task);
    if (standing_.empty()) standing_.resize(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (values[i] == standing_[i].value) continue;
      write(i, moment);
      standing_[i] = {values[i], moment};
    }
  }

  void write(std::size_t i, std::optional<std::size_t> until) {
    const auto [value, since] = standing_[i];
    if (value == micromouse::kUnreached || since == until) return;
    const auto from = static_cast<double>(since);
    const int at = static_cast<int>(i), width = record_.task.width;
    out_ += number(sheet_, {at % width, at / width}, value,
                   until ? " class=\"moving\" opacity=\"0\"" : " class=\"appears\"",
                   until ? film_.between(from, static_cast<double>(*until)) : film_.from(from));
  }

  const MouseSheet& sheet_;
  const Record& record_;
  const MouseFilm& film_;
  std::vector<Standing> standing_;
  std::string out_;
};

std::string_view colour_of(char letter) {
  switch (letter) {
    case 'k': return "#000";
    case 'b': return "#35f";
    case 'a': return "#999";
    case 'c': return "#0cc";
    case 'g': return "#2b2";
    case 'o': return "#f90";
    case 'r': return "#e33";
    case 'w': return "#fff";
    case 'y': return "#ed0";
    case 'B': return "#018";
    case 'C': return "#077";
    case 'A': return "#555";
    case 'G': return "#060";
    case 'R': return "#800";
    case 'Y': return "#880";
    default: return "";
  }
}

}  // namespace

std::string mouse_values(const MouseSheet& sheet, const Record& record) {
  const std::vector<int> values = values_of(known_after_run1(record), record.task);
  std::string out;
  for (int i = 0; i < static_cast<int>(values.size()); ++i)
    if (const int value = values[static_cast<std::size_t>(i)]; value != micromouse::kUnreached)
      out += number(sheet, {i % record.task.width, i / record.task.width}, value, "", "");
  return MouseSheet::group("flood", out);
}

std::string film_values(const MouseSheet& sheet, const Record& record, const MouseFilm& film) {
  return ValuesFilm(sheet, record, film).draw();
}

std::string mouse_marks(const MouseSheet& sheet, const std::map<Cell, micromouse::CellMark>& marks) {
  std::string out;
  for (const auto& [cell, mark] : marks) {
    const Point corner = sheet.pixel(Point{cell.x + 0.72, cell.y + 0.9}),
                end = sheet.pixel(Point{cell.x + 0.9, cell.y + 0.72}),
                words = sheet.pixel(Point{cell.x + 0.1, cell.y + 0.12});
    if (const std::string_view colour = colour_of(mark.colour); !colour.empty())
      out += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\"/>", svg_number(corner.x),
                         svg_number(corner.y), svg_number(end.x - corner.x), svg_number(end.y - corner.y), colour);
    if (!mark.text.empty())
      out += fmt::format("<text x=\"{}\" y=\"{}\">{}</text>", svg_number(words.x), svg_number(words.y),
                         xml_text(mark.text));
  }
  return out.empty() ? "" : MouseSheet::group("marks", out);
}

}  // namespace taut::detail
