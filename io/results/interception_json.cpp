#include <taut/io/results/interception_json.h>

namespace taut::pursuit {

Json interception_json(const Interception& question, const std::optional<MeetingPlace>& meeting) {
  Json json{{"caught", meeting.has_value()}, {"speed", question.speed}};
  json["start"] = question.start;
  json["target"] = Json::array();
  for (const TimedPoint& p : question.way) json["target"].push_back({p.time, p.at.x, p.at.y});
  json["stays"] = question.stays;
  if (!meeting) return json;
  json["time"] = meeting->time.hi;
  json["time_interval"] = {meeting->time.lo, meeting->time.hi};
  json["at"] = meeting->at;
  json["leg"] = meeting->leg;
  json["length"] = meeting->length;
  json["waits"] = meeting->waits;
  json["path"] = meeting->path;
  return json;
}

}  // namespace taut::pursuit
