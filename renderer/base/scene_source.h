// The description of a scene: its file, the camera, and added lights.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "renderer/base/angles.h"
#include "renderer/base/text/words.h"

namespace foveola {

/// A one-sided rectangular light, for scenes without lights. It emits towards `normal`, which must
/// be one of the axes +-X, +-Y, +-Z.
struct RectangleLight {
  Vec3 center{0.0F};
  Vec2 size{1.0F};  ///< metres, along the two axes other than the normal's, in the order x, y, z
  Vec3 normal{0.0F, -1.0F, 0.0F};
  Rgb radiance{1.0F};
};

/// The real sun's angular radius, seen from the earth.
constexpr double solar_angular_radius_rad = 0.00465;

/// A sun alone, beside any environment.
struct Sun {
  AzimuthElevation place;                                ///< direction towards it
  Rgb irradiance{1.0F};                                  ///< on a surface that faces it
  double angular_radius_rad = solar_angular_radius_rad;  ///< 0: sharp shadows, seen by no ray
};

/// Daylight. The sun's azimuth and elevation give its place in the sky.
struct SunAndSky {
  AzimuthElevation sun;
  double turbidity = 3.0;      ///< haze: 2 (very clear) to 10
  float ground_albedo = 0.2F;  ///< reflectance below the horizon, in [0, 1]
};

/// Units of a glTF file's punctual lights (KHR_lights_punctual). Emissive materials hold radiances
/// in either case, and are used unchanged.
enum class LightUnits : std::uint8_t {
  /// Lux and candela, as the extension says. Division by 683 lm/W gives irradiances and radiant
  /// intensities. Blender's exporter multiplies by this luminous efficacy, which the SI's
  /// definition of the candela gives to light of 540 THz.
  photometric,
  /// Irradiances and radiant intensities: used unchanged.
  radiometric
};
inline constexpr std::array light_unit_words{
    Word<LightUnits>{"photometric", LightUnits::photometric},
    Word<LightUnits>{"radiometric", LightUnits::radiometric}};

/// An object in the scene that a participant may choose to look at.
struct ObjectOfInterest {
  std::string name;
  Vec3 position{0.0F};      ///< world, metres; its direction is seen from the camera
  float radius_deg = 4.0F;  ///< angular radius that covers it, seen from the camera
};

/// Limits of exposures, chosen or described: from minus to plus this number of stops.
inline constexpr double max_exposure_stops = 40.0;

/// The limits of a described camera's field of view.
inline constexpr double narrowest_camera_fov_deg = 1e-3;
inline constexpr double widest_camera_fov_deg = 179.99;
/// Beyond these, pictures of the default size are one pixel wide or high anyway.
inline constexpr double least_camera_aspect_ratio = 1e-3;
inline constexpr double largest_camera_aspect_ratio = 1e3;

struct SceneSource {
  std::string name;  ///< the user's name for it
  std::string title;
  std::filesystem::path file;        ///< .glb, .gltf or .obj
  std::filesystem::path descriptor;  ///< the descriptor of all other members; empty if none
  /// The descriptor, if it was found beside the file without being named.
  std::filesystem::path descriptor_beside;
  /// SHA-256 of the file that the descriptor was written for; empty if not stated. Another file is
  /// accepted with a warning.
  std::string described_sha256;
  /// Length of the file's unit, for files that are not glTF. All other lengths here are in metres.
  double metres_per_unit = 1.0;
  /// Units of a glTF file's punctual lights. If absent, the program that wrote the file decides:
  /// photometric for the versions of Blender's exporter that write them so, else radiometric.
  std::optional<LightUnits> light_units;
  /// Whether a missing or unreadable texture or material library is an error. If not, the scene is
  /// shown without it, with a warning.
  bool strict = false;
  /// Time in the glTF file's animations, in seconds. nullopt: the nodes' unanimated poses.
  std::optional<double> time_s;
  std::string clip;  ///< name of the animation to apply; empty: all, in the file's order
  std::optional<Vec3> camera_position;
  AzimuthElevation heading;
  /// For ordinary pictures from that position only, see CameraView: a study and a head have
  /// neither.
  double camera_roll_rad = 0.0;
  std::optional<double> camera_vertical_fov_rad;
  std::optional<double> camera_aspect_ratio;
  /// Exposure in stops. nullopt: chosen by the viewer; studies and measurements use 0.
  std::optional<double> exposure_stops;
  /// At most one of these three, which replace the file's environment: a constant, an image, or
  /// daylight. Daylight adds its sun to the scene's lights.
  std::optional<Rgb> environment_radiance;
  std::optional<std::filesystem::path> environment_file;
  std::optional<SunAndSky> sky;
  double environment_rotation_rad = 0.0;        ///< see Environment; turns the sky's sun as well
  double environment_strength = 1.0;            ///< multiplies the environment, and the sky's sun
  std::optional<float> light_radius_m;          ///< replaces that of all point and spot lights
  std::optional<float> sun_angular_radius_rad;  ///< replaces the radius of all directional lights
  std::vector<RectangleLight> lights;
  std::vector<Sun> suns;
  std::vector<ObjectOfInterest> objects;
};

/// Finds a scene by name or path: a name of a descriptor (a built-in scene is made now if the cache
/// lacks it), else the path of a scene file. Throws Error if it is neither.
using SceneFinder = std::function<SceneSource(const std::string& name_or_path)>;

/// Finds a scene that a file names, as a protocol does: first in that file's `folder`, the base of
/// relative paths.
using SceneFinderBeside = std::function<SceneSource(const std::string& name_or_path,
                                                    const std::filesystem::path& folder)>;

}  // namespace foveola
