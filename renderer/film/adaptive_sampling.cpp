#include "renderer/film/adaptive_sampling.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "renderer/base/angles.h"
#include "renderer/base/numbers/random.h"
#include "renderer/view/acuity.h"
#include "renderer/view/equirect.h"

namespace foveola {
namespace {

/// Number of samples that one task redirects.
constexpr std::size_t sample_block = 1024;

/// Noise of a pixel as estimated from its eight neighbours. Rows beyond a pole are left out.
struct Neighbourhood {
  double variance = 0.0;  ///< variance of a sample's luminance, averaged over the neighbours
  double luminance = 0.0;
};

/// nullopt while a neighbour has too few samples.
std::optional<Neighbourhood> look_around(const EquirectFilm& film, const IVec2& pixel,
                                         std::uint32_t least_samples) {
  Neighbourhood sum;
  int count = 0;
  for (int y = std::max(pixel.y - 1, 0); y <= std::min(pixel.y + 1, film.height() - 1); ++y) {
    for (int dx = -1; dx <= 1; ++dx) {
      if (dx == 0 && y == pixel.y) {
        continue;
      }
      const int x = (pixel.x + dx + film.width()) % film.width();
      const FilmPixel neighbour = film.pixel(x, y);
      const std::optional<double> variance = film.luminance_variance(x, y);
      if (neighbour.samples < least_samples || !variance) {
        return std::nullopt;
      }
      sum.variance += *variance;
      sum.luminance += luminance(neighbour.mean);
      ++count;
    }
  }
  return Neighbourhood{sum.variance / count, sum.luminance / count};
}

/// Decides which pixels are converged, in one frame.
class Judge {
 public:
  Judge(const EquirectFilm& film, const Vec3& gaze, const VisibleNoise& noise)
      : film_(film),
        gaze_(gaze),
        noise_(noise),
        darkest_(noise.darkest * std::exp2(-noise.exposure_stops)) {}

  bool is_done(const IVec2& pixel) const {
    const std::uint32_t samples = film_.sample_count(pixel.x, pixel.y);
    if (samples < noise_.least_samples) {
      return false;
    }
    const std::optional<Neighbourhood> around = look_around(film_, pixel, noise_.least_samples);
    if (!around) {
      return false;
    }
    const double standard_error = std::sqrt(around->variance / samples);
    return standard_error < visible_contrast(pixel) * std::max(around->luminance, darkest_);
  }

 private:
  double visible_contrast(const IVec2& pixel) const {
    const Vec2 image((static_cast<float>(pixel.x) + 0.5F) / static_cast<float>(film_.width()),
                     (static_cast<float>(pixel.y) + 0.5F) / static_cast<float>(film_.height()));
    const double eccentricity_rad = angle_between(direction_from_equirect(image), gaze_);
    return noise_.contrast / reddy_acuity(degrees(eccentricity_rad));
  }

  const EquirectFilm& film_;
  Vec3 gaze_;
  VisibleNoise noise_;
  double darkest_;  ///< luminance on the film
};

/// `sample` shifted by `offset` pixels. Beyond a pole it continues on the pole's other side, so
/// that samples stay spread over their pixels.
ViewSample moved(const EquirectFilm& film, const ViewSample& sample, const IVec2& offset) {
  const Vec2 size(film.width(), film.height());
  Vec2 image = sample.image + Vec2(offset) / size;
  if (image.y < 0.0F || image.y > 1.0F) {
    image.y = image.y < 0.0F ? -image.y : 2.0F - image.y;
    image.x += 0.5F;
  }
  image.x -= std::floor(image.x);
  // Rounding can reach the image's end; films of fewer than 16 rows, both poles.
  image = glm::clamp(image, Vec2(0.0F), Vec2(largest_below_one));
  return {.direction = direction_from_equirect(image), .image = image};
}

/// Tries pixels in growing squares around the sample's own. Returns false if all are converged.
bool find_work(const Judge& judge, const EquirectFilm& film, std::uint32_t random,
               ViewSample& sample) {
  if (!judge.is_done(film.pixel_at(sample.image))) {
    return true;
  }
  for (const int reach : {1, 2, 4, 8, 16}) {
    random = mix(random);
    const auto side = static_cast<std::uint32_t>(2 * reach + 1);
    const IVec2 offset(static_cast<int>(random % side) - reach,
                       static_cast<int>(random / side % side) - reach);
    const ViewSample candidate = moved(film, sample, offset);
    if (!judge.is_done(film.pixel_at(candidate.image))) {
      sample = candidate;
      return true;
    }
  }
  return false;
}

}  // namespace

void redirect_samples(const EquirectFilm& film, const Vec3& gaze, const VisibleNoise& noise,
                      std::uint32_t seed, std::vector<ViewSample>& samples,
                      const Workers& workers) {
  const Judge judge(film, gaze, noise);
  std::vector<char> has_work(samples.size());
  workers.for_each_block(samples.size(), sample_block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint32_t random = mix(seed, static_cast<std::uint32_t>(i));
      has_work[i] = find_work(judge, film, random, samples[i]) ? 1 : 0;
    }
  });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (has_work[i] != 0) {
      samples[kept++] = samples[i];
    }
  }
  samples.resize(kept);
}

}  // namespace foveola
