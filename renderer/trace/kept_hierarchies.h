// Embree's hierarchies of single meshes, kept for the next version of a scene.
#pragma once

#include <cstdint>
#include <memory>

namespace foveola {

/// Scenes that are built with the same one of these share the hierarchies of prototypes whose
/// triangles are the same, and build only what is new. It keeps those of the scene that was built
/// last; scenes keep what they use, and may outlive it. For one scene at a time.
class KeptHierarchies {
 public:
  KeptHierarchies();
  ~KeptHierarchies();
  KeptHierarchies(const KeptHierarchies&) = delete;
  KeptHierarchies& operator=(const KeptHierarchies&) = delete;

  /// Hierarchies of prototypes that were built, not found, in all scenes so far.
  std::uint64_t built() const;

 private:
  friend class RayScene;
  struct Embree;
  std::unique_ptr<Embree> embree_;
};

}  // namespace foveola
