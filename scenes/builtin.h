// The scenes that Foveola makes itself, so that demo and tests need no download. They are made by a
// program of their own (generate.cpp); what finds, names and keeps them is builtin_files.h.
#pragma once

#include <cstdint>
#include <string>

#include "scenes/modelling/model.h"

namespace foveola::scenes {

/// An open court between two arcaded storeys: cloth, plants with cut-out leaves, sun and sky.
Model make_arcade(std::uint32_t seed);
/// A cathedral's nave with two aisles, vaults and an apse, lit through stained glass.
Model make_church(std::uint32_t seed);
/// A long table with its chairs under many ceiling lights.
Model make_meeting_room(std::uint32_t seed);
/// A classroom by day: desks, a blackboard, books, a skeleton, sun through a row of windows.
Model make_schoolroom(std::uint32_t seed);
/// A car under the softboxes of a photographer's studio.
Model make_studio_car(std::uint32_t seed);

/// The scene, or with another seed a variant of it: the same things in the same places, of other
/// stones, cloths, leaves and scribbles. Throws Error if there is no such scene.
Model make_builtin(const std::string& name, std::uint32_t seed = default_seed);

}  // namespace foveola::scenes
