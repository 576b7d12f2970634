#include "renderer/trace/lights/light_choice.h"

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
  // Any item left in either list fills its slot up to rounding, and stays its only item.
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

LightChoice::LightChoice(std::span<const double> powers, std::span<const LightBounds> bounds,
                         std::size_t max_in_table) {
  assert(powers.size() == bounds.size());
  if (powers.size() > max_in_table) {
    method_.emplace<LightTree>(bounds);
    return;
  }
  const double total = std::accumulate(powers.begin(), powers.end(), 0.0);
  Table& table = method_.emplace<Table>(Table{AliasTable(powers), {}});
  for (const double power : powers) {
    table.probabilities.push_back(static_cast<float>(power / total));
  }
}

std::optional<ChosenLight> LightChoice::sample(const ShadingPoint& shading_point, const Vec2& u,
                                               const LightTree::Preferences* preferences) const {
  if (const Table* table = std::get_if<Table>(&method_)) {
    const std::size_t light = table->alias.sample(u);
    return ChosenLight{light, table->probabilities[light]};
  }
  // Together they have twice the digits: deep in a large tree 24 bits do not suffice.
  return std::get<LightTree>(method_).sample(shading_point, u.x + 0x1p-24 * u.y, preferences);
}

float LightChoice::probability(const ShadingPoint& shading_point, std::size_t light,
                               const LightTree::Preferences* preferences) const {
  if (const Table* table = std::get_if<Table>(&method_)) {
    return table->probabilities[light];
  }
  return std::get<LightTree>(method_).probability(shading_point, light, preferences);
}

}  // namespace foveola
