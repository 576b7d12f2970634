// The random numbers of a path's vertices.
#pragma once

#include <cstddef>
#include <cstdint>

#include "renderer/base/lanes.h"
#include "renderer/base/random.h"
#include "renderer/base/vec.h"
#include "renderer/trace/lights.h"

namespace foveola {

struct GroupNumbers;

/// Which of a vertex's numbers decide something; the others need not be computed.
struct NeededNumbers {
  bool light_kind;    ///< there are lights of several kinds
  bool light_choice;  ///< there are several lights of one kind
  bool lobe;          ///< there are surfaces with several lobes
  bool roulette;
  bool keys;  ///< there are surfaces that only some rays meet
};

/// The random numbers of one vertex, in this order. Each has its own dimension whatever was decided
/// before.
struct VertexNumbers {
  float light_kind, lobe, roulette;
  Vec2 light_choice, light_point, scattering;
  std::uint32_t shadow_key, next_key;

  explicit VertexNumbers(SampleStream& random) {
    light_kind = random.next_1d();
    light_choice = random.next_2d();
    light_point = random.next_2d();
    lobe = random.next_1d();
    scattering = random.next_2d();
    roulette = random.next_1d();
    shadow_key = random.next_bits();
    next_key = random.next_bits();
  }

  /// The numbers of a lane in a group.
  VertexNumbers(const GroupNumbers& group, std::size_t lane);
};

/// The random numbers of a group of paths; those that are not needed are 0.
struct GroupNumbers {
  LightNumbers light{};
  Floats lobe{}, roulette{};
  Vec2s scattering;
  Uints shadow_key{}, next_key{};

  GroupNumbers(SampleStreams& random, const NeededNumbers& needed) {
    if (needed.light_kind) {
      light.kind.store(random.next_1d());
    } else {
      random.skip(1);
    }
    if (needed.light_choice) {
      light.choice.store(random.next_2d());
    } else {
      random.skip(1);
    }
    light.point.store(random.next_2d());
    if (needed.lobe) {
      lobe = random.next_1d();
    } else {
      random.skip(1);
    }
    scattering = random.next_2d();
    if (needed.roulette) {
      roulette = random.next_1d();
    } else {
      random.skip(1);
    }
    if (needed.keys) {
      shadow_key = random.next_bits();
      next_key = random.next_bits();
    } else {
      random.skip(2);
    }
  }
};

inline VertexNumbers::VertexNumbers(const GroupNumbers& group, std::size_t lane)
    : light_kind(group.light.kind[lane]),
      lobe(group.lobe[lane]),
      roulette(group.roulette[lane]),
      light_choice(group.light.choice.at(lane)),
      light_point(group.light.point.at(lane)),
      scattering(group.scattering.x[lane], group.scattering.y[lane]),
      shadow_key(group.shadow_key[lane]),
      next_key(group.next_key[lane]) {}

}  // namespace foveola
