// The textures that a scene's materials use, collected before they are decoded, and what becomes of
// those that cannot be.
#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "renderer/base/work/parallel.h"
#include "renderer/base/work/work_scope.h"
#include "renderer/scene/scene.h"
#include "renderer/scene/textures/texture.h"
#include "renderer/scene/warnings.h"

namespace foveola {

/// Textures as far as they could be made.
struct DecodedTextures {
  std::vector<Texture> textures;
  std::vector<int> place_of;  ///< in `textures`, of each index that add() returned; -1: none
  std::vector<std::exception_ptr> faults;  ///< of each content; null if there is nothing wrong
};

/// The textures that could be made. `materials` then count these, and use no others. Throws the
/// first fault if `is_strict`, else warns of each that text_of() tells from those before it.
std::vector<Texture> take_textures(DecodedTextures decoded, std::vector<Material>& materials,
                                   bool is_strict,
                                   std::string (*text_of)(const std::runtime_error& fault),
                                   Warnings& warnings);

/// Warns of a texture that is left out. what: what it is and what is wrong with it.
void warn_of_lost_texture(const std::string& what, const std::string& place, Warnings& warnings);

/// Content: what makes one Texels, ordered. Textures that differ in their samplers only share it.
template <typename Content>
class TextureList {
 public:
  /// The index, into what decode() will return, of the texture of `content` seen through `sampler`.
  int add(const Content& content, const Sampler& sampler) {
    const std::size_t number = number_of(content);
    with_mips_[number] = with_mips_[number] || sampler.mip != MipFilter::none;
    const auto [known, is_new] =
        index_of_.try_emplace({number, sampler}, static_cast<int>(textures_.size()));
    if (is_new) {
      textures_.emplace_back(number, sampler);
    }
    return known->second;
  }

  /// Each once, in the order in which they were added.
  const std::vector<Content>& contents() const { return contents_; }

  /// texels_of: the Texels of a Content (shared_ptr<const Texels>), with coarser levels or without;
  /// called once for each, on several threads. A std::runtime_error that it throws is kept.
  template <typename TexelsOf>
  DecodedTextures decode(TexelsOf texels_of) const {
    std::vector<std::shared_ptr<const Texels>> texels(contents_.size());
    DecodedTextures decoded{.faults = std::vector<std::exception_ptr>(contents_.size())};
    const Workers workers;
    const WorkScope* const scope = WorkScope::current();
    std::atomic<std::size_t> done = 0;
    workers.for_each_block(contents_.size(), 1, [&](std::size_t i, std::size_t) {
      try {
        texels[i] = texels_of(contents_[i], with_mips_[i]);
      } catch (const std::runtime_error&) {
        decoded.faults[i] = std::current_exception();
      }
      if (scope != nullptr) {
        scope->report("textures",
                      static_cast<double>(++done) / static_cast<double>(contents_.size()));
      }
    });
    decoded.textures.reserve(textures_.size());
    for (const auto& [number, sampler] : textures_) {
      const bool is_there = texels[number] != nullptr;
      decoded.place_of.push_back(is_there ? static_cast<int>(decoded.textures.size()) : -1);
      if (is_there) {
        decoded.textures.emplace_back(texels[number], sampler);
      }
    }
    return decoded;
  }

 private:
  std::size_t number_of(const Content& content) {
    const auto [known, is_new] = number_of_.try_emplace(content, contents_.size());
    if (is_new) {
      contents_.push_back(content);
      with_mips_.push_back(false);
    }
    return known->second;
  }

  std::vector<Content> contents_;
  std::vector<bool> with_mips_;  ///< whether a sampler reads a content's coarser levels
  std::map<Content, std::size_t> number_of_;  ///< index into both
  std::vector<std::pair<std::size_t, Sampler>>
      textures_;  ///< a content's number, and how it is seen
  std::map<std::pair<std::size_t, Sampler>, int> index_of_;  ///< into textures_
};

}  // namespace foveola
