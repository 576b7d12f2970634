// What loading a scene decoded, kept for loading its next version.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "renderer/scene/scene.h"
#include "renderer/scene/textures/texture.h"

namespace foveola {

/// Parts by the SHA-256 of all that they were made from. May be used from several threads.
template <typename Part>
class KeptParts {
 public:
  /// The part with this digest, or null.
  std::shared_ptr<const Part> find(const std::string& digest) {
    const std::lock_guard lock(mutex_);
    for (const Parts* parts : {&in_use_, &former_}) {
      if (const auto known = parts->find(digest); known != parts->end()) {
        return in_use_[digest] = known->second;
      }
    }
    return nullptr;
  }

  void keep(const std::string& digest, std::shared_ptr<const Part> part) {
    const std::lock_guard lock(mutex_);
    in_use_[digest] = std::move(part);
  }

  /// Forgets what was neither found nor kept since the last call.
  void forget_unused() {
    const std::lock_guard lock(mutex_);
    former_ = std::exchange(in_use_, {});
  }

 private:
  using Parts = std::map<std::string, std::shared_ptr<const Part>>;

  std::mutex mutex_;
  Parts former_;
  Parts in_use_;  ///< since forget_unused() was called
};

/// The part of the digest that `digest()` returns, if it is kept, else the one that `make()`
/// returns, which then is. kept: null for none, then nothing is digested.
template <typename Part, typename Digest, typename Make>
std::shared_ptr<const Part> kept_or_made(KeptParts<Part>* kept, Digest digest, Make make) {
  if (kept == nullptr) {
    return std::make_shared<const Part>(make());
  }
  const std::string name = digest();
  std::shared_ptr<const Part> part = kept->find(name);
  if (part == nullptr) {
    part = std::make_shared<const Part>(make());
    kept->keep(name, part);
  }
  return part;
}

struct KeptSceneParts {
  /// Whether each mesh becomes a prototype and instances, so that it is known again where it stands
  /// elsewhere. Rays are slower then.
  bool places_instances = false;
  KeptParts<Mesh> meshes;  ///< of glTF's primitives, in their own space, without material and name
  KeptParts<Texels> texels;
  /// Of the file that was read last: fresh memory takes longer than reading the next one into it.
  std::string file_content;

  void forget_unused() {
    meshes.forget_unused();
    texels.forget_unused();
  }
};

}  // namespace foveola
