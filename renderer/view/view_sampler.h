// View samplers: maps from the unit square to directions, with their densities.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/view/viewport.h"
#include "renderer/view/weight_image.h"

namespace foveola {

/// A direction to trace (unit length, world) and its place in the equirect image.
struct ViewSample {
  Vec3 direction{0.0F, 0.0F, -1.0F};
  Vec2 image{0.5F};  ///< as by equirect_from_direction: from the top left, in [0, 1]
};

/// A sampler's view, gaze and pointer in one frame.
struct Aim {
  Viewport viewport;
  Vec3 gaze{0.0F, 0.0F, -1.0F};  ///< unit length, world
  std::optional<Vec3> pointer;   ///< the user's pointer (unit length, world); default: the gaze
  std::shared_ptr<const SeenPart> seen = nullptr;  ///< of the viewport's plane; null: all of it
};

/// One method of choosing directions. Virtual calls are per batch, never per sample.
class ViewSampler {
 public:
  virtual ~ViewSampler() = default;
  /// Sets the frame's aim. Called before each frame, never while samples are drawn.
  virtual void aim(const Aim& aim) = 0;
  /// Maps points of the unit square [0, 1)^2 one to one to samples. Called from several threads at
  /// once, each with a part of the points.
  virtual void sample(std::span<const Vec2> points, std::span<ViewSample> samples) const = 0;
  /// Whether each sample's image position equals its point, so that a point chooses the pixel.
  virtual bool keeps_points() const { return false; }
  /// The probability density of `direction` per steradian; integrates to 1 over the sphere.
  virtual double density_per_sr(const Vec3& direction) const = 0;
};

/// The methods of the published study: "od", "vp", "fv".
const std::vector<std::string>& published_methods();

/// A sampler by its text, "NAME" or "NAME:KEY=VALUE,KEY=VALUE". It must be aimed before use. Throws
/// Error for an invalid text or file. Angles are in degrees; values with a comma or a plus are in
/// double quotes.
///
/// od        uniform over the equirect image
/// vp        uniform over the viewport's plane, as far as a headset's lenses show it
/// vp-rect   uniform over the rectangle of the image that bounds the viewport
/// fv        following visual acuity around the gaze: acuity=reddy (default), guenter with slope,
///           linear with inner, outer, least, weier1, weier2, weier3, or watson with eye=both
///           (default), left, right; exponent (default: the model's), cutoff (80), measure=planar
///           (default, the paper's) or solid-angle
/// fv-paper  the paper's fv as printed: radii by its equation 7, whose jump leaves a thin ring
///           without samples (Equation7Distribution), where fv has the exact inverse
/// fv-map    an image around the gaze: file, extent (80; the eccentricity at half of its larger
///           side)
/// mask      a mask over the equirect image, reloaded when it changes: file, floor (0; weight added
///           to every pixel, in mean weights)
/// pointer   a Gaussian around the pointer: radius (10; its standard deviation), cutoff (80);
///           azimuth, elevation: a fixed place instead of the pointer
/// crop      uniform over a fixed rectangle of the image around azimuth, elevation (0), of width
///           and height (30)
/// hybrid    several methods: hybrid:0.9*fv+0.1*od, with shares of the samples by weight over the
///           weights' sum; a hybrid within it is in double quotes
std::unique_ptr<ViewSampler> make_view_sampler(std::string_view method);

/// Returns the weights of a file named in a method's text.
using FindWeights = std::function<WeightImage(const std::string& file)>;

/// As above, but calls `find_weights` for each file of the method and its parts instead of reading
/// it; masks never change. Also throws the exceptions of `find_weights`.
std::unique_ptr<ViewSampler> make_view_sampler(std::string_view method,
                                               const FindWeights& find_weights);

/// Notes about a method's meaning: one line per hybrid whose weights do not sum to 1, with its
/// parts' shares. Throws Error for an invalid text.
std::vector<std::string> method_notes(std::string_view method);

/// Whether a method, or a part of it, follows the pointer of its Aim. Throws Error for an invalid
/// text.
bool follows_pointer(std::string_view method);

/// Whether a method, or a part of it, follows the gaze of its Aim; a method that follows a pointer
/// does so without one. Throws Error for an invalid text.
bool follows_gaze(std::string_view method);

/// `method` with its pointer, and those of its parts, fixed at a place in the world; unchanged if
/// it follows no pointer. Throws Error for an invalid text.
std::string with_pointer(std::string_view method, const AzimuthElevation& pointer);

/// The sampler's density per steradian at `direction` (unit length, world). If it is 0 exactly
/// there, the maximum of four places a hundredth of a degree around it. For pixels and patches
/// larger than that: fv-paper leaves out a ring of half a hundredth, and a pixel centred in the
/// ring is reached all the same.
double density_around(const ViewSampler& sampler, const Vec3& direction);

}  // namespace foveola
