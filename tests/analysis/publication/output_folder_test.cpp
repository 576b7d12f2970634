#include "analysis/publication/output_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "tests/temporary_folder.h"

namespace fs = std::filesystem;

namespace foveola::analysis {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(OutputFolder, IsMadeOnceAndUsedAgain) {
  const test::TemporaryFolder folder;
  check_output_folder(folder / "results");
  EXPECT_FALSE(fs::exists(folder / "results"));
  make_output_folder(folder / "results");
  EXPECT_TRUE(fs::is_directory(folder / "results"));
  check_output_folder(folder / "results");
  make_output_folder(folder / "results");
  EXPECT_TRUE(fs::is_empty(folder / "results"));
}

TEST(OutputFolder, IsRefusedBeforeTheWork) {
  const test::TemporaryFolder folder;
  write_file(folder / "file", "");
  EXPECT_THAT([&] { check_output_folder(folder / "file"); },
              ThrowsMessage<Error>(HasSubstr("is a file, not a folder")));
  EXPECT_THROW(check_output_folder(folder / "no" / "where"), Error);
}

}  // namespace
}  // namespace foveola::analysis
