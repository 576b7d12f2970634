// Light from infinitely far: an image of it, or daylight, which the sun's place decides.
#pragma once

#include <filesystem>
#include <optional>

#include "renderer/base/scene_source.h"
#include "renderer/scene/scene.h"
#include "renderer/scene/warnings.h"

namespace foveola {

/// An equirect EXR, HDR, PNG or JPEG image as environment. Pixels that are negative or NaN become
/// black, infinite ones 65504, the most that a half float holds, or as bright as the brightest
/// other one: with warnings. Throws Error if it cannot be read or, for its size, would take too
/// much memory: see require_modest_memory.
Environment load_environment(const std::filesystem::path& path, Warnings& warnings);

/// The sky without the sun's disc, as an equirect map of 1024 x 512 texels: the model of Preetham,
/// Shirley and Smits 1999, "A Practical Analytic Model for Daylight", appendix A.2. A radiance of
/// 1 has the luminance 1000 cd/m^2. Below the horizon lies a ground that reflects what falls on it
/// from sky and sun. With a low sun the model is too bright (Zotti, Wilkie and Purgathofer 2007, "A
/// Critical Review of the Preetham Skylight Model"). A sun below the horizon, for which there is no
/// model, gives the sky of sunset, dimmed tenfold for each 3 degrees (some 400 lx at sunset are 3.4
/// lx at the end of civil twilight, 6 degrees below). Throws Error unless the turbidity lies in [2,
/// 10], the sun's elevation in [-pi/2, pi/2] and the albedo in [0, 1].
Environment sky_environment(const SunAndSky& sun_and_sky);

/// The sun, whose irradiance of 1 is an illuminance of 1000 lx, as the paper's appendix A.1
/// attenuates it: by Rayleigh scattering, aerosols and ozone. (Mixed gases and water vapour absorb
/// where the eye hardly sees, beyond 690 nm, and are left out.) None where it is below the horizon.
std::optional<PunctualLight> sun_light(const SunAndSky& sun_and_sky);

}  // namespace foveola
