#include <taut/cli/meter.h>

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>

namespace taut::cli {

namespace {

constexpr double kMinute = 60, kHour = 3600;

std::string rate_text(double a_second) {
  if (a_second >= 10) return fmt::format("{:.0f} a second", a_second);
  if (a_second >= 0.95) return fmt::format("{:.1f} a second", a_second);
  return fmt::format("{:.1f} a minute", kMinute * a_second);
}

/// Rounded up: what is left is seldom less than it seems.
std::string duration_text(double seconds) {
  if (seconds < 1.5 * kMinute) return fmt::format("{:.0f} s", std::ceil(seconds));
  if (seconds < 1.5 * kHour) return fmt::format("{:.0f} min", std::ceil(seconds / kMinute));
  return fmt::format("{:.1f} h", seconds / kHour);
}

}  // namespace

Meter::Meter(Surface surface, Clock clock) : surface_(surface), clock_(std::move(clock)) {}

double Meter::period() const { return surface_ == Surface::terminal ? 0.2 : 1; }

double Meter::patience() const { return surface_ == Surface::terminal ? 0.2 : 10; }

void Meter::told(const Progress& progress) {
  const std::lock_guard lock(mutex_);
  const bool goes_on = is_counting_ && progress.done >= last_.done && std::string_view(progress.unit) == last_.unit;
  last_ = progress;
  if (goes_on) return;
  is_counting_ = true;
  first_ = progress;
  begun_ = clock_();
  if (!shown_) shown_ = begun_;
}

void Meter::over() {
  const std::lock_guard lock(mutex_);
  is_counting_ = false;
}

std::optional<std::string> Meter::due(std::string_view stage) {
  const std::lock_guard lock(mutex_);
  if (!is_counting_ || (last_.all > 0 && last_.done >= last_.all)) return std::nullopt;
  const double now = clock_();
  if (now - *shown_ < patience()) return std::nullopt;
  shown_ = now;
  return line(stage, now - begun_);
}

std::string Meter::line(std::string_view stage, double since) const {
  std::string text = stage.empty() ? "" : fmt::format("{}: ", stage);
  text += last_.all > 0 ? fmt::format("{} of {} {}", last_.done, last_.all, last_.unit)
                        : fmt::format("{} {}", last_.done, last_.unit);
  const std::size_t counted = last_.done - first_.done;
  if (counted == 0 || since <= 0) return text + fmt::format(", {} so far", duration_text(since));
  const double rate = static_cast<double>(counted) / since;
  text += ", " + rate_text(rate);
  if (last_.all == 0) return text;
  return text + fmt::format(", about {} left", duration_text(static_cast<double>(last_.all - last_.done) / rate));
}

}  // namespace taut::cli
