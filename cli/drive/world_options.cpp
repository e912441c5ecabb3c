// The options of `taut drive --car`.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include <taut/cli/command_line.h>
#include <taut/cli/drive/world.h>
#include <taut/geometry/errors.h>

namespace taut::cli {

namespace {

[[noreturn]] void refuse(const std::string& option, const std::string& text, const char* wanted) {
  throw UsageError(fmt::format("{}: '{}' is not {}", option, text, wanted));
}

double number_for(const std::string& option, const std::string& text, const char* wanted) {
  try {
    return number_of(text);
  } catch (const UsageError&) {
    refuse(option, text, wanted);
  }
}

constexpr const char* kCar = "length=L,width=W,radius=R, with rear=B and reverse=no where wanted";

}  // namespace

car::CarShape car_shape_of(const std::string& text) {
  std::map<std::string, std::string> values;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(',', at), text.size()), equals = text.find('=', at);
    if (equals >= end) refuse("--car", text, kCar);
    if (!values.emplace(text.substr(at, equals - at), text.substr(equals + 1, end - equals - 1)).second)
      refuse("--car", text, kCar);
    at = end + 1;
  }
  const auto take = [&](const char* key, std::optional<double> otherwise) {
    const auto found = values.find(key);
    if (found == values.end()) {
      if (!otherwise) refuse("--car", text, kCar);
      return *otherwise;
    }
    const double value = number_for("--car", found->second, "a number");
    values.erase(found);
    return value;
  };
  const double length = take("length", std::nullopt), width = take("width", std::nullopt);
  const double radius = take("radius", std::nullopt), rear = take("rear", length / 4);
  bool reverse = true;
  if (const auto found = values.find("reverse"); found != values.end()) {
    if (found->second != "yes" && found->second != "no") refuse("--car", found->second, "yes or no");
    reverse = found->second == "yes";
    values.erase(found);
  }
  if (!values.empty()) refuse("--car", values.begin()->first, "one of length, width, radius, rear, reverse");
  try {
    return car::car_shape(length, width, radius, rear, reverse);
  } catch (const InputError& error) {
    throw UsageError(std::string("--car: ") + error.what());
  }
}

namespace {

DriveEnd end_of(const std::string& option, const std::string& text) {
  static constexpr const char* kWanted = "X,Y or X,Y,DEGREES";
  const std::size_t first = text.find(','), second = first == std::string::npos ? first : text.find(',', first + 1);
  if (first == std::string::npos) refuse(option, text, kWanted);
  DriveEnd end;
  end.at.x = number_for(option, text.substr(0, first), kWanted);
  end.at.y =
      number_for(option, text.substr(first + 1, second == std::string::npos ? second : second - first - 1), kWanted);
  if (second != std::string::npos) end.degrees = number_for(option, text.substr(second + 1), kWanted);
  return end;
}

}  // namespace

void add_world_drive_options(CommandLine& app, WorldDriveOptions& options) {
  add_world_options(app, options.world);
  app.add_option_function(
         "--car", [&options](const std::string& text) { options.car = car_shape_of(text); },
         "Drive this car in a world of walls: length=L,width=W,radius=R (of the least turn), rear=B (from the "
         "rear axle, whose middle is guided, to the rear end; default: L/4), reverse=no")
      .type_name("CAR")
      .group("General car");
  const auto add_end = [&](const char* name, std::optional<DriveEnd>& end, const char* what) {
    app.add_option_function(
           name, [&end, name](const std::string& text) { end = end_of(name, text); }, what)
        .type_name("X,Y[,DEGREES]")
        .group("General car");
  };
  add_end("--from", options.from,
          "Start here, with the nearest of 64 headings (default: where FILE says, any heading)");
  add_end("--to", options.to, "Get the middle of the rear axle here, likewise");
  app.add_option_function(
         "--weight",
         [&options](const std::string& text) {
           options.weight = number_for("--weight", text, "a number of 1 or more");
           if (options.weight < 1) refuse("--weight", text, "a number of 1 or more");
         },
         "The drive may be this much longer than the shortest on its lattice (default: 1.05)")
      .type_name("W")
      .group("General car");
}

}  // namespace taut::cli
