// Loads every file of the fuzzer's seed corpus, so that what was once found stays mended.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <vector>

#include <gtest/gtest.h>

#include "renderer/base/files.h"
#include "tests/fuzz/load_input.h"
#include "tests/temporary_folder.h"

namespace foveola::test {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> corpus() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(FUZZ_CORPUS)) {
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

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

INSTANTIATE_TEST_SUITE_P(AllFiles, Corpus, ::testing::ValuesIn(corpus()), [](const auto& file) {
  std::string name = file.param.stem().string();
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
});

}  // namespace
}  // namespace foveola::test
