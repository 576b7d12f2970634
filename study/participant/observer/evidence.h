// Computes the evidence of one glance: the visibility of a task's signal.
//
// Rendered simulations compute PatchEnergies from presented pixels, predicted ones from tables. All
// later steps are shared.
#pragma once

#include <span>
#include <vector>

#include "renderer/base/vec.h"
#include "study/participant/observer/cells.h"
#include "study/participant/observer/visibility.h"
#include "study/participant/population.h"

namespace foveola::study {

/// The evidence of one glance for its task; the values of the other tasks are 0.
struct Evidence {
  double outline_signal_to_noise = 0.0;
  /// Visible root mean square difference of the object from the expected image.
  double material_jnd = 0.0;
  /// Visible root mean square difference from the expected image around the gaze.
  double artifacts_jnd = 0.0;
};

/// The signal and noise in a patch, independent of the eye's direction.
struct PatchEnergies {
  Vec3 direction{0.0F};  ///< Unit length, world.
  double cells = 0.0;    ///< Number of cells with pixels.
  /// The mean over the patch's blocks (cells, unless the study is scaled) of (presented -
  /// expected)^2 in each channel, in JND^2 at the gaze.
  ChannelValues noise{};
  /// For an outline: the mean over the patch's cells of the expected image's squared contrast, in
  /// JND^2. The contrast of a cell is twice the deviation of its achromatic value from the mean of
  /// all judged cells. In an image of two tones of equal area it is their difference, which is
  /// Rose's signal.
  double contrast = 0.0;
};

/// Returns the cells for an object's outline: half a line pair wide, with recognition_line_pairs
/// across the object (Johnson 1958), over surround_factor times its radius.
Cells outline_cells(const Vision& vision, const Vec3& object, double radius_deg);
/// Returns the widths of cells on all scales, from the finest, finest_cell_deg, on.
std::vector<double> scales_deg(const Vision& vision, double finest_cell_deg);
/// Returns the cells for an object's material: within its radius, a set for each scale from
/// material_cell_deg on.
std::vector<Cells> material_cells(const Vision& vision, const Vec3& object, double radius_deg);
/// Returns cells within radius_deg of a place in the view, extended to whole blocks.
Cells cells_around(const Vision& vision, const Vec3& place, double radius_deg, double cell_deg);
/// Returns the cells for artifacts in a glance: within looked_at_deg of the gaze, a set for each
/// scale from view_cell_deg on.
std::vector<Cells> glance_cells(const Vision& vision, const Vec3& gaze);

/// The expected means of cells: twice of the same image if it is known, else of two images with
/// independent noise. Squared differences are products of the differences to either, whose
/// expectation has no noise of theirs, and which may be negative where there is hardly any
/// difference.
struct ExpectedMeans {
  const std::vector<ChannelValues>& first;
  const std::vector<ChannelValues>& second;
};

/// Returns the patches' signal and noise from the means of the same cells in two images. A patch's
/// means weight cells by their pixels. The noise of a cell falls with its pixels, so that this is
/// the noise of a solid angle, whether pixels are small or nearly as large as cells. Patches
/// without pixels are left out. `with_contrast`: whether to compute the contrast.
std::vector<PatchEnergies> patch_energies(const Cells& cells, const CellPixels& pixels,
                                          const std::vector<ChannelValues>& presented,
                                          const ExpectedMeans& expected, bool with_contrast);

/// The signal is the visible contrast, the noise the visible difference from the expected image and
/// the eye's own noise. With T the threshold at a patch's eccentricity, C its contrast, N its
/// achromatic noise and n its cells:
///
///   SNR^2 = sum n C / T^2 / sum n (N / T^2 + 1 / rose^2)
///
/// so that without noise a contrast of one just noticeable difference has a signal-to-noise ratio
/// of `rose`: the eye's equivalent noise follows from its threshold (Pelli 1990, "The quantum
/// efficiency of vision"). `rose` is the ratio needed for detection, 5 (Rose 1948). 0 without
/// patches.
double outline_signal_to_noise(std::span<const PatchEnergies> patches, const Visibility& visibility,
                               const Vec3& gaze, double rose);

/// The visible difference of all channels together in JND: with T_c a channel's threshold at a
/// patch's eccentricity, N_c its noise and w = n / T_achromatic^2 (cells are weighted by how well
/// they are seen),
///
///   sqrt(sum w sum_c N_c / T_c^2 / sum w)
///
/// Infinite without patches: an object that is not in view cannot be judged finished.
double visible_difference_jnd(std::span<const PatchEnergies> patches, const Visibility& visibility,
                              const Vec3& gaze);

/// Returns the difference noticed on all scales together, by probability summation (Quick 1974):
/// the root of the sum of powers with vision's pooling_exponent.
double pooled_jnd(const Vision& vision, std::span<const double> jnd_of_scales);

}  // namespace foveola::study
