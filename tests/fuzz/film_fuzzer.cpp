// A libFuzzer target: films that no program would write must never make their reader, or a merge of
// them, crash, hang or take much memory. Run it as
//   foveola_fuzz_film -rss_limit_mb=2048 -timeout=10 NEW_CORPUS tests/fuzz/film_corpus
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "tests/fuzz/film_input.h"
#include "tests/temporary_folder.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static const foveola::test::TemporaryFolder folder;
  foveola::test::read_film_input(folder.path(), {reinterpret_cast<const char*>(bytes), size});
  return 0;
}
