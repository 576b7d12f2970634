// Resamples a film to a display's view, once or frame by frame.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "renderer/base/work/parallel.h"
#include "renderer/film/equirect_film.h"
#include "renderer/film/film_copy.h"
#include "renderer/film/shown_color.h"
#include "renderer/film/view_pixels.h"
#include "renderer/image/image.h"
#include "renderer/image/tone_mapping.h"
#include "renderer/view/viewport.h"

namespace foveola {

/// Default size of a display's image, in pixels.
inline constexpr IVec2 default_view_size{640, 640};

/// Resamples the film to a view of width x height pixels, trilinearly: a display pixel is read from
/// the levels of the film's pyramid whose cells are as high as it. Unsampled film pixels have no
/// weight, so that they neither darken nor brighten their neighbours. Exact across the seam and the
/// poles for sizes that are divisible by 32 and the levels' cells; others are off by less than a
/// cell at the seam of the coarser levels. Linear radiance.
RgbImage viewport_image(const EquirectFilm& film, const Viewport& viewport, int width, int height,
                        UnsampledPixels unsampled, const Workers& workers);

/// Resamples a complete image, such as a reference.
RgbImage viewport_image(const RgbImage& panorama, const Viewport& viewport, int width, int height);

struct ViewImage {
  int width = 0;  ///< pixels
  int height = 0;
  UnsampledPixels unsampled = UnsampledPixels::black;
  /// Encodes for a display after this exposure, as display_image does. nullopt: linear radiance.
  std::optional<double> exposure_stops;
  ToneCurve curve = ToneCurve::plain;  ///< after the exposure

  bool operator==(const ViewImage&) const = default;
};

/// Gives the result of viewport_image, to the bit or rounded to 8 bits, and reuses work between
/// frames. Pixel positions are kept while the head is still, levels until the lens or the fields of
/// view change, and then all view pixels without new samples nearby. Tiles out of sight are copied
/// or cleared only once they come into sight.
///
/// All pixels are recomputed while the head turns, and after a clear or a changed look. So they are
/// where unsampled pixels are filled, if a view pixel is larger than 16 film pixels, and for films
/// whose sides are not divisible by 32.
///
/// Image: RgbImage, or ByteImage, which needs an exposure.
template <typename Image>
class FilmResampler {
 public:
  /// film must outlive this.
  FilmResampler(const EquirectFilm& film, const ViewImage& settings);

  /// Changes the settings of the next images, except their size.
  void change_look(const ViewImage& settings);

  /// The current film, seen through `viewport`. The image is valid until the next call.
  const Image& show(const Viewport& viewport, const Workers& workers);

 private:
  /// Computes all data that depends on the viewport alone, except the squares.
  void aim(const Viewport& viewport, const Workers& workers);
  bool has_same_lens(const Viewport& viewport) const;
  /// Computes all data that depends on the pixels' levels and on filling.
  void note_levels();
  void find_squares(const Workers& workers);
  /// Recomputes the pixels [begin, end): all, or those whose cells changed. `begin` is a multiple
  /// of eight.
  void paint_all(std::size_t begin, std::size_t end);
  void paint_changed(std::size_t begin, std::size_t end);
  void paint(std::span<const EightPixels> pixels, std::span<const ViewPoints> points);

  const EquirectFilm* film_;
  UnsampledPixels unsampled_ = UnsampledPixels::black;
  std::optional<float> exposure_;  ///< linear
  ToneCurve curve_ = ToneCurve::plain;
  bool has_new_look_ = true;  ///< no image has been made with it
  FilmCopy copy_;
  ViewPixels pixels_;
  TilesInView tiles_in_view_;
  std::vector<std::uint32_t> tiles_;  ///< tiles in the view
  bool reads_above_tiles_ = false;    ///< or in levels above tiles
  bool knows_changes_ = false;        ///< whether SquareChanges supports film and view
  std::vector<std::uint32_t>
      squares_;  ///< each pixel's square of SquareChanges; empty: not yet computed
  std::optional<Viewport> viewport_;  ///< the last viewport
  FilmRevision shown_at_ = 0;
  Image image_;
};

extern template class FilmResampler<RgbImage>;
extern template class FilmResampler<ByteImage>;

/// For analyses and simulated participants.
using ViewportResampler = FilmResampler<RgbImage>;
/// For windows.
using DisplayResampler = FilmResampler<ByteImage>;

}  // namespace foveola
