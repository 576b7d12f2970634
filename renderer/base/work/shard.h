// Splits work into shards that run independently, on one machine or on many.
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

/// The shard's part of `items` items, at most 2^40. Parts are contiguous, in order, and differ in
/// size by at most one. Empty if there are fewer items than shards.
ItemRange part_of(const Shard& shard, std::int64_t items);

/// Parses "3/16". Throws UsageError that names `option` if `text` is not K/N.
Shard parse_shard(const std::string& option, const std::string& text);

/// "3/16".
std::string text_of(const Shard& shard);

}  // namespace foveola
