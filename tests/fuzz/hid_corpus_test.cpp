// Reads every file of the HID fuzzer's seed corpus, so that what was once found stays mended.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "renderer/base/files.h"
#include "tests/fuzz/hid_input.h"

namespace foveola::test {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> hid_corpus() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(HID_FUZZ_CORPUS)) {
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

class HidCorpus : public ::testing::TestWithParam<fs::path> {};

/// Those whose name begins with "valid" send samples, those with "bad" do not; others were found by
/// the fuzzer.
TEST_P(HidCorpus, SendsSamplesOrIsRefused) {
  const std::string input = read_file(GetParam());
  const bool has_sample =
      read_hid_input({reinterpret_cast<const std::uint8_t*>(input.data()), input.size()});
  const std::string name = GetParam().filename().string();
  if (name.starts_with("valid") || name.starts_with("bad")) {
    EXPECT_EQ(has_sample, name.starts_with("valid"));
  }
}

INSTANTIATE_TEST_SUITE_P(AllFiles, HidCorpus, ::testing::ValuesIn(hid_corpus()),
                         [](const auto& file) {
                           std::string name = file.param.filename().string();
                           std::replace_if(
                               name.begin(), name.end(),
                               [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
                           return name;
                         });

}  // namespace
}  // namespace foveola::test
