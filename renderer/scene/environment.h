// Environment light: from an image, or a daylight model by the sun's place.
#pragma once

#include <filesystem>
#include <optional>

#include "renderer/base/scene_source.h"
#include "renderer/scene/scene.h"
#include "renderer/scene/warnings.h"

namespace foveola {

/// Loads an equirect image of ImageFormats::environment. Negative and NaN pixels become black;
/// infinite ones 65504, the maximum of a half float, or the brightest finite value if that is more.
/// Both warn, and so do primaries that span no colour space. Throws Error if it cannot be read or
/// needs too much memory for its size: see require_modest_memory.
Environment load_environment(const std::filesystem::path& path, Warnings& warnings);

/// The sky without the sun's disc, as an equirect map of 1024 x 512 texels: the model of Preetham,
/// Shirley and Smits 1999, "A Practical Analytic Model for Daylight", appendix A.2. A radiance of 1
/// has the luminance 1000 cd/m^2. The ground below the horizon reflects the light of sky and sun.
/// With a low sun the model is too bright (Zotti, Wilkie and Purgathofer 2007, "A Critical Review
/// of the Preetham Skylight Model"). The model does not cover a sun below the horizon: it gives the
/// sky of sunset, dimmed tenfold for each 3 degrees (some 400 lx at sunset are 3.4 lx at the end of
/// civil twilight, 6 degrees below). Throws Error unless the turbidity lies in [2, 10], the sun's
/// elevation in [-pi/2, pi/2] and the albedo in [0, 1].
Environment sky_environment(const SunAndSky& sun_and_sky);

/// The sun, whose irradiance of 1 is an illuminance of 1000 lx. Attenuated by Rayleigh scattering,
/// aerosols and ozone as in the paper's appendix A.1. (Mixed gases and water vapour are left out:
/// they absorb beyond 690 nm, where vision is weak.) nullopt if it is below the horizon.
std::optional<PunctualLight> sun_light(const SunAndSky& sun_and_sky);

}  // namespace foveola
