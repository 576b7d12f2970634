// A duration and how it is known, so that nobody takes an assumption for a measurement.
#pragma once

namespace foveola {

enum class Provenance {
  measured,  ///< measured on this device
  assumed    ///< from a data sheet, a publication or by guess
};

struct KnownDuration {
  double duration_s = 0.0;  ///< >= 0
  Provenance provenance = Provenance::assumed;
};

}  // namespace foveola
