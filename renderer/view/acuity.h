// Models of peripheral visual acuity from the literature.
#pragma once

#include <functional>
#include <vector>

namespace foveola {

/// Relative visual acuity around the gaze.
struct AcuityModel {
  /// At an eccentricity in [0, 180] degrees: 1 at the gaze, decreasing, positive below reach_deg.
  std::function<double(double eccentricity_deg)> at;
  std::vector<double> knees_deg;  ///< kinks of the function, ascending
  double reach_deg = 180.0;       ///< 0 from there on
  /// Default power of the acuity that gives the sample density. Samples per area follow the square
  /// of a linear acuity, but some models already fall as fast.
  double default_exponent = 1.0;
};

/// Maximum eccentricity at which Reddy's acuity is 1.
inline constexpr double reddy_knee_deg = 5.79;

/// Reddy's relative visual acuity (Reddy 2001, "Perceptually optimized 3D graphics", as eq. 1 of
/// Koskela et al. 2018): 1 up to 5.79 degrees, 7.49 / (0.3 e + 1)^2 beyond.
double reddy_acuity(double eccentricity_deg);
AcuityModel reddy_model();

/// The inverse of the linear minimum angle of resolution, omega_0 + slope e with omega_0 = 1/48
/// degree, relative to the gaze (Guenter et al. 2012, "Foveated 3D graphics", section 3, which is
/// not in public text: 1/48 and its place are from memory, unchecked). slope: degrees per degree,
/// positive; the authors found 0.0220 to 0.0275.
AcuityModel linear_resolution_model(double slope);

/// 1 up to `inner_deg`, falling linearly to `least` at `outer_deg`, constant beyond (Vaidyanathan
/// et al. 2014; Stengel et al. 2016; Weier et al. 2016). 0 <= inner_deg < outer_deg, least in [0,
/// 1].
AcuityModel linear_fall_off_model(double inner_deg, double outer_deg, double least);

/// The four half-meridians of one eye's visual field. Temporal is away from the nose: to the right
/// of the gaze for the right eye.
///
/// Watson's table 1 calls its rows temporal, superior, nasal and inferior. Temporal and nasal are
/// those of the field, but superior and inferior those of the retina, whose image is inverted.
/// Evidence: the row superior has more cells than the row inferior, and the superior retina exceeds
/// the inferior by 60 % in the periphery (Curcio and Allen 1990, "Topography of ganglion cells in
/// human retina", abstract). Accordingly Kupers et al. (2022, "Asymmetries around the visual
/// field", fig. 2) plot his superior row as the lower visual field, and people see better below the
/// gaze than above it.
enum class Meridian { temporal, lower, nasal, upper };

/// Relative density of midget ganglion cells' receptive fields per square degree along a meridian:
/// 1 at the gaze (2 x 14804.6 of them), decreasing (Watson 2014, "A formula for human retinal
/// ganglion cell receptive field density as a function of visual field location", eq. 8 with table
/// 1). eccentricity_deg >= 0. Already per area: its exponent is 1.
double watson_density(Meridian meridian, double eccentricity_deg);

}  // namespace foveola
