// Keeps decoded parts of a scene for loading its next version.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "renderer/scene/scene.h"
#include "renderer/scene/textures/texture.h"

namespace foveola {

/// Parts by the SHA-256 of everything they were made from. Thread-safe.
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

  /// Forgets parts that were neither found nor kept since the last call.
  void forget_unused() {
    const std::lock_guard lock(mutex_);
    former_ = std::exchange(in_use_, {});
  }

 private:
  using Parts = std::map<std::string, std::shared_ptr<const Part>>;

  std::mutex mutex_;
  Parts former_;
  Parts in_use_;  ///< since the last forget_unused()
};

/// The part with the digest `digest()` if it is kept; else the result of `make()`, which is then
/// kept. kept: null makes without a digest.
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
  /// Makes each mesh a prototype with instances, so that it is recognised when it moves. Rays are
  /// slower then.
  bool places_instances = false;
  KeptParts<Mesh> meshes;  ///< of glTF primitives, in their own space, without material and name
  KeptParts<Texels> texels;
  /// Of the last file; its memory is reused, since fresh memory takes longer than reading.
  std::string file_content;

  void forget_unused() {
    meshes.forget_unused();
    texels.forget_unused();
  }
};

}  // namespace foveola
