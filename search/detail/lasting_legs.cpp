#include <taut/search/detail/lasting_legs.h>

#include <algorithm>
#include <numeric>

namespace taut::detail {

namespace {

template <class Visit>
void each_next(const TautLegs& legs, std::size_t leg, Visit visit) {
  for (const TautLegs::Range range : {legs.right_of(leg), legs.left_of(leg)})
    for (std::size_t next = range.first; next < range.last; ++next) visit(next);
}

std::vector<std::uint32_t> origins(const TautLegs& legs) {
  std::vector<std::uint32_t> origin(legs.size());
  for (std::uint32_t v = 0; v < legs.vertex_count(); ++v)
    for (std::size_t e = legs.of(v).first; e < legs.of(v).last; ++e) origin[e] = v;
  return origin;
}

/// Lists by number: counted, then filled. `each(add)` calls add(list, item) for all, in the same order both times.
template <class Item, class Each>
void fill_lists(std::size_t lists, Each each, std::vector<std::uint32_t>& first, std::vector<Item>& items) {
  first.assign(lists + 1, 0);
  each([&](std::size_t list, const Item&) { ++first[list + 1]; });
  std::partial_sum(first.begin(), first.end(), first.begin());
  items.resize(first.back());
  std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
  each([&](std::size_t list, const Item& item) { items[next[list]++] = item; });
}

/// The legs from which no taut string goes on for ever: those that none follows, then those that only such ones follow.
std::vector<bool> ending_legs(const TautLegs& legs) {
  std::vector<std::uint32_t> first, before, follow(legs.size(), 0), found;
  fill_lists<std::uint32_t>(
      legs.size(),
      [&](auto add) {
        for (std::size_t e = 0; e < legs.size(); ++e)
          each_next(legs, e, [&](std::size_t next) { add(next, static_cast<std::uint32_t>(e)); });
      },
      first, before);
  std::vector<bool> ends(legs.size(), false);
  const auto end = [&](std::size_t e) {
    ends[e] = true;
    found.push_back(static_cast<std::uint32_t>(e));
  };
  for (std::size_t e = 0; e < legs.size(); ++e) {
    each_next(legs, e, [&](std::size_t) { ++follow[e]; });
    if (follow[e] == 0) end(e);
  }
  for (std::size_t i = 0; i < found.size(); ++i)
    for (std::uint32_t k = first[found[i]]; k < first[found[i] + std::size_t{1}]; ++k)
      if (--follow[before[k]] == 0) end(before[k]);
  return ends;
}

}  // namespace

LastingLegs::LastingLegs(const TautLegs& legs) {
  rank(legs, ending_legs(legs));
  const std::vector<std::uint32_t> origin = origins(legs);
  list_before(legs, origin);
  list_arriving(legs, origin);
}

void LastingLegs::rank(const TautLegs& legs, const std::vector<bool>& ends) {
  rank_.reserve(legs.size() + 1);
  for (std::size_t e = 0; e < legs.size(); ++e) {
    rank_.push_back(static_cast<std::uint32_t>(lasting_.size()));
    if (!ends[e]) lasting_.push_back({legs[e].length, legs[e].to, static_cast<std::uint32_t>(e)});
  }
  rank_.push_back(static_cast<std::uint32_t>(lasting_.size()));
}

void LastingLegs::list_before(const TautLegs& legs, const std::vector<std::uint32_t>& origin) {
  const auto each = [&](auto add) {
    for (std::size_t e = 0; e < legs.size(); ++e)
      if (!lasts(e))
        each_next(legs, e, [&](std::size_t next) { add(next, Arrival{origin[e], static_cast<std::uint32_t>(e)}); });
  };
  fill_lists(legs.size(), each, before_first_, before_);
}

void LastingLegs::list_arriving(const TautLegs& legs, const std::vector<std::uint32_t>& origin) {
  // All that arrive at a vertex, by where from: then in the order of the legs that leave it.
  std::vector<std::uint32_t> first;
  std::vector<Arrival> arrivals;
  const auto each = [&](auto add) {
    for (std::size_t e = 0; e < legs.size(); ++e)
      if (!lasts(e)) add(legs[e].to, Arrival{origin[e], static_cast<std::uint32_t>(e)});
  };
  fill_lists(legs.vertex_count(), each, first, arrivals);
  const auto each_in_order = [&](auto add) {
    for (std::uint32_t v = 0; v < legs.vertex_count(); ++v) {
      const auto own = std::span(arrivals).subspan(first[v], first[v + std::size_t{1}] - first[v]);
      for (std::size_t e = legs.of(v).first; e < legs.of(v).last; ++e)
        for (const Arrival& a : std::ranges::equal_range(own, legs[e].to, {}, &Arrival::from)) add(v, a);
    }
  };
  fill_lists(legs.vertex_count(), each_in_order, arriving_first_, arriving_);
}

}  // namespace taut::detail
