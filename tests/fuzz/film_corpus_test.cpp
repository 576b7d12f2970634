// Reads every file of the film fuzzer's seed corpus, so that what was once found stays mended.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <vector>

#include <gtest/gtest.h>

#include "renderer/base/files.h"
#include "tests/fuzz/film_input.h"
#include "tests/temporary_folder.h"

namespace foveola::test {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> film_corpus() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(FILM_FUZZ_CORPUS)) {
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

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

INSTANTIATE_TEST_SUITE_P(AllFiles, FilmCorpus, ::testing::ValuesIn(film_corpus()),
                         [](const auto& file) {
                           std::string name = file.param.filename().string();
                           std::replace_if(
                               name.begin(), name.end(),
                               [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
                           return name;
                         });

}  // namespace
}  // namespace foveola::test
