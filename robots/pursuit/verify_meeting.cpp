#include <taut/robots/pursuit/verify_meeting.h>

#include <taut/search/verify.h>

namespace taut::pursuit {

std::string meeting_fault(const FreeSpace& space, const Interception& question, const MeetingPlace& meeting) {
  Path path{meeting.path, {}};
  if (path.points.size() > 1) path.points.pop_back();
  path.length = Length(path.points);
  const Verdict verdict = verify(path, space, question.start, {path.points.back(), {}});
  if (!verdict.valid) return verdict.reason;
  const double reach = question.speed * meeting.time.hi;
  return meeting.length > reach * (1 + 1e-12) + 1e-12 ? "the path is longer than the robot can go until then" : "";
}

}  // namespace taut::pursuit
