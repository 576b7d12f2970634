#include "renderer/base/text/print.h"

#include <array>
#include <filesystem>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "renderer/base/files/files.h"

namespace fs = std::filesystem;

namespace foveola {
namespace {

TEST(Print, WritesNothingThatATerminalObeys) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::tmpfile(), std::fclose);
  ASSERT_NE(file, nullptr);
  print_text(file.get(), "{}: {:.1f}\n", "P\x1b[2J\u202e1", 2.0);
  std::rewind(file.get());
  std::array<char, 100> text{};
  EXPECT_STREQ(std::fgets(text.data(), text.size(), file.get()), "P\\u001b[2J\\u202e1: 2.0\n");
}

TEST(Print, IsWhatAllSourcesPrintBy) {
  const fs::path root = resource_folder();
  for (const char* const module : {"analysis", "renderer", "scenes", "study"}) {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / module)) {
      const fs::path& file = entry.path();
      if (file.extension() != ".cpp" && file.extension() != ".h") {
        continue;
      }
      const std::string text = read_file(file);
      for (const char* const other : {"fmt::print(", "std::printf(", "std::cout", "std::cerr"}) {
        EXPECT_EQ(text.find(other), std::string::npos) << file << " has " << other;
      }
    }
  }
}

}  // namespace
}  // namespace foveola
