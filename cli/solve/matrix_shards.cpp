#include <taut/cli/solve/matrix_shards.h>

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <taut/geometry/errors.h>
#include <taut/io/saved/packed.h>

namespace taut::cli {

namespace {

constexpr std::size_t kRows = DistanceRows::kRows;

/// How many lengths a group has: of each row those from the diagonal on.
std::size_t lengths_of(std::size_t group, std::size_t n) {
  std::size_t lengths = 0;
  for (std::size_t i = group * kRows; i < std::min(n, (group + 1) * kRows); ++i) lengths += n - i;
  return lengths;
}

}  // namespace

Items matrix_items(std::size_t points, std::string work, std::function<DistanceRows()> prepare) {
  const auto rows = std::make_shared<std::optional<DistanceRows>>();
  return {std::move(work), (points + kRows - 1) / kRows, [rows, prepare = std::move(prepare)] { *rows = prepare(); },
          [rows] {
            return [measure = (*rows)->worker()](std::size_t group) {
              Packer packer;
              for (const double length : measure(group)) packer.put(length);
              return std::move(packer).bytes();
            };
          }};
}

void take_matrix(const ShardOptions& options, const Items& items, const Run& run, std::span<double> lengths,
                 std::size_t n) {
  take_all(options, items, run, [&](std::size_t group, std::string_view bytes) {
    const std::string name = fmt::format("item {} of the shards", group);
    std::vector<double> rows(lengths_of(group, n));
    if (bytes.size() != rows.size() * sizeof(double)) throw InputError(name, 0, "holds other lengths than it should");
    Unpacker unpacker(bytes, name);
    for (double& length : rows) length = unpacker.real();
    put_rows(group, rows, lengths, n);
  });
}

}  // namespace taut::cli
