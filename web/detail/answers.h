// What each request is answered with, as Session says.
#pragma once

#include <taut/io/results/json.h>
#include <taut/web/detail/ground.h>
#include <taut/web/detail/request.h>

namespace taut::web {

Json world_answer(const Ground& ground);
Json path_answer(Ground& ground, const Request& request);
Json widest_answer(Ground& ground, const Request& request);
Json layer_answer(Ground& ground, const Request& request);
Json voronoi_layer(const FreeSpace& space);
Json save_answer(const Ground& ground, const Request& request);
Json formats_answer(const Ground& ground);
Json self_test_answer();

/// Throws InputError where they are read wrongly or stand on no place.
World loaded_world(const Request& request, ReadNotes& notes);
World edited_world(const World& world, const Request& request);

/// What the request says, else the world's own. Throws InputError where there is none.
struct Query {
  Point start;
  Goal goal;
};
Query query_of(const Ground& ground, const Request& request);

}  // namespace taut::web
