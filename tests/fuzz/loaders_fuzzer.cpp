// A libFuzzer target: scenes and environments that no program would write must never make a loader
// crash, hang or take much memory. Run it as
//   foveola_fuzz_loaders -dict=tests/fuzz/scenes.dict -rss_limit_mb=2048 -timeout=10 NEW_CORPUS
//   tests/fuzz/corpus
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "tests/fuzz/load_input.h"
#include "tests/temporary_folder.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static const foveola::test::TemporaryFolder folder;
  static const bool is_ready = (foveola::test::write_surroundings(folder.path()), true);
  if (is_ready) {
    const std::string_view input(reinterpret_cast<const char*>(bytes), size);
    foveola::test::load_input(foveola::test::write_input(folder.path(), input));
  }
  return 0;
}
