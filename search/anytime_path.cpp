#include <taut/search/anytime_search.h>

#include <algorithm>
#include <utility>

namespace taut {

namespace {

void take(const AnytimeSearch& search, SearchStatus status, AnytimeAnswer& answer) {
  answer.result.path = search.best();
  answer.result.status = answer.result.path.points.empty() ? status : SearchStatus::found;
  answer.result.goal = search.goal();
  answer.result.expanded = search.expanded();
  answer.result.generated = search.generated();
  answer.bound = search.bound();
  answer.optimal = search.optimal();
}

}  // namespace

AnytimeAnswer anytime_path(std::shared_ptr<const Roadmap> roadmap, GraphQuery query, double epsilon, double seconds,
                           const std::function<void(const AnytimeAnswer&)>& told) {
  AnytimeSearch search(std::move(roadmap), std::move(query), epsilon);
  AnytimeAnswer answer;
  SearchStatus status = SearchStatus::found;
  while (status == SearchStatus::found && !search.optimal()) {
    status = search.improve({.seconds = std::max(0.0, seconds - search.seconds())});
    if (status != SearchStatus::found) continue;
    answer.improvements.push_back(search.latest());
    if (!told) continue;
    take(search, status, answer);
    told(answer);
  }
  take(search, status, answer);
  return answer;
}

}  // namespace taut
