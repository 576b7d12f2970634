// Work that is split into parts which run by themselves, on one machine or on many.
#pragma once

#include <cstdint>
#include <string>

namespace foveola {

/// One of `count` parts of some work.
struct Shard {
  std::int64_t number = 1;  ///< in [1, count]
  std::int64_t count = 1;   ///< in [1, max_shards]

  friend bool operator==(const Shard&, const Shard&) = default;
};

inline constexpr std::int64_t max_shards = 100'000;

/// Items [begin, end) of a list.
struct ItemRange {
  std::int64_t begin = 0;
  std::int64_t end = 0;

  std::int64_t size() const { return end - begin; }
};

/// The shard's part of `items` items, at most 2^40: parts of equal size within one, without gaps,
/// in the order of their numbers. Empty if there are fewer items than shards.
ItemRange part_of(const Shard& shard, std::int64_t items);

/// "3/16". Throws UsageError, which names `option`, for anything else than a number of a shard and
/// how many there are.
Shard parse_shard(const std::string& option, const std::string& text);

/// "3/16".
std::string text_of(const Shard& shard);

}  // namespace foveola
