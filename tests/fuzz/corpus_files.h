// A fuzzer's corpus as the parameters of a test.
#pragma once

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>
#include <vector>

namespace foveola::test {

/// The files of a corpus, sorted.
inline std::vector<std::filesystem::path> corpus_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// For INSTANTIATE_TEST_SUITE_P: a file's name as that of its test.
struct NameOfFile {
  template <typename Parameter>
  std::string operator()(const Parameter& file) const {
    std::string name = file.param.filename().string();
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
    return name;
  }
};

}  // namespace foveola::test
