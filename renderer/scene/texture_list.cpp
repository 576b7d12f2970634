#include "renderer/scene/texture_list.h"

namespace foveola {

void renumber_textures(std::vector<Material>& materials, const DecodedTextures& decoded) {
  for (Material& material : materials) {
    for (TextureUse* use : texture_uses(material)) {
      if (use->exists()) {
        use->texture = decoded.place_of[static_cast<std::size_t>(use->texture)];
      }
    }
  }
}

void rethrow_fault(const std::vector<std::exception_ptr>& faults) {
  for (const std::exception_ptr& fault : faults) {
    if (fault) {
      std::rethrow_exception(fault);
    }
  }
}

void warn_of_lost_texture(const std::string& what, const std::string& place, Warnings& warnings) {
  warnings.add("a texture is left out: " + what, place);
}

}  // namespace foveola
