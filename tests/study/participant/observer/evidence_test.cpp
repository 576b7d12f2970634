#include "study/participant/observer/evidence.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "renderer/base/angles.h"
#include "renderer/base/numbers/random.h"

namespace foveola::study {
namespace {

constexpr Vision vision{.jnd_lab = 2.3,
                        .decay_deg = 0.106,
                        .half_resolution_deg = 2.3,
                        .chromatic_decay_factor = 3.0,
                        .red_green_decades_per_deg = 0.04,
                        .recognition_line_pairs = 4.0,
                        .surround_factor = 1.5,
                        .material_cell_deg = 0.5,
                        .view_cell_deg = 2.0,
                        .scale_count = 3.0,
                        .pooling_exponent = 4.0,
                        .object_patch_deg = 2.0,
                        .view_patch_deg = 10.0,
                        .looked_at_deg = 6.0};
const Vec3 ahead(0.0F, 0.0F, -1.0F);

Vec3 right_of_gaze(double angle_deg) {
  return direction_from({.azimuth_rad = radians(angle_deg), .elevation_rad = 0.0});
}

PatchEnergies patch(double eccentricity_deg, double cells, double noise, double contrast = 0.0) {
  return {.direction = right_of_gaze(eccentricity_deg),
          .cells = cells,
          .noise = {noise, 0.0, 0.0},
          .contrast = contrast};
}

TEST(JudgedCells, AreAnEighthOfTheObjectWideAndOverItsSurroundings) {
  const Cells cells = outline_cells(vision, ahead, 4.0);
  EXPECT_NEAR(cells.cell_deg(), 1.0, 1e-12);
  EXPECT_NE(cells.at(right_of_gaze(5.0)), Cells::none);
  EXPECT_EQ(cells.at(right_of_gaze(7.0)), Cells::none);
  EXPECT_EQ(material_cells(vision, ahead, 4.0).front().at(right_of_gaze(5.0)), Cells::none);
}

TEST(JudgedCells, OfAMaterialAndOfAGlanceAreOnScalesAnOctaveApart) {
  const std::vector<Cells> material = material_cells(vision, ahead, 4.0);
  const std::vector<Cells> glance = glance_cells(vision, ahead);
  ASSERT_EQ(material.size(), 3U);
  ASSERT_EQ(glance.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(material[i].cell_deg(), std::ldexp(0.5, static_cast<int>(i)), 1e-12);
    EXPECT_NEAR(glance[i].cell_deg(), std::ldexp(2.0, static_cast<int>(i)), 1e-12);
  }
}

TEST(JudgedCells, OfAGlanceAreAroundTheGaze) {
  const Cells cells = glance_cells(vision, right_of_gaze(30.0)).front();
  EXPECT_NE(cells.at(right_of_gaze(30.0 + vision.looked_at_deg - 2.0)), Cells::none);
  EXPECT_EQ(cells.at(right_of_gaze(30.0 + vision.looked_at_deg + 2.0)), Cells::none);
  EXPECT_EQ(cells.at(ahead), Cells::none);
}

// By hand: (1 + 16 + 81)^(1/4) = 3.14635.
TEST(PooledDifference, IsTheRootOfTheSumOfPowers) {
  EXPECT_NEAR(pooled_jnd(vision, std::vector{1.0, 2.0, 3.0}), 3.14635, 1e-5);
  EXPECT_NEAR(pooled_jnd(vision, std::vector{0.7}), 0.7, 1e-12);
  EXPECT_EQ(pooled_jnd(vision, std::vector{0.0, 0.0}), 0.0);
  EXPECT_EQ(pooled_jnd(vision, std::vector{1.0, std::numeric_limits<double>::infinity()}),
            std::numeric_limits<double>::infinity());
}

// The threshold of cells of 1 degree at the gaze is exp(0.106 / 2) of a large area's.
TEST(OutlineSignalToNoise, OfOneJndWithoutNoiseIsRosesCriterion) {
  const Visibility visibility(vision, 1.0);
  const double jnd_squared = std::exp(0.106);
  const std::vector<PatchEnergies> contour{patch(0.0, 10.0, 0.0, jnd_squared)};
  EXPECT_NEAR(outline_signal_to_noise(contour, visibility, ahead, 5.0), 5.0, 1e-6);
  const std::vector<PatchEnergies> faint{patch(0.0, 10.0, 0.0, 0.25 * jnd_squared)};

  EXPECT_NEAR(outline_signal_to_noise(faint, visibility, ahead, 5.0), 2.5, 1e-6);
}

// By hand, of two patches: the gaze's with 3 cells, where cells of 0.5 degrees have a threshold
// whose square is exp(0.212) = 1.23615, and one of 1 cell at 10 degrees, where it is 3.10725:
// signal 3 x 36 / 1.23615 + 9 / 3.10725 = 90.2646, noise 3 x (4 / 1.23615 + 0.04) + 16 / 3.10725 +
// 0.04 = 15.0168, the root of their ratio 2.4517.

TEST(OutlineSignalToNoise, IsTheFormulasValue) {
  const Visibility visibility(vision, 0.5);
  const std::vector<PatchEnergies> patches{patch(0.0, 3.0, 4.0, 36.0), patch(10.0, 1.0, 16.0, 9.0)};
  EXPECT_NEAR(outline_signal_to_noise(patches, visibility, ahead, 5.0), 2.4517, 2e-3);
}

TEST(OutlineSignalToNoise, FallsWithNoiseAndWithDistanceFromTheGaze) {
  const Visibility visibility(vision, 0.5);
  const auto at = [&](double eccentricity_deg, double noise) {
    const std::vector<PatchEnergies> patches{patch(eccentricity_deg, 1.0, noise, 16.0)};
    return outline_signal_to_noise(patches, visibility, ahead, 5.0);
  };
  EXPECT_GT(at(0.0, 1.0), at(0.0, 2.0));
  EXPECT_GT(at(0.0, 0.1), at(20.0, 0.1));
  EXPECT_EQ(outline_signal_to_noise({}, visibility, ahead, 5.0), 0.0) << "nothing to see";
}

// By hand: weights 3 / 1.23615 and 1 / 3.10725; differences 4 / 1.23615 = 3.23585 and 16 / 3.10725
// = 5.14925; their weighted mean is (7.85305 + 1.65717) / 2.74872 = 3.45988, its root 1.86008.

TEST(VisibleDifference, IsTheFormulasValue) {
  const Visibility visibility(vision, 0.5);
  const std::vector<PatchEnergies> patches{patch(0.0, 3.0, 4.0), patch(10.0, 1.0, 16.0)};
  EXPECT_NEAR(visible_difference_jnd(patches, visibility, ahead), 1.86008, 2e-3);
}

TEST(VisibleDifference, TakesAllChannelsTogether) {
  const Visibility visibility(vision, 0.5);
  const std::vector<PatchEnergies> patches{
      {.direction = ahead, .cells = 5.0, .noise = {4.0, 4.0, 1.0}}};
  const double chromatic = std::exp(-2.0 * 0.106 * 3.0);
  EXPECT_NEAR(visible_difference_jnd(patches, visibility, ahead),
              std::sqrt(4.0 * std::exp(-2.0 * 0.106) + (4.0 + 1.0) * chromatic), 1e-6);
}

TEST(VisibleDifference, OfWhatIsNotInViewIsInfinite) {
  EXPECT_EQ(visible_difference_jnd({}, Visibility(vision, 0.5), ahead),
            std::numeric_limits<double>::infinity());
}

/// A view of cells, each of which has pixels.
struct View {
  Cells cells = Cells::around(ahead, 6.0, 1.0, 2.0);
  CellPixels pixels;
  std::vector<ChannelValues> expected;

  View() : expected(cells.count()) { pixels.pixels_in_cell.assign(cells.count(), 1); }
};

TEST(PatchEnergies, AreMeanSquaresOfDifferences) {
  View view;
  std::vector<ChannelValues> presented = view.expected;
  for (std::size_t cell = 0; cell < presented.size(); ++cell) {
    presented[cell] = {cell % 2 == 0 ? 2.0 : -2.0, 3.0, 0.0};
  }
  double cells = 0.0;
  for (const PatchEnergies& energies :
       patch_energies(view.cells, view.pixels, presented, {view.expected, view.expected}, true)) {
    EXPECT_NEAR(energies.noise[0], 4.0, 1e-12);
    EXPECT_NEAR(energies.noise[1], 9.0, 1e-12);
    EXPECT_NEAR(energies.noise[2], 0.0, 1e-12);
    EXPECT_EQ(energies.contrast, 0.0) << "of a picture that is all the same";
    cells += energies.cells;
  }
  EXPECT_EQ(cells, static_cast<double>(view.cells.count()));
}

TEST(PatchEnergies, ContrastIsTheDifferenceOfTwoTones) {
  View view;
  ASSERT_EQ(view.cells.count() % 2, 0U);
  for (std::size_t cell = 0; cell < view.expected.size(); ++cell) {
    view.expected[cell][0] = cell % 2 == 0 ? 10.0 : 17.0;
  }
  for (const PatchEnergies& energies : patch_energies(view.cells, view.pixels, view.expected,
                                                      {view.expected, view.expected}, true)) {
    EXPECT_NEAR(energies.contrast, 49.0, 1e-9);
  }
}

/// The mean noise energy, over many images, of grey pixels with this noise, over `cells` ahead.
double noise_energy(const Cells& cells, int width, double deviation) {
  constexpr int pictures = 40;
  const Viewport viewport(head_orientation({}), radians(100.0), radians(100.0));
  const CellPixels pixels = pixels_of(cells, viewport, width, width);
  const std::vector<ChannelValues> grey(cells.count(), opponent_channels(Rgb(0.5F), 2.3));
  RgbImage image(width, width);
  Pcg32 random(5);
  double sum = 0.0;
  double total_cells = 0.0;
  for (int picture = 0; picture < pictures; ++picture) {
    for (const CellPixels::Member& member : pixels.members) {
      image.pixels[member.pixel] = Rgb(0.5F + static_cast<float>(deviation * random.normal()));
    }
    for (const PatchEnergies& patch :
         patch_energies(cells, pixels, cell_means(image, pixels, 2.3), {grey, grey}, false)) {
      sum += patch.cells * patch.noise[0];
      total_cells += patch.cells;
    }
  }
  return sum / total_cells;
}

// Four times the pixels, each with a quarter of the samples, have twice the noise; a cell has the
// same. 0.14 and 0.28 degrees are the pixels' widths at the middle.
TEST(PatchEnergies, NoiseIsThatOfASolidAngleAndNotOfThePixels) {
  const Cells cells = material_cells(vision, ahead, 6.0).front();
  const double of_many = noise_energy(cells, 800, 0.2);
  EXPECT_GT(of_many, 1.0);
  EXPECT_NEAR(noise_energy(cells, 400, 0.1) / of_many, 1.0, 0.03);
}

// A scaled study has fewer pixels of the same noise: four cells, or nine, have together there the
// noise that one cell has at full size.
TEST(PatchEnergies, NoiseOfAScaledStudyIsThatOfTheFullOne) {
  Vision wide = vision;  // so that there are many blocks
  wide.looked_at_deg = 40.0;
  for (const int factor : {2, 3}) {
    Vision scaled = wide;
    scaled.coarseness = factor;
    EXPECT_NEAR(noise_energy(material_cells(scaled, ahead, 6.0).front(), 900 / factor, 0.2) /
                    noise_energy(material_cells(vision, ahead, 6.0).front(), 900, 0.2),
                1.0, 0.06)
        << factor;
    EXPECT_NEAR(noise_energy(outline_cells(scaled, ahead, 6.0), 900 / factor, 0.2) /
                    noise_energy(outline_cells(vision, ahead, 6.0), 900, 0.2),
                1.0, 0.06)
        << factor;
    EXPECT_NEAR(noise_energy(glance_cells(scaled, ahead).front(), 300 / factor, 0.2) /
                    noise_energy(glance_cells(wide, ahead).front(), 300, 0.2),
                1.0, 0.06)
        << factor;
  }
}

TEST(PatchEnergies, ContrastOfAScaledStudyIsThatOfTheFullOne) {
  Vision scaled = vision;
  scaled.coarseness = 3.0;
  const auto contrast = [](const Cells& cells) {
    CellPixels pixels;
    pixels.pixels_in_cell.assign(cells.count(), 1);
    std::vector<ChannelValues> expected(cells.count());
    for (std::size_t cell = 0; cell < cells.count(); ++cell) {
      expected[cell][0] = cell % 2 == 0 ? 10.0 : 17.0;
    }
    double sum = 0.0;
    double total_cells = 0.0;
    for (const PatchEnergies& patch :
         patch_energies(cells, pixels, expected, {expected, expected}, true)) {
      sum += patch.cells * patch.contrast;
      total_cells += patch.cells;
    }
    return sum / total_cells;
  };
  EXPECT_NEAR(contrast(outline_cells(vision, ahead, 6.0)), 49.0, 1e-9);
  EXPECT_NEAR(contrast(outline_cells(scaled, ahead, 6.0)), 49.0, 1e-9);
}

TEST(PatchEnergies, CellsWithoutPixelsDoNotCount) {
  View view;
  std::vector<ChannelValues> presented = view.expected;
  for (std::uint32_t cell = 0; cell < view.cells.count(); ++cell) {
    if (view.cells.patch_of(cell) == 0) {
      view.pixels.pixels_in_cell[cell] = 0;
      presented[cell] = {1e6, 1e6, 1e6};
    }
  }
  const std::vector<PatchEnergies> energies =
      patch_energies(view.cells, view.pixels, presented, {view.expected, view.expected}, true);
  EXPECT_EQ(energies.size() + 1, view.cells.patches().size());
  for (const PatchEnergies& of_patch : energies) {
    EXPECT_EQ(of_patch.noise[0], 0.0);
  }
}

}  // namespace
}  // namespace foveola::study
