#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>

#include "tests/openxr/runtime/gl_context.h"
#include "tests/openxr/runtime/layers.h"

namespace foveola::test::openxr {
namespace {

/// Whose first row is the highest, as OpenGL's is the lowest.
void write_pixmap(const std::filesystem::path& file, const std::vector<unsigned char>& pixels,
                  const XrExtent2Di& size) {
  std::ofstream stream(file, std::ios::binary);
  stream << fmt::format("P6\n{} {}\n255\n", size.width, size.height);
  const std::size_t row_bytes = 3 * static_cast<std::size_t>(size.width);
  for (std::size_t row = static_cast<std::size_t>(size.height); row > 0; --row) {
    stream.write(reinterpret_cast<const char*>(pixels.data() + (row - 1) * row_bytes),
                 static_cast<std::streamsize>(row_bytes));
  }
}

}  // namespace

void save_pictures(const Session& session, const Frame& frame,
                   const XrCompositionLayerBaseHeader& layer) {
  const char* const folder = std::getenv("FOVEOLA_OPENXR_PICTURES");
  if (folder == nullptr) {
    return;
  }
  const CurrentContext current(session.gl);
  const auto& projection = reinterpret_cast<const XrCompositionLayerProjection&>(layer);
  for (std::uint32_t view = 0; view < projection.viewCount; ++view) {
    const XrSwapchainSubImage& image = projection.views[view].subImage;
    const std::shared_ptr<Swapchain> swapchain = runtime().swapchains.at(image.swapchain);
    write_pixmap(std::filesystem::path(folder) / fmt::format("{}-{}.ppm", frame.number, view),
                 pixels_of(*swapchain, swapchain->textures[*swapchain->last_released],
                           image.imageRect, image.imageArrayIndex),
                 image.imageRect.extent);
  }
}

}  // namespace foveola::test::openxr
