#include "renderer/base/work/shard.h"

#include "renderer/base/error.h"
#include "tests/matchers.h"

namespace foveola {
namespace {

TEST(Shard, PartsHaveNoGapsAndEqualSizes) {
  for (const std::int64_t items : {0, 1, 7, 16, 1000}) {
    for (const std::int64_t count : {1, 2, 3, 16, 40}) {
      std::int64_t end = 0;
      for (std::int64_t number = 1; number <= count; ++number) {
        const ItemRange part = part_of({.number = number, .count = count}, items);
        EXPECT_EQ(part.begin, end);
        EXPECT_GE(part.size(), items / count);
        EXPECT_LE(part.size(), items / count + 1);
        end = part.end;
      }
      EXPECT_EQ(end, items);
    }
  }
}

TEST(Shard, IsReadAsItIsWritten) {
  EXPECT_EQ(parse_shard("--shard", "3/16"), (Shard{.number = 3, .count = 16}));
  EXPECT_EQ(text_of(parse_shard("--shard", "100000/100000")), "100000/100000");
  for (const char* const text :
       {"", "3", "/", "3/", "/16", "0/16", "17/16", "3/16/2", "3 / 16", "-1/16", "+3/16",
        "3/100001", "3.0/16", "three/16", "3/99999999999999999999"}) {
    EXPECT_THAT([&] { parse_shard("--shard", text); },
                ThrowsMessage<UsageError>(HasSubstr("--shard: \"")))
        << text;
  }
}

}  // namespace
}  // namespace foveola
