// Reads every file of the corpora of the events' and the studies' fuzzers, so that what was once
// found stays mended.
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "renderer/base/files.h"
#include "tests/fuzz/corpus_files.h"
#include "tests/fuzz/event_input.h"
#include "tests/fuzz/study_input.h"
#include "tests/temporary_folder.h"

namespace foveola::test {
namespace {

namespace fs = std::filesystem;

/// Those whose name begins with "valid" are read, those with "bad" are refused; others were found
/// by the fuzzer.
void expect_as_named(bool is_read, const fs::path& file) {
  const std::string name = file.filename().string();
  if (name.starts_with("valid") || name.starts_with("bad")) {
    EXPECT_EQ(is_read, name.starts_with("valid"));
  }
}

class EventCorpus : public ::testing::TestWithParam<fs::path> {};

TEST_P(EventCorpus, IsReadOrRefused) {
  expect_as_named(read_event_input(read_file(GetParam())), GetParam());
}

INSTANTIATE_TEST_SUITE_P(AllFiles, EventCorpus,
                         ::testing::ValuesIn(corpus_files(EVENT_FUZZ_CORPUS)), NameOfFile());

class StudyCorpus : public ::testing::TestWithParam<fs::path> {};

TEST_P(StudyCorpus, IsReadOrRefused) {
  const TemporaryFolder folder;
  const std::string input = read_file(GetParam());
  const Bytes bytes(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
  expect_as_named(read_study_input(folder.path(), bytes), GetParam());
}

INSTANTIATE_TEST_SUITE_P(AllFiles, StudyCorpus,
                         ::testing::ValuesIn(corpus_files(STUDY_FUZZ_CORPUS)), NameOfFile());

}  // namespace
}  // namespace foveola::test
