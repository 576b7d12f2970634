// A libFuzzer target: whatever a HID device says of its reports and sends must never make their
// reader crash, hang or take much memory. Run it as
//   foveola_fuzz_hid -entropic=0 -runs=1000000 NEW_CORPUS tests/fuzz/hid_corpus
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/hid_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  foveola::test::read_hid_input({bytes, size});
  return 0;
}
