// Reads every file of the film fuzzer's seed corpus, so that what was once found stays mended.
#include <filesystem>

#include <gtest/gtest.h>

#include "renderer/base/files.h"
#include "tests/fuzz/corpus_files.h"
#include "tests/fuzz/film_input.h"
#include "tests/temporary_folder.h"

namespace foveola::test {
namespace {

namespace fs = std::filesystem;

class FilmCorpus : public ::testing::TestWithParam<fs::path> {};

/// Those whose name begins with "valid" are films, those with "bad" are not; others were found by
/// the fuzzer.
TEST_P(FilmCorpus, IsReadOrRefused) {
  const TemporaryFolder folder;
  const bool is_film = read_film_input(folder.path(), read_file(GetParam()));
  const std::string name = GetParam().filename().string();
  if (name.starts_with("valid") || name.starts_with("bad")) {
    EXPECT_EQ(is_film, name.starts_with("valid"));
  }
}

INSTANTIATE_TEST_SUITE_P(AllFiles, FilmCorpus, ::testing::ValuesIn(corpus_files(FILM_FUZZ_CORPUS)),
                         NameOfFile());

}  // namespace
}  // namespace foveola::test
