// Loads every file of the fuzzer's seed corpus, so that what was once found stays mended.
#include <filesystem>

#include <gtest/gtest.h>

#include "renderer/base/files.h"
#include "tests/fuzz/corpus_files.h"
#include "tests/fuzz/load_input.h"
#include "tests/temporary_folder.h"

namespace foveola::test {
namespace {

namespace fs = std::filesystem;

class Corpus : public ::testing::TestWithParam<fs::path> {};

/// Those whose name begins with "valid" must load; others were found by the fuzzer, or are refused.
TEST_P(Corpus, LoadsOrIsRefused) {
  const TemporaryFolder folder;
  write_surroundings(folder.path());
  const bool is_loaded = load_input(write_input(folder.path(), read_file(GetParam())));
  if (GetParam().filename().string().starts_with("valid")) {
    EXPECT_TRUE(is_loaded);
  }
}

INSTANTIATE_TEST_SUITE_P(AllFiles, Corpus, ::testing::ValuesIn(corpus_files(FUZZ_CORPUS)),
                         NameOfFile());

}  // namespace
}  // namespace foveola::test
