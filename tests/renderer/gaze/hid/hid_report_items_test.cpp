#include "renderer/base/error.h"
#include "renderer/gaze/hid/hid_items.h"
#include "tests/matchers.h"
#include "tests/renderer/gaze/hid_reference.h"

namespace foveola {
namespace {

using test::Bytes;
using test::from_hex;

TEST(HidItemReader, DataHaveNoneOneTwoOrFourBytes) {
  const Bytes bytes = from_hex("c0 05 12 0a 00 01 17 80 7b e1 ff");
  HidItemReader reader(bytes);
  const auto end = reader.next();
  ASSERT_TRUE(end);
  EXPECT_EQ(end->kind, HidItemKind::end_collection);
  EXPECT_EQ(end->data.size_bytes, 0U);
  const auto page = reader.next();
  ASSERT_TRUE(page);
  EXPECT_EQ(page->kind, HidItemKind::usage_page);
  EXPECT_EQ(page->data.bits, 0x12U);
  EXPECT_EQ(page->offset, 1U);
  const auto usage = reader.next();
  ASSERT_TRUE(usage);
  EXPECT_EQ(usage->kind, HidItemKind::usage);
  EXPECT_EQ(usage->data.bits, 0x100U);
  EXPECT_EQ(usage->offset, 3U);
  const auto minimum = reader.next();
  ASSERT_TRUE(minimum);
  EXPECT_EQ(minimum->kind, HidItemKind::logical_minimum);
  EXPECT_EQ(minimum->data.as_signed(), -2'000'000);
  EXPECT_FALSE(reader.next());
}

TEST(HidItemReader, TheSignIsThatOfTheDatasOwnSize) {
  EXPECT_EQ((HidItemData{.bits = 0xFF, .size_bytes = 1}.as_signed()), -1);
  EXPECT_EQ((HidItemData{.bits = 0xFF, .size_bytes = 2}.as_signed()), 255);
  EXPECT_EQ((HidItemData{.bits = 0x8000, .size_bytes = 2}.as_signed()), -32768);
  EXPECT_EQ((HidItemData{.bits = 0x8000, .size_bytes = 4}.as_signed()), 32768);
  EXPECT_EQ((HidItemData{.bits = 0xFFFFFFFE, .size_bytes = 4}.as_signed()), -2);
  EXPECT_EQ((HidItemData{}.as_signed()), 0);
}

TEST(HidItemReader, SkipsLongItems) {
  const Bytes bytes = from_hex("fe 03 f0 aa bb cc fe 00 f1 95 08");
  HidItemReader reader(bytes);
  const auto count = reader.next();
  ASSERT_TRUE(count);
  EXPECT_EQ(count->kind, HidItemKind::report_count);
  EXPECT_EQ(count->data.bits, 8U);
  EXPECT_EQ(count->offset, 9U);
  EXPECT_FALSE(reader.next());
}

TEST(HidItemReader, SaysWhereAnItemIsCutOff) {
  for (const char* digits : {"c0 26 ff", "c0 27 ff ff ff", "c0 fe", "c0 fe 02", "c0 fe 02 f0 aa"}) {
    const Bytes bytes = from_hex(digits);
    HidItemReader reader(bytes);
    ASSERT_TRUE(reader.next());
    EXPECT_THAT([&] { reader.next(); }, ThrowsMessage<Error>(HasSubstr("byte 1: the"))) << digits;
  }
}

}  // namespace
}  // namespace foveola
