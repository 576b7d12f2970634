// Draws what the display shows of a film on the graphics card.
#pragma once

#include <optional>
#include <vector>

#include "renderer/view/viewport.h"
#include "renderer/window/film_texture.h"
#include "renderer/window/gl_objects.h"

namespace foveola {

/// Densities over a view, row by row from its top left, 0 the least and 1 the most.
struct DensityMap {
  int width = 0;
  int height = 0;
  std::vector<float> values;
};

/// A ring that offers what is in it.
struct OfferRing {
  Vec3 direction{0.0F, 0.0F, -1.0F};  ///< direction of its middle; unit length, world
  float radius_rad = 0.0F;
  bool is_highlighted = false;  ///< the one that is chosen by now
};

/// What is drawn over the film, each on demand.
struct ViewOverlays {
  Vec3 gaze{0.0F, 0.0F, -1.0F};  ///< unit length, world
  bool shows_gaze = false;       ///< whether the gaze is drawn, as a point
  std::vector<float> rings_rad;  ///< eccentricities of rings around it; at most most_rings
  std::optional<DensityMap> density;
  std::optional<Vec3> target;     ///< a point to look at instead of the film; unit length, world
  std::vector<OfferRing> offers;  ///< at most most_offers; of overlapping ones the last is on top

  static constexpr std::size_t most_rings = 8;
  static constexpr std::size_t most_offers = 32;
};

/// How the film is shown.
struct ViewLook {
  double exposure_stops = 0.0;
  bool fill_unsampled = false;  ///< UnsampledPixels::filled
};

/// A part of the window, in pixels from its bottom left.
struct WindowPart {
  IVec2 origin{0};
  IVec2 size{0};
};

/// Shows the film as viewport_image and display_image do, but for the rounding of 16-bit texels.
/// Needs a current context in all that it does.
class ViewRenderer {
 public:
  ViewRenderer();
  void draw(const FilmTexture& film, const Viewport& viewport, const WindowPart& part,
            const ViewLook& look, const ViewOverlays& overlays);

 private:
  void set_film(const FilmTexture& film, const ViewLook& look);
  void set_view(const Viewport& viewport, const WindowPart& part);
  void set_overlays(const ViewOverlays& overlays);
  void set_offers(const std::vector<OfferRing>& offers);
  GLint uniform(const char* name) const { return glGetUniformLocation(program_.name(), name); }

  GlProgram program_;
  GlVertexArray no_vertices_;
  GlTexture density_;
};

}  // namespace foveola
