// Collects the textures of a scene's materials before they are decoded, and handles those that
// cannot be.
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

/// Decoded textures and their faults.
struct DecodedTextures {
  std::vector<Texture> textures;
  std::vector<int> place_of;  ///< index in `textures` for each index from add(); -1: none
  std::vector<std::exception_ptr> faults;  ///< per content; null: no fault
};

/// The decoded textures. Renumbers the textures of `materials`, and removes the others. If
/// `is_strict`, throws the first fault; else warns of each fault with a different text_of().
std::vector<Texture> take_textures(DecodedTextures decoded, std::vector<Material>& materials,
                                   bool is_strict,
                                   std::string (*text_of)(const std::runtime_error& fault),
                                   Warnings& warnings);

/// Warns of a texture that is left out. what: its name and its fault.
void warn_of_lost_texture(const std::string& what, const std::string& place, Warnings& warnings);

/// Content: the ordered key of one Texels, shared by textures that differ only in their samplers.
template <typename Content>
class TextureList {
 public:
  /// The index, in the result of decode(), of the texture of `content` with `sampler`.
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

  /// Each content once, in the order of addition.
  const std::vector<Content>& contents() const { return contents_; }

  /// texels_of: returns the Texels of a Content (shared_ptr<const Texels>), with or without coarser
  /// levels; called once per content, on several threads. A std::runtime_error that it throws is
  /// kept.
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
  std::map<Content, std::size_t> number_of_;               ///< index into both
  std::vector<std::pair<std::size_t, Sampler>> textures_;  ///< a content's number, and its sampler
  std::map<std::pair<std::size_t, Sampler>, int> index_of_;  ///< into textures_
};

}  // namespace foveola
