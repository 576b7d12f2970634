// A libFuzzer target: studies that somebody changed are read or refused, in whatever way they were
// changed. Run it as
//   foveola_fuzz_study -max_len=512 -timeout=20 NEW_CORPUS tests/fuzz/study_corpus
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/study_input.h"
#include "tests/temporary_folder.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static const foveola::test::TemporaryFolder folder;
  foveola::test::read_study_input(folder.path(), {bytes, size});
  return 0;
}
