#include "renderer/base/files/little_endian.h"

#include <limits>

#include <gtest/gtest.h>

namespace foveola {
namespace {

TEST(LittleEndian, NumbersBeginWithTheirLowestByte) {
  std::string bytes;
  append(bytes, std::uint32_t{0x04030201});
  append(bytes, std::uint64_t{0x0C0B0A0908070605});
  EXPECT_EQ(bytes, "\1\2\3\4\5\6\7\10\11\12\13\14");
  bytes.clear();
  append(bytes, 1.0);  // IEEE 754: 0x3FF0000000000000
  append(bytes, 1.0F);
  EXPECT_EQ(bytes, std::string("\0\0\0\0\0\0\xF0\x3F\0\0\x80\x3F", 12));
}

TEST(LittleEndian, NumbersAreTakenAsTheyWereAppended) {
  constexpr double smallest = std::numeric_limits<double>::denorm_min();
  std::string bytes;
  append(bytes, std::uint32_t{0xFE});
  append(bytes, smallest);
  append(bytes, -2.5F);
  append(bytes, Nanoseconds(-7));
  append(bytes, std::uint64_t{0xFFFFFFFFFFFFFFFE});
  std::string_view left = bytes;
  EXPECT_EQ(take<std::uint32_t>(left), 0xFEU);
  EXPECT_EQ(take_double(left), smallest);
  EXPECT_EQ(take_float(left), -2.5F);
  EXPECT_EQ(take_nanoseconds(left), Nanoseconds(-7));
  EXPECT_EQ(take<std::uint64_t>(left), 0xFFFFFFFFFFFFFFFE);
  EXPECT_TRUE(left.empty());
}

}  // namespace
}  // namespace foveola
