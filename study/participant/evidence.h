// One look, in numbers: how well what a task is about can be seen.
//
// This is where the two speeds of simulation meet: full simulation makes PatchEnergies of presented
// pixels, the predicted one of tables; whatever follows from them is the same.
#pragma once

#include <span>
#include <vector>

#include "renderer/base/vec.h"
#include "study/participant/cells.h"
#include "study/participant/population.h"
#include "study/participant/visibility.h"

namespace foveola::study {

/// What one look tells of what its task asks for; the others are 0.
struct Evidence {
  double outline_signal_to_noise = 0.0;
  double material_jnd = 0.0;   ///< visible root mean square difference from what is expected
  double artifacts_jnd = 0.0;  ///< likewise, over the whole view
};

/// What there is to see in a patch, wherever the eye looks.
struct PatchEnergies {
  Vec3 direction{0.0F};  ///< unit length, world
  double cells = 0.0;    ///< how many count, those without pixels not
  /// The mean over its blocks (cells, unless the study is scaled) of (presented - expected)^2 in
  /// each channel, JND^2 (of the gaze).
  ChannelValues noise{};
  /// Of an outline: the mean over its cells of the expected picture's contrast squared, JND^2. The
  /// contrast of a cell is twice the deviation of its achromatic value from the mean of all cells
  /// that are judged: in a picture of two tones, halves, that is their difference, which is what
  /// Rose's signal is.
  double contrast = 0.0;
};

/// An object's outline is judged on cells of half a line pair where recognition_line_pairs go
/// across the object (Johnson 1958), over surround_factor times its radius.
Cells outline_cells(const Vision& vision, const Vec3& object, double radius_deg);
/// The widths of cells on all scales, the finest, finest_cell_deg, first.
std::vector<double> scales_deg(const Vision& vision, double finest_cell_deg);
/// An object's material: cells within its radius, a set for each scale from material_cell_deg on.
std::vector<Cells> material_cells(const Vision& vision, const Vec3& object, double radius_deg);
/// Everything around: a set of cells for each scale from view_cell_deg on, patches of
/// view_patch_deg.
std::vector<Cells> view_cells(const Vision& vision);

/// presented, expected: means of the same cells. In a patch's means cells count by their pixels:
/// the noise of a cell falls with its pixels, so that this is the noise of a solid angle, whether
/// pixels are small or nearly as large as cells. Patches of which no cell has pixels are left out.
/// with_contrast: whether to work it out.
std::vector<PatchEnergies> patch_energies(const Cells& cells, const CellPixels& pixels,
                                          const std::vector<ChannelValues>& presented,
                                          const std::vector<ChannelValues>& expected,
                                          bool with_contrast);

/// The signal is the visible contrast, the noise the visible difference from what is expected and
/// the eye's own. With T the threshold at a patch's eccentricity, C its contrast, N its achromatic
/// noise and n its cells:
///
///   SNR^2 = sum n C / T^2 / sum n (N / T^2 + 1 / rose^2)
///
/// so that without noise a contrast of one just noticeable difference has just a signal-to-noise
/// ratio of `rose`: what is equivalent to the eye's own noise follows from its threshold (Pelli
/// 1990, "The quantum efficiency of vision"). rose: what tells, 5 (Rose 1948). 0 without patches.
double outline_signal_to_noise(std::span<const PatchEnergies> patches, const Visibility& visibility,
                               const Vec3& gaze, double rose);

/// The visible difference in just noticeable ones, of all channels together: with T_c a channel's
/// threshold at a patch's eccentricity, N_c its noise and w = n / T_achromatic^2 (cells are relied
/// on by how well they are seen),
///
///   sqrt(sum w sum_c N_c / T_c^2 / sum w)
///
/// Infinite without patches: what is not in view is not as it will look.
double visible_difference_jnd(std::span<const PatchEnergies> patches, const Visibility& visibility,
                              const Vec3& gaze);

/// What is noticed on all scales together, by probability summation as Quick (1974) puts it: the
/// root of the sum of powers, the exponent being vision's pooling_exponent.
double pooled_jnd(const Vision& vision, std::span<const double> jnd_of_scales);

}  // namespace foveola::study
