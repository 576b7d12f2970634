#include "renderer/trace/light_choice.h"

#include <cassert>
#include <numeric>

namespace foveola {

LightChoice::LightChoice(std::span<const double> powers, std::span<const LightBounds> bounds,
                         std::size_t most_in_table) {
  assert(powers.size() == bounds.size());
  if (powers.size() > most_in_table) {
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
  // Both numbers are one with twice the digits: deep in a large tree 24 bits do not suffice.
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
