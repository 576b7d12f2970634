// Contrast sensitivity by castleCSF: colour, area, space, time, luminance and eccentricity.
#pragma once

#include "renderer/base/vec.h"

namespace foveola {

/// A Gabor patch, the stimulus of psychophysics.
struct CsfStimulus {
  double frequency_cpd = 1.0;          ///< cycles per degree, above 0
  double temporal_frequency_hz = 0.0;  ///< 0 or more
  double luminance_cd_m2 = 100.0;      ///< of the background, L + M; above 0
  double area_deg2 = 1.0;              ///< pi sigma^2 of its Gaussian window, above 0
  double eccentricity_deg = 0.0;       ///< from the fixation, 0 or more
  /// Direction of the patch in the visual field of one eye: 0 temporal, 90 up, 180 nasal, 270 down.
  /// With both eyes open every direction is temporal for one of them, to about 60 degrees.
  double visual_field_deg = 0.0;
};

/// Sensitivities of the three cardinal mechanisms: inverse cone contrasts at threshold.
struct CastleSensitivity {
  double achromatic = 0.0;
  double red_green = 0.0;
  double yellow_violet = 0.0;
};

/// castleCSF v0.2.4 (Ashraf, Mantiuk, Chapiro and Wuerger 2024, Journal of Vision 24(4):5); the
/// constants are from its program (MIT licence). Each sensitivity is 0 or more.
CastleSensitivity castle_sensitivity(const CsfStimulus& stimulus);

/// Sensitivity to one modulation: sqrt(3) over its length in cone contrasts at threshold. lms_step:
/// the modulation's cone responses, of any length but 0; lms_background: those of the background,
/// above 0, of any scale.
double castle_sensitivity(const CsfStimulus& stimulus, const DVec3& lms_step,
                          const DVec3& lms_background);

}  // namespace foveola
