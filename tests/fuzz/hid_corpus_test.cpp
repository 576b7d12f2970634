// Reads every file of the HID fuzzer's seed corpus, so that what was once found stays mended.
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "renderer/base/files.h"
#include "tests/fuzz/corpus_files.h"
#include "tests/fuzz/hid_input.h"

namespace foveola::test {
namespace {

namespace fs = std::filesystem;

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

INSTANTIATE_TEST_SUITE_P(AllFiles, HidCorpus, ::testing::ValuesIn(corpus_files(HID_FUZZ_CORPUS)),
                         NameOfFile());

}  // namespace
}  // namespace foveola::test
