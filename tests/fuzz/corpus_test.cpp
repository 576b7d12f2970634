// Reads every file of the fuzzers' corpora, so that what was once found stays mended.
#include <algorithm>
#include <cctype>
#include <cstdint>
#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "renderer/base/files/files.h"
#include "tests/fuzz/event_input.h"
#include "tests/fuzz/film_input.h"
#include "tests/fuzz/hid_input.h"
#include "tests/fuzz/load_input.h"
#include "tests/fuzz/study_input.h"
#include "tests/temporary_folder.h"

namespace foveola::test {
namespace {

namespace fs = std::filesystem;

/// Returns whether the input was read, and not refused. May write into the folder.
using ReadInput = bool (*)(const fs::path& folder, const std::string& input);

struct CorpusFile {
  fs::path file;
  ReadInput read;

  friend std::ostream& operator<<(std::ostream& stream, const CorpusFile& of) {
    return stream << of.file;
  }
};

std::vector<CorpusFile> files_of(const char* corpus, ReadInput read) {
  std::vector<CorpusFile> files;
  for (const auto& entry : fs::directory_iterator(corpus)) {
    files.push_back({entry.path(), read});
  }
  std::ranges::sort(files, {}, &CorpusFile::file);
  return files;
}

std::string name_of(const testing::TestParamInfo<CorpusFile>& info) {
  std::string name = info.param.file.filename().string();
  std::ranges::replace_if(name, [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

std::vector<std::uint8_t> bytes_of(const std::string& input) {
  return {input.begin(), input.end()};
}

bool read_scene(const fs::path& folder, const std::string& input) {
  write_surroundings(folder);
  return load_input(write_input(folder, input));
}
bool read_film(const fs::path& folder, const std::string& input) {
  return read_film_input(folder, input);
}
bool read_hid(const fs::path& /*folder*/, const std::string& input) {
  return read_hid_input(bytes_of(input));
}
bool read_event(const fs::path& /*folder*/, const std::string& input) {
  return read_event_input(input);
}
bool read_study(const fs::path& folder, const std::string& input) {
  return read_study_input(folder, bytes_of(input));
}

class Corpus : public testing::TestWithParam<CorpusFile> {};

/// Files whose names begin with "valid" are read, those with "bad" are refused; others were found
/// by the fuzzer.
TEST_P(Corpus, IsReadOrRefused) {
  const TemporaryFolder folder;
  const bool is_read = GetParam().read(folder.path(), read_file(GetParam().file));
  const std::string name = GetParam().file.filename().string();
  if (name.starts_with("valid") || name.starts_with("bad")) {
    EXPECT_EQ(is_read, name.starts_with("valid"));
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Corpus, testing::ValuesIn(files_of(FUZZ_CORPUS, read_scene)),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Films, Corpus, testing::ValuesIn(files_of(FILM_FUZZ_CORPUS, read_film)),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Devices, Corpus, testing::ValuesIn(files_of(HID_FUZZ_CORPUS, read_hid)),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Events, Corpus, testing::ValuesIn(files_of(EVENT_FUZZ_CORPUS, read_event)),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Studies, Corpus,
                         testing::ValuesIn(files_of(STUDY_FUZZ_CORPUS, read_study)), name_of);

}  // namespace
}  // namespace foveola::test
