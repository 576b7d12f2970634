// Says in a PNG or JPEG file that it is a 360-degree image, so that viewers open it as one.
#pragma once

#include <string>

namespace foveola {

/// `file`, the bytes of a PNG or JPEG image of width x height pixels, with XMP of Google's
/// "Photo Sphere XMP Metadata": a whole equirectangular panorama.
std::string with_panorama_tag(std::string file, int width, int height);

}  // namespace foveola
