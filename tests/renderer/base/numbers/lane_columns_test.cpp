#include "renderer/base/numbers/lane_columns.h"

#include <array>
#include <cstdint>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

namespace foveola {
namespace {

TEST(LanePackingTest, MovesWhatStaysToTheFrontInItsOrder) {
  const Floats counted{0, 1, 2, 3, 4, 5, 6, 7};
  const Uints hundreds{0, 100, 200, 300, 400, 500, 600, 700};
  for (std::uint32_t bits = 0; bits < 256; ++bits) {
    const LanePacking packing(bits);
    const Floats packed = packing(counted);
    const Uints packed_hundreds = packing(hundreds);
    std::size_t staying = 0;
    for_each_lane(bits, [&](std::size_t lane) {
      EXPECT_EQ(packed[staying], static_cast<float>(lane));
      EXPECT_EQ(packed_hundreds[staying], 100 * lane);
      ++staying;
    });
    EXPECT_EQ(packing.count(), staying);
  }
}

TEST(LaneColumnsTest, DropsSomeWithoutLeavingGaps) {
  UintColumn<24> column;
  std::iota(column.begin(), column.end(), 0U);
  const std::array<std::uint32_t, 3> staying_bits = {0b00001001, 0b11111111, 0b10000000};
  std::vector<std::uint32_t> expected;
  std::size_t staying = 0;
  for (std::size_t group = 0; group < staying_bits.size(); ++group) {
    const LanePacking packing(staying_bits[group]);
    column.move(group * lane_count, packing, staying);
    staying += packing.count();
    for_each_lane(staying_bits[group], [&](std::size_t lane) {
      expected.push_back(static_cast<std::uint32_t>(group * lane_count + lane));
    });
  }
  EXPECT_EQ(std::vector<std::uint32_t>(column.begin(), column.begin() + staying), expected);
}

TEST(LaneColumnsTest, StoresWhatAMaskSays) {
  Vec3Columns<16> columns;
  columns.fill(Vec3(1.0F, 2.0F, 3.0F));
  columns.store(8, mask_of(0b100U), all_lanes(Vec3(7.0F, 8.0F, 9.0F)));
  EXPECT_EQ(columns.at(9), Vec3(1.0F, 2.0F, 3.0F));
  EXPECT_EQ(columns.at(10), Vec3(7.0F, 8.0F, 9.0F));
  EXPECT_EQ(columns.at(2), Vec3(1.0F, 2.0F, 3.0F));
}

}  // namespace
}  // namespace foveola
