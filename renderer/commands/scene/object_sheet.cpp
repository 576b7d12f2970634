#include "renderer/commands/scene/object_sheet.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

#include "renderer/base/error.h"
#include "renderer/base/vec.h"
#include "renderer/base/work/work_scope.h"
#include "renderer/image/tone_mapping.h"
#include "renderer/progressive/exposure.h"
#include "renderer/view/viewport.h"

namespace foveola {
namespace {

bool is_inside(const RgbImage& image, int x, int y) {
  return x >= 0 && y >= 0 && x < image.width && y < image.height;
}

/// Draws with Dear ImGui's built-in font: 13 pixels high, Latin letters.
class TextDrawing {
 public:
  TextDrawing() : font_(atlas_.AddFontDefault()) {
    unsigned char* pixels = nullptr;
    atlas_.GetTexDataAsAlpha8(&pixels, &size_.x, &size_.y);
    coverage_ = pixels;
  }

  /// Draws one line in white into `image`, from its top left corner `corner`, cut off after `width`
  /// pixels. text: UTF-8; letters missing in the font become question marks.
  void draw(const std::string& text, const IVec2& corner, int width, RgbImage& image) const;

 private:
  float coverage_at(int x, int y) const {
    return static_cast<float>(coverage_[static_cast<std::size_t>(y) * size_.x + x]) / 255.0F;
  }

  ImFontAtlas atlas_;
  const ImFont* font_;
  const unsigned char* coverage_ = nullptr;  ///< coverage of the atlas's pixels, from 0 to 255
  IVec2 size_{0};
};

void TextDrawing::draw(const std::string& text, const IVec2& corner, int width,
                       RgbImage& image) const {
  float advance = 0.0F;
  const char* const end = text.data() + text.size();
  for (const char* at = text.data(); at < end;) {
    unsigned int letter = 0;
    at += std::max(1, ImTextCharFromUtf8(&letter, at, end));
    const ImFontGlyph* const glyph = font_->FindGlyph(static_cast<ImWchar>(letter));
    if (glyph == nullptr || advance + glyph->AdvanceX > static_cast<float>(width)) {
      return;
    }
    const IVec2 from(std::lround(glyph->U0 * static_cast<float>(size_.x)),
                     std::lround(glyph->V0 * static_cast<float>(size_.y)));
    const IVec2 to(corner.x + std::lround(advance + glyph->X0), corner.y + std::lround(glyph->Y0));
    for (int y = 0; y < std::lround(glyph->Y1 - glyph->Y0); ++y) {
      for (int x = 0; x < std::lround(glyph->X1 - glyph->X0); ++x) {
        if (is_inside(image, to.x + x, to.y + y)) {
          Rgb& pixel = image.at(to.x + x, to.y + y);
          pixel = glm::mix(pixel, Rgb(1.0F), coverage_at(from.x + x, from.y + y));
        }
      }
    }
    advance += glyph->AdvanceX;
  }
}

constexpr int columns = 4;
constexpr int side_px = 192;
constexpr int gap_px = 8;
constexpr int label_px = 20;

Viewport view_of(const LoadedScene& loaded, const ObjectOfInterest& object) {
  const Vec3 towards = loaded.scene.from_file(DVec3(object.position)) - loaded.camera.position;
  const double fov_deg = std::clamp(4.0 * object.radius_deg, 4.0, 120.0);
  return {azimuth_elevation(towards), {.horizontal_deg = fov_deg, .vertical_deg = fov_deg}};
}

/// Upper bound of samples, relative to white: few samples leave bright specks otherwise.
constexpr float largest_white = 4.0F;

RgbImage picture_of(const LoadedScene& loaded, const Viewport& view, double exposure_stops,
                    const Workers& workers) {
  const SmallPictureSettings settings{
      .size = IVec2(side_px),
      .trace = {.largest_radiance = largest_white / exposure_scale(exposure_stops)}};
  const std::vector<DVec3> radiance =
      small_picture(loaded.tracer, loaded.camera.position, view, settings, workers);
  RgbImage picture(side_px, side_px);
  std::transform(radiance.begin(), radiance.end(), picture.pixels.begin(),
                 [](const DVec3& mean) { return Rgb(mean); });
  return picture;
}

void paste_exposed(const RgbImage& from, const IVec2& corner, double stops, RgbImage& to) {
  const float scale = exposure_scale(stops);
  for (int y = 0; y < from.height; ++y) {
    for (int x = 0; x < from.width; ++x) {
      to.at(corner.x + x, corner.y + y) = scale * from.at(x, y);
    }
  }
}

IVec2 corner_of(std::size_t object) {
  const IVec2 place(static_cast<int>(object) % columns, static_cast<int>(object) / columns);
  return {gap_px + place.x * (side_px + gap_px), gap_px + place.y * (side_px + label_px + gap_px)};
}

}  // namespace

RgbImage object_sheet(const LoadedScene& loaded, const SceneSource& source, double exposure_stops,
                      const Workers& workers, const std::stop_token& stop) {
  const std::size_t count = source.objects.size();
  const IVec2 last = corner_of(count - 1);
  const int right = count < columns ? last.x : corner_of(columns - 1).x;
  RgbImage sheet(right + side_px + gap_px, last.y + side_px + label_px + gap_px);
  const TextDrawing labels;
  Progress progress("drawing the objects");
  for (std::size_t i = 0; i < count; ++i) {
    const IVec2 corner = corner_of(i);
    const Viewport view = view_of(loaded, source.objects[i]);
    paste_exposed(picture_of(loaded, view, exposure_stops, workers), corner, exposure_stops, sheet);
    labels.draw(fmt::format("{}  {}", i + 1, source.objects[i].name),
                corner + IVec2(0, side_px + gap_px / 2), side_px, sheet);
    progress.update(static_cast<double>(i + 1) / static_cast<double>(count));
    if (stop.stop_requested()) {
      throw Error("scene describe", "was stopped before the objects were drawn");
    }
  }
  return sheet;
}

}  // namespace foveola
