// What the display shows of a film: one image, or frame after frame.
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

/// Pixels of a display's image where nobody asks for others.
inline constexpr IVec2 default_view_size{640, 640};

/// Resamples the film to a view of width x height pixels, trilinearly: a pixel of the display is
/// read from the levels of the film's pyramid whose cells are as high as it is. Film pixels are
/// weighted by whether they have samples, so an unsampled one neither darkens nor brightens its
/// neighbours. Right across the seam and over the poles, for sizes that both 32 and the levels used
/// divide; other sizes are off by less than a cell at the seam of the coarser levels. Linear
/// radiance.
RgbImage viewport_image(const EquirectFilm& film, const Viewport& viewport, int width, int height,
                        UnsampledPixels unsampled, const Workers& workers);

/// Resamples an image whose pixels are all known, such as a reference.
RgbImage viewport_image(const RgbImage& panorama, const Viewport& viewport, int width, int height);

struct ViewImage {
  int width = 0;  ///< pixels
  int height = 0;
  UnsampledPixels unsampled = UnsampledPixels::black;
  /// Encoded for a display after this exposure, as display_image does it. None: linear radiance.
  std::optional<double> exposure_stops;
  ToneCurve curve = ToneCurve::plain;  ///< after the exposure

  bool operator==(const ViewImage&) const = default;
};

/// Shows exactly what viewport_image shows, to the bit or rounded to 8 bits, and does not do again
/// what stays the same from frame to frame: where the view's pixels lie while the head is still,
/// their levels until the lens or the fields of view change, and then all but the pixels of the
/// view near new samples. Tiles out of sight are neither copied nor cleared until they come into
/// sight.
///
/// Every pixel is made anew while the head turns, after a clear or another look, where unsampled
/// pixels are filled, if a pixel of the view is larger than 16 pixels of the film, and for films
/// whose sides 32 does not divide.
///
/// Image: RgbImage, or ByteImage, which needs an exposure.
template <typename Image>
class FilmResampler {
 public:
  /// film must outlive this.
  FilmResampler(const EquirectFilm& film, const ViewImage& settings);

  /// What the image looks like from the next one on: the settings but for the size, which stays.
  void change_look(const ViewImage& settings);

  /// The film as it is now, seen through `viewport`. The image stays until the next call.
  const Image& show(const Viewport& viewport, const Workers& workers);

 private:
  /// Works out what depends on the viewport alone, but for the squares.
  void aim(const Viewport& viewport, const Workers& workers);
  bool has_same_lens(const Viewport& viewport) const;
  /// Works out what depends on the levels of pixels and on whether unsampled ones are filled.
  void note_levels();
  void find_squares(const Workers& workers);
  /// Makes the pixels [begin, end) anew: all of them, or those whose cells changed. `begin` is a
  /// multiple of eight.
  void paint_all(std::size_t begin, std::size_t end);
  void paint_changed(std::size_t begin, std::size_t end);
  void paint(std::span<const EightPixels> pixels, std::span<const ViewPoints> points);

  const EquirectFilm* film_;
  UnsampledPixels unsampled_ = UnsampledPixels::black;
  std::optional<float> exposure_;  ///< linear
  ToneCurve curve_ = ToneCurve::plain;
  bool has_new_look_ = true;  ///< no image was made with it yet
  FilmCopy copy_;
  ViewPixels pixels_;
  TilesInView tiles_in_view_;
  std::vector<std::uint32_t> tiles_;  ///< tiles that the view is made from
  bool reads_above_tiles_ = false;    ///< or from levels that have no tiles
  bool knows_changes_ = false;        ///< whether SquareChanges fits film and view
  std::vector<std::uint32_t>
      squares_;  ///< each pixel's square of SquareChanges; empty: not found yet
  std::optional<Viewport> viewport_;  ///< shown last
  FilmRevision shown_at_ = 0;
  Image image_;
};

extern template class FilmResampler<RgbImage>;
extern template class FilmResampler<ByteImage>;

/// What analyses and simulated participants see.
using ViewportResampler = FilmResampler<RgbImage>;
/// What a window shows.
using DisplayResampler = FilmResampler<ByteImage>;

}  // namespace foveola
