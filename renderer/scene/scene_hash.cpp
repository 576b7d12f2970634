#include "renderer/scene/scene_hash.h"

#include <string_view>

#include "renderer/base/files/digest.h"

namespace foveola {

std::string scene_sha256(const std::string& scene_file_sha256, const FileHashes& referred) {
  if (referred.empty()) {
    return scene_file_sha256;
  }
  std::string lines = scene_file_sha256 + "\n";
  for (const auto& [path, digest] : referred) {
    lines += digest + "\n";
  }
  return sha256(std::string_view(lines));
}

}  // namespace foveola
