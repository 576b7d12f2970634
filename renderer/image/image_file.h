// Reads and writes image files, through OpenImageIO.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "renderer/base/vec.h"
#include "renderer/image/image.h"
#include "renderer/image/tone_mapping.h"

namespace foveola {

/// Throws UsageError unless the extension is .exr, .png, .jpg or .jpeg.
void require_image_extension(const std::filesystem::path& path);

/// Whether a file of this name holds radiances, which ignore exposure: an .exr.
bool holds_radiance(const std::filesystem::path& path);

/// Names and values in the header of an .exr.
using ImageFacts = std::map<std::string, std::string>;

/// The header fact of the projection, and its value for a 360-degree image.
inline constexpr const char* projection_fact = "foveola:projection";
inline constexpr const char* panorama_projection = "equirectangular";

/// Writes .exr: float channels R, G, B, `samples` and, if known, `variance`, with `facts` in its
/// header. Writes .png, .jpg: sRGB in 8 bits after `exposure_stops` and `curve`; a panorama is
/// marked as one. The file appears whole or not at all. Throws Error if it cannot be written.
void write_film_image(const std::filesystem::path& path, const FilmImage& image,
                      double exposure_stops, const ImageFacts& facts = {},
                      ToneCurve curve = ToneCurve::plain);

/// A linear image as .exr (R, G, B) or .png, .jpg (as write_film_image).
void write_image(const std::filesystem::path& path, const RgbImage& image, double exposure_stops,
                 ToneCurve curve = ToneCurve::plain);

/// Width and height in pixels, without reading them. Throws Error as read_film_image.
IVec2 image_size(const std::filesystem::path& path);

/// Reads an image of ImageFormats::picture as linear colours, by read_linear_color(). Sample counts
/// come from the channel `samples`, or are 1 without it; variances from `variance`. Throws Error if
/// it cannot be read.
FilmImage read_film_image(const std::filesystem::path& path);

}  // namespace foveola
