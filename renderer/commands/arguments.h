// Parses the notations of the command line: "2048x1024", "1,2,3", "-30,10".
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "renderer/base/angles.h"
#include "renderer/base/scene_source.h"
#include "renderer/progressive/headless_render.h"
#include "renderer/view/viewport.h"

namespace foveola {

/// Throws UsageError that names --method for a text that make_view_sampler refuses.
void require_method(const std::string& method);

/// "WIDTHxHEIGHT" in pixels, each in [1, 65536]. option names the argument in the UsageError.
IVec2 parse_size(const std::string& option, const std::string& text);

/// A size in the notation of parse_size().
std::string size_text(const IVec2& size);

/// Default size of a live preview's film, in pixels.
inline constexpr IVec2 live_film_size{4096, 2048};

/// "WIDTH" or "WIDTHxHEIGHT" in degrees, each strictly between 0 and 180.
struct FieldsOfView {
  double horizontal_deg = 0.0;
  std::optional<double> vertical_deg;
};
FieldsOfView parse_fields_of_view(const std::string& option, const std::string& text);

/// "axis x,axis y,k1,k2", the axis in [0, 1].
RadialLens parse_lens(const std::string& option, const std::string& text);

/// The help text of --camera.
inline constexpr const char* camera_help =
    "Camera position: x,y,z in metres, or the name of one of the file's cameras as 'foveola scene "
    "info' lists them, such as 'camera 2' for a second one without a name (default: the scene's "
    "camera, else chosen: inside a room, or outside with everything in view)";

/// The finite number in all of `text`; nullopt if it is not one.
std::optional<double> parse_finite_number(std::string_view text);

/// "x,y,z", all finite.
DVec3 parse_vec3(const std::string& option, const std::string& text);

/// "azimuth,elevation[,turbidity]" of a sun, angles in degrees.
SunAndSky parse_sky(const std::string& option, const std::string& text);

/// "x,y,sample"; x and y are at most 65535.
SampleAddress parse_sample(const std::string& option, const std::string& text);

/// "azimuth,elevation" in degrees: finite, elevation in [-90, 90].
AzimuthElevation parse_azimuth_elevation(const std::string& option, const std::string& text);

}  // namespace foveola
