// The textures that a scene's materials use, collected before they are decoded.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "renderer/base/parallel.h"
#include "renderer/scene/texture.h"

namespace foveola {

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
  /// called once for each, on several threads.
  template <typename TexelsOf>
  std::vector<Texture> decode(TexelsOf texels_of) const {
    std::vector<std::shared_ptr<const Texels>> texels(contents_.size());
    const Workers workers;
    workers.for_each_block(contents_.size(), 1, [&](std::size_t i, std::size_t) {
      texels[i] = texels_of(contents_[i], with_mips_[i]);
    });
    std::vector<Texture> textures;
    textures.reserve(textures_.size());
    for (const auto& [number, sampler] : textures_) {
      textures.emplace_back(texels[number], sampler);
    }
    return textures;
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
