// A libFuzzer target: whatever a study's file has for an event is read or refused. Run it as
//   foveola_fuzz_event -dict=tests/fuzz/events.dict NEW_CORPUS tests/fuzz/event_corpus
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "tests/fuzz/event_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  foveola::test::read_event_input({reinterpret_cast<const char*>(bytes), size});
  return 0;
}
