// When what is to be seen in the film of a micromouse trial.
#pragma once

#include <string>

#include <taut/io/pictures/detail/mouse_sheet.h>
#include <taut/robots/micromouse/trial.h>

namespace taut::detail {

/// Degrees clockwise from north.
double degrees(Side heading);

/// Where the mouse stands in the end.
micromouse::MousePose last_pose(const micromouse::Record& record);

/// The times of a film and the SMIL elements that obey them. Moments count in steps of the trial; the film begins again
/// after a pause. The record must outlive it.
class MouseFilm {
 public:
  explicit MouseFilm(const micromouse::Record& record);

  /// Inside an element: shown from this moment on, or between two.
  std::string from(double steps) const;
  std::string between(double steps, double end) const;

  /// The mouse, moving.
  std::string mouse(const MouseSheet& sheet) const;

 private:
  struct Track;

  double key(double steps) const { return steps * step_ / total_; }
  std::string duration() const;
  std::string shown(const std::string& values, const std::string& keys) const;
  std::string transform(const char* type, const Track& track) const;

  const micromouse::Record& record_;
  double step_;   // s
  double total_;  // s
};

}  // namespace taut::detail
