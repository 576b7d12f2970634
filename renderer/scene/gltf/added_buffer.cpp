#include "renderer/scene/gltf/added_buffer.h"

#include <stdexcept>
#include <utility>

#include <nlohmann/json.hpp>

#include "renderer/scene/gltf/fault.h"
#include "renderer/scene/textures/decoded_memory.h"

namespace foveola {

std::size_t add_gltf_buffer(nlohmann::json& document,
                            std::vector<std::vector<unsigned char>>& buffers,
                            std::vector<unsigned char> bytes) {
  document["buffers"].push_back({{"byteLength", bytes.size()}});
  buffers.push_back(std::move(bytes));
  return buffers.size() - 1;
}

void require_modest_gltf_memory(std::size_t decoded_bytes, std::size_t encoded_bytes,
                                const std::string& place) {
  try {
    require_modest_memory(decoded_bytes, encoded_bytes);
  } catch (const std::runtime_error& refusal) {
    throw GltfFault(place, refusal.what());
  }
}

}  // namespace foveola
