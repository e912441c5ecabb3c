#include <taut/io/pictures/detail/svg_motion.h>

#include <fmt/format.h>

#include <string_view>

namespace taut::detail {

namespace {

constexpr std::string_view kStyle = R"(<style>
.taut .pause{display:none;cursor:pointer}
.taut .pause rect{fill:#8a94a6;fill-opacity:.25}
.taut .pause path{fill:#5a6474}
.taut .pause .go,.taut .pause.paused .halt{display:none}
.taut .pause.paused .go{display:inline}
@media (prefers-color-scheme:dark){
.taut .pause path{fill:#a4aebd}
}
@media (prefers-reduced-motion:reduce){
.taut:not(.plays) .moving{display:none}
.taut:not(.plays) .appears{visibility:visible!important;opacity:1!important;stroke-dashoffset:0!important}
}
</style>
)";

// Without <, > and &, which XML would want escaped.
constexpr std::string_view kScript = R"(<script>(function () {
var svg = document.currentScript.ownerSVGElement, button = svg.querySelector('.pause'), ends = $ENDS, paused = false;
function set(to) {
  paused = to;
  // In some browsers a drawing within has a clock of its own.
  [svg].concat(Array.from(svg.querySelectorAll('svg'))).forEach(function (one) {
    if (paused) one.pauseAnimations(); else one.unpauseAnimations();
  });
  button.setAttribute('class', paused ? 'pause paused' : 'pause');
}
function press() {
  svg.classList.add('plays');
  if (ends) if (Math.max(svg.getCurrentTime(), ends) === svg.getCurrentTime()) {
    svg.setCurrentTime(0);
    return set(false);
  }
  set(!paused);
}
button.style.display = 'inline';
button.addEventListener('click', press);
button.addEventListener('keydown', function (event) {
  if ([' ', 'Enter'].indexOf(event.key) === -1) return;
  event.preventDefault();
  press();
});
set(matchMedia('(prefers-reduced-motion: reduce)').matches);
})();</script>
)";

}  // namespace

std::string shown_between(double from, double until, double seconds) {
  return fmt::format(
      "<animate attributeName=\"opacity\" dur=\"{}s\" repeatCount=\"indefinite\" calcMode=\"discrete\" "
      "values=\"0;1;0\" keyTimes=\"0;{:.5f};{:.5f}\"/>",
      svg_number(seconds), from, until);
}

std::string runner_along(const SvgPath& line, double radius, double seconds) {
  return fmt::format(
      "<g class=\"runner moving\"><circle r=\"{}\"><animateMotion dur=\"{}s\" repeatCount=\"indefinite\" path=\"{}\"/>"
      "</circle></g>\n",
      svg_number(radius), svg_number(seconds), line.text());
}

std::string dot_by_clock(const std::vector<std::pair<double, Point>>& places, double radius, double seconds,
                         const std::string& kind) {
  std::string xs, ys, times;
  for (const auto& [when, at] : places) {
    const char* const between = times.empty() ? "" : ";";
    xs.append(between).append(svg_number(at.x));
    ys.append(between).append(svg_number(at.y));
    times += fmt::format("{}{:.6g}", between, when);
  }
  const auto animate = [&](const char* what, const std::string& values) {
    return fmt::format(
        "<animate attributeName=\"{}\" dur=\"{}s\" repeatCount=\"indefinite\" values=\"{}\" keyTimes=\"{}\"/>", what,
        svg_number(seconds), values, times);
  };
  return fmt::format("<g class=\"{} moving\"><circle cx=\"{}\" cy=\"{}\" r=\"{}\">{}{}</circle></g>\n", kind,
                     svg_number(places.front().second.x), svg_number(places.front().second.y), svg_number(radius),
                     animate("cx", xs), animate("cy", ys));
}

std::string film_controls(Point corner, double ends) {
  std::string out(kStyle);
  out += fmt::format(
      "<g class=\"pause\" role=\"button\" tabindex=\"0\" aria-label=\"pause or play\" transform=\"translate({} {})\">"
      "<rect width=\"22\" height=\"18\" rx=\"4\"/><path class=\"halt\" d=\"M7 4h3v10h-3zM12 4h3v10h-3z\"/>"
      "<path class=\"go\" d=\"M8 4l8 5l-8 5z\"/></g>\n",
      svg_number(corner.x - 22), svg_number(corner.y));
  std::string script(kScript);
  const std::string_view blank = "$ENDS";
  script.replace(script.find(blank), blank.size(), svg_number(ends));
  return out + script;
}

}  // namespace taut::detail
