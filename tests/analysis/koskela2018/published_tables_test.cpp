#include "analysis/koskela2018/published_tables.h"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/base/error.h"
#include "renderer/base/files.h"

namespace fs = std::filesystem;

namespace foveola::analysis {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

const fs::path shipped = fs::path(FOVEOLA_DATA_DIR) / "koskela2018";

TEST(PublishedTables, HaveACellForEverySceneMarkAndMethod) {
  const PublishedTables tables = read_published_tables(shipped);
  EXPECT_EQ(tables.background.size(), 6U);
  ASSERT_EQ(tables.times.size(), 5U * 2U * 3U);
  EXPECT_EQ(tables.times[8].scene, "classroom");
  EXPECT_EQ(tables.times[8].counterpart, "schoolroom");
  EXPECT_EQ(tables.times[8].mark, "outline");
  EXPECT_EQ(tables.times[8].method, "fv");
}

TEST(PublishedTables, HoldNoNumberThatIsNotAtHand) {
  for (const PublishedTime& cell : read_published_tables(shipped).times) {
    EXPECT_FALSE(cell.mean || cell.standard_deviation) << cell.scene << ' ' << cell.method;
  }
}

TEST(PublishedTables, ADamagedTableIsNamedWithItsLine) {
  const ScratchFolder folder;
  write_file(folder / "table1.csv", "question,mean,sd\nage,30.5,\n");
  const std::string heading = "scene,counterpart,mark,method,mean,sd\n";
  const auto read = [&] { (void)read_published_tables(folder / ""); };
  write_file(folder / "table2.csv", heading + "bmw,studio-car,outline,od,4.5 s,\n");
  EXPECT_THAT(read, ThrowsMessage<Error>(HasSubstr("table2.csv:2: \"4.5 s\" is not a number")));
  write_file(folder / "table2.csv", heading + "bmw,studio-car,shade,od,,\n");
  EXPECT_THAT(read, ThrowsMessage<Error>(HasSubstr("\"shade\" is not a mark")));
  write_file(folder / "table2.csv", heading + "bmw,studio-car\n");
  EXPECT_THAT(read, ThrowsMessage<Error>(HasSubstr("has 2 fields instead of 6")));
  write_file(folder / "table2.csv", "scene\n");
  EXPECT_THAT(read, ThrowsMessage<Error>(HasSubstr("table2.csv:1")));
}

}  // namespace
}  // namespace foveola::analysis
