// A matrix that is shared among machines: an item is a group of rows.
#pragma once

#include <span>
#include <string>

#include <taut/cli/shards.h>
#include <taut/search/distance_matrix.h>

namespace taut::cli {

std::size_t matrix_items(std::size_t points);

/// By `rows`, which outlives it.
Items matrix_items(const DistanceRows& rows, std::string work);

/// Puts what all shards have into the matrix of n points. Throws InputError.
void join_matrix(const ShardOptions& options, const std::string& command, const std::string& work,
                 std::span<double> lengths, std::size_t n);

}  // namespace taut::cli
