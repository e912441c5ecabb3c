// The judge of certificates: any two texts, and a true certificate that was tampered with. It approves nothing that is false.
#include <taut/geometry/free_space.h>
#include <taut/io/worlds/read_world.h>
#include <taut/verify/judge.h>

#include "fuzz/fuzzed.h"
#include "support/certified.h"

namespace {

using namespace taut;

struct Case {
  FreeSpace space;
  std::string integers;
  std::string certificate;

  explicit Case(const char* text) : space(read_world(text)), integers(write_integers(space.world())) {
    certificate = test::certificate_of(space, *space.world().start(), space.world().goal()).value();
  }
};

const Case& one_of(int kind) {
  static const Case found("boundary 0 0 4 4\n2 0 2 3\n1 1 1 4\nstart 0 2\ngoal 3 2\n");
  static const Case none("boundary 0 0 4 4\n2 0 2 4\nstart 1 2\ngoal 3 2\n");
  static const Case room("boundary 0 0 4 4\n2 0 2 3\n3 2 3 4\nstart 0 2\ngoal 3 1 4 3\n");
  return kind == 0 ? found : kind == 1 ? none : room;
}

// Numbers of the certificate, wherever they stand, become others.
std::string tampered(std::string text, FuzzedDataProvider& bytes) {
  while (bytes.remaining_bytes() > 0) {
    const auto place = bytes.ConsumeIntegralInRange<std::size_t>(0, text.size() - 1);
    const std::size_t digit = text.find_first_of("0123456789", place);
    if (digit == std::string::npos) continue;
    text[digit] = static_cast<char>('0' + bytes.ConsumeIntegralInRange<int>(0, 9));
  }
  return text;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzedDataProvider bytes(data, size);
  const Case& good = one_of(bytes.ConsumeIntegralInRange<int>(0, 2));
  const bool is_text = bytes.ConsumeBool();
  const bool is_world_text = bytes.ConsumeBool();
  try {
    if (is_text) {
      const std::string certificate = bytes.ConsumeRemainingBytesAsString();
      proof::judge(is_world_text ? certificate : good.integers, is_world_text ? good.certificate : certificate);
    } else {
      const std::string wrong = test::wrong_approval(good.space, tampered(good.certificate, bytes));
      fuzz::require(wrong.empty(), wrong);
    }
  } catch (const proof::BadInput&) {
  }
  return 0;
}
