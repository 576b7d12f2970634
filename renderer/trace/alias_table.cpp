#include "renderer/trace/alias_table.h"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace foveola {

AliasTable::AliasTable(std::span<const double> weights) : slots_(weights.size()) {
  const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
  assert(total > 0.0);
  std::vector<double> shares(weights.size());
  std::vector<std::uint32_t> poor;
  std::vector<std::uint32_t> rich;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    shares[i] = weights[i] / total * static_cast<double>(weights.size());
    (shares[i] < 1.0 ? poor : rich).push_back(static_cast<std::uint32_t>(i));
  }
  // What is left in either list at the end is full but for rounding, and stays its slot's only
  // item.
  while (!poor.empty() && !rich.empty()) {
    const std::uint32_t filled = poor.back();
    const std::uint32_t giver = rich.back();
    poor.pop_back();
    slots_[filled] = {.own_share = static_cast<float>(shares[filled]), .alias = giver};
    shares[giver] -= 1.0 - shares[filled];
    if (shares[giver] < 1.0) {
      rich.pop_back();
      poor.push_back(giver);
    }
  }
}

}  // namespace foveola
