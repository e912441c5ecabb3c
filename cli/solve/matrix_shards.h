// A matrix that is shared among machines: an item is a group of rows.
#pragma once

#include <span>
#include <string>

#include <taut/cli/shards.h>
#include <taut/search/distance_matrix.h>

namespace taut::cli {

/// By the rows that `prepare` makes. `work` is the mark of all that they depend on.
Items matrix_items(std::size_t points, std::string work, std::function<DistanceRows()> prepare);

/// Puts what ranks or shards have into the matrix of n points. Throws InputError.
void take_matrix(const ShardOptions& options, const Items& items, const Run& run, std::span<double> lengths,
                 std::size_t n);

}  // namespace taut::cli
