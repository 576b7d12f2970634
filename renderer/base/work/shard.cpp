#include "renderer/base/work/shard.h"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

#include "renderer/base/error.h"

namespace foveola {
namespace {

/// 0 if it is not a number.
std::int64_t number_in(std::string_view digits) {
  std::int64_t number = 0;
  const char* const end = digits.data() + digits.size();
  const auto [stop, failure] = std::from_chars(digits.data(), end, number);
  return failure == std::errc() && stop == end ? number : 0;
}

}  // namespace

ItemRange part_of(const Shard& shard, std::int64_t items) {
  return {.begin = items * (shard.number - 1) / shard.count,
          .end = items * shard.number / shard.count};
}

Shard parse_shard(const std::string& option, const std::string& text) {
  const std::size_t slash = std::min(text.find('/'), text.size());
  const Shard shard{
      .number = number_in(std::string_view(text).substr(0, slash)),
      .count = slash < text.size() ? number_in(std::string_view(text).substr(slash + 1)) : 0};
  if (shard.number < 1 || shard.count > max_shards || shard.number > shard.count) {
    throw UsageError(
        option,
        fmt::format("\"{}\" is not a shard; write K/N with 1 <= K <= N <= {}, for example 3/16",
                    text, max_shards));
  }
  return shard;
}

std::string text_of(const Shard& shard) { return fmt::format("{}/{}", shard.number, shard.count); }

}  // namespace foveola
