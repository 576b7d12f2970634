// Images of weights for the samplers that read them.
#pragma once

#include <filesystem>
#include <functional>

namespace foveola::test {

/// Writes a grey .exr whose pixel (x, y) has the value of `weight`, with (0, 0) the top left corner
/// of the image and (1, 1) the bottom right one.
void write_weights(const std::filesystem::path& path, int width, int height,
                   const std::function<double(double x, double y)>& weight);

/// `method` with MAP and MASK replaced by the paths of two images in `folder`, which are written
/// where they are needed. Both have dark and light parts and black ones.
std::string with_images(std::string method, const std::filesystem::path& folder);

}  // namespace foveola::test
