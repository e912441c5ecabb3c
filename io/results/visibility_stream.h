// A visibility graph written while it is found.
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>

#include <taut/roadmaps/visibility_rows.h>

namespace taut {

/// Text, a line each: `v X Y` for each vertex, numbered from 0 in this order; `e U V` for each edge, once, from its
/// left end (the lower one of an upright edge), in the order of U, then V; `end N` with the number of edges, so that a
/// file cut short can be told. Numbers read back as the same double. `write` gets pieces of about 64 KB; no more is
/// held than one of them and one row. Told are the vertices. Returns the number of edges.
std::uint64_t stream_visibility(const VisibilityRows& rows, const std::function<void(std::string_view)>& write,
                                const TellProgress& tell = {});

}  // namespace taut
