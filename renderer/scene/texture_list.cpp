#include "renderer/scene/texture_list.h"

#include <set>

namespace foveola {
namespace {

/// Renumbers the textures of `materials` to those of `decoded`, without the lost ones.
void renumber_textures(std::vector<Material>& materials, const DecodedTextures& decoded) {
  for (Material& material : materials) {
    for (TextureUse* use : texture_uses(material)) {
      if (use->exists()) {
        use->texture = decoded.place_of[static_cast<std::size_t>(use->texture)];
      }
    }
  }
}

}  // namespace

std::vector<Texture> take_textures(DecodedTextures decoded, std::vector<Material>& materials,
                                   bool is_strict,
                                   std::string (*text_of)(const std::runtime_error& fault),
                                   Warnings& warnings) {
  std::set<std::string> lost;
  for (const std::exception_ptr& thrown : decoded.faults) {
    try {
      if (thrown) {
        std::rethrow_exception(thrown);
      }
    } catch (const std::runtime_error& fault) {
      if (is_strict) {
        throw;
      }
      if (const std::string text = text_of(fault); lost.insert(text).second) {
        warn_of_lost_texture(text, {}, warnings);
      }
    }
  }
  renumber_textures(materials, decoded);
  return std::move(decoded.textures);
}

void warn_of_lost_texture(const std::string& what, const std::string& place, Warnings& warnings) {
  warnings.add("a texture is left out: " + what, place);
}

}  // namespace foveola
