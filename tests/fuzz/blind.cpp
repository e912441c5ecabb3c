// Feeds a fuzz target random bytes where no fuzzer guides: `TARGET EXECUTIONS [SEED]`. Execution k of a seed is always the
// same; what fails is the one after the last number that was told.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

int main(int argc, char** argv) {
  const long executions = argc > 1 ? std::atol(argv[1]) : 1000;
  std::mt19937_64 numbers(argc > 2 ? static_cast<unsigned>(std::atoi(argv[2])) : 1);
  std::vector<std::uint8_t> bytes;
  for (long i = 0; i < executions; ++i) {
    bytes.resize(8 + numbers() % 53);
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(numbers());
    LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
    if ((i + 1) % 100000 == 0) std::printf("%ld\n", i + 1), std::fflush(stdout);
  }
  std::printf("%ld executions\n", executions);
}
