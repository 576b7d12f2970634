// Drawing an item by its weight in constant time (Walker 1977; Vose 1991).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/base/vec.h"

namespace foveola {

class AliasTable {
 public:
  /// weights: >= 0 and finite, not all zero. Item i is drawn with weights[i] over their sum.
  explicit AliasTable(std::span<const double> weights);

  /// u: in the unit square.
  std::size_t sample(const Vec2& u) const {
    const auto slot = std::min(
        static_cast<std::size_t>(static_cast<double>(u.x) * static_cast<double>(slots_.size())),
        slots_.size() - 1);
    return u.y < slots_[slot].own_share ? slot : slots_[slot].alias;
  }

 private:
  struct Slot {
    float own_share = 1.0F;  ///< the rest of the slot belongs to `alias`
    std::uint32_t alias = 0;
  };
  std::vector<Slot> slots_;
};

}  // namespace foveola
