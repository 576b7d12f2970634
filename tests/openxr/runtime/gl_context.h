// The application's OpenGL context.
#pragma once

#include "tests/openxr/runtime/state.h"

namespace foveola::test::openxr {

/// What the application has chained to its session's creation. Refuses what no session could use.
GlBinding binding_of(const void* next);

/// The context, current on this thread for as long as this lives; what was current before is again
/// afterwards.
class CurrentContext {
 public:
  explicit CurrentContext(const GlBinding& gl);
  ~CurrentContext();
  CurrentContext(const CurrentContext&) = delete;
  CurrentContext& operator=(const CurrentContext&) = delete;

 private:
  Display* display_;
  bool was_current_;
  GLXContext context_before_;
  GLXDrawable drawing_before_;
  GLXDrawable reading_before_;
};

/// New images, of which each texture has the size and the format that the application asked for.
std::vector<GLuint> make_textures(const XrSwapchainCreateInfo& info, std::size_t count);
void remove_textures(const std::vector<GLuint>& textures);

/// A rectangle of a layer of a texture, its lowest row first, as 3 bytes a pixel. What sRGB
/// textures hold is not converted.
std::vector<unsigned char> pixels_of(const Swapchain& swapchain, GLuint texture,
                                     const XrRect2Di& rectangle, std::uint32_t layer);

}  // namespace foveola::test::openxr
