#include "study/prediction/noise_table.h"
#include "tests/matchers.h"
#include "tests/temporary_folder.h"

namespace foveola::study {
namespace {

std::vector<NoiseTable> some_tables() {
  const PatchNoise patch{.direction = {0.6F, 0.0F, -0.8F},
                         .cells = 5.0,
                         .contrast = 1.0 / 3.0,
                         .unsampled = {1.0, 2.0, 3.0},
                         .first_per_sr = 0.1,
                         .noise_times_density = {{4.0, 5.0, 6.0}, {7.0, 8.0, 9.0}}};
  return {{patch, patch}, {}};
}

TEST(TableCache, KeepsTablesToTheBit) {
  const test::TemporaryFolder folder;
  const TableCache cache(folder / "pilots");
  EXPECT_FALSE(cache.find("a key"));
  cache.keep("a key", some_tables());
  const auto found = cache.find("a key");
  ASSERT_TRUE(found);
  ASSERT_EQ(found->size(), 2U);
  ASSERT_EQ(found->front().size(), 2U);
  const PatchNoise& patch = found->front().back();
  const PatchNoise expected = some_tables()[0][1];
  EXPECT_EQ(patch.direction, expected.direction);
  EXPECT_EQ(patch.cells, expected.cells);
  EXPECT_EQ(patch.contrast, expected.contrast);
  EXPECT_EQ(patch.unsampled, expected.unsampled);
  EXPECT_EQ(patch.first_per_sr, expected.first_per_sr);
  EXPECT_EQ(patch.noise_times_density, expected.noise_times_density);
  EXPECT_TRUE(found->back().empty());
  EXPECT_FALSE(cache.find("another key"));
}

TEST(TableCache, DamagedTablesAreNoneUntilTheyAreKeptAgain) {
  const test::TemporaryFolder folder;
  const TableCache cache(folder.path());
  cache.keep("a key", some_tables());
  const std::string name = folder.entries().front();
  ASSERT_THAT(name, EndsWith(".cbor"));
  const std::string whole = folder.content().at(name);
  std::string flipped = whole;
  flipped[whole.size() - 4] ^= 1;  // a last bit of a number
  for (const std::string& damaged :
       {whole.substr(0, whole.size() / 2), std::string("{}"), flipped}) {
    folder.write(name, damaged);
    EXPECT_FALSE(cache.find("a key"));
    cache.keep("a key", some_tables());
    EXPECT_TRUE(cache.find("a key"));
    EXPECT_EQ(folder.content().at(name), whole);
  }
}

TEST(TableCache, OtherProgramsHaveOtherTables) {
  const test::TemporaryFolder folder;
  const TableCache cache(folder.path());
  cache.keep("a key", some_tables());
  BuildInfo other = build_info();
  other.ray_instructions = "sse4.2 and another Embree";
  EXPECT_FALSE(TableCache(folder.path(), other).find("a key"));
  other = build_info();
  other.version = "of another source, which counts its versions in the key";
  EXPECT_TRUE(TableCache(folder.path(), other).find("a key"));
}

}  // namespace
}  // namespace foveola::study
