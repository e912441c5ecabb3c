// Processes that work together under mpirun: --mpi. Where taut was built without MPI (CMake's TAUT_MPI) there is one.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include <taut/cli/options.h>
#include <taut/cli/shards.h>

namespace taut::cli {

/// Joins the others; all but the first neither print nor write from then on. Throws UsageError in a taut without MPI.
/// Called once, before anything is read or written.
void join_ranks(CommonOptions& options);

bool are_ranks_joined();

/// What a file holds, `-` being standard input: read by the first rank, and sent to all. Throws InputError.
std::string bytes_for_all(const std::string& file);

/// Work that ranks share. The first one hands out items as the others ask for them, --jobs at a time, and takes what
/// they bring, in order of the items; alone it does them itself. The others do not come back: they end with it.
///
/// An item that a rank fails at, or is at for `lost_after` seconds while another one has nothing to do, is named on
/// stderr and given again; at the third failure that is thrown, as std::runtime_error. A process that dies takes all
/// with it: that is MPI.
void do_by_ranks(const Items& items, const Limits& limits, double lost_after,
                 const std::function<void(std::size_t, std::string_view)>& take);

/// The first rank ends with this exit code, and so all do.
void leave_ranks(int code);

}  // namespace taut::cli
