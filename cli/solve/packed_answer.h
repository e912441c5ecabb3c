// Queries of a batch and their answers as bytes, for shards.
#pragma once

#include <span>
#include <string>

#include <taut/cli/solve/batch_answers.h>
#include <taut/io/saved/packed.h>
#include <taut/io/worlds/query_lines.h>

namespace taut::cli {

/// All that is in them.
std::string text_of(std::span<const QueryLine> queries);

void pack(const QueryAnswer& answer, Packer& packer);
/// Throws InputError where the bytes are none.
QueryAnswer unpacked_answer(Unpacker& unpacker);

}  // namespace taut::cli
