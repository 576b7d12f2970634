// Renders stored as films (see film_file.h): whole ones, to continue, and parts, which merge-images
// merges.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "renderer/image/image_file.h"
#include "renderer/progressive/headless_render.h"

namespace foveola {

/// The properties common to all parts of a render.
struct RenderIdentity {
  ImageFacts facts;  ///< as in the whole image's header, except for the number of samples
  ImageFacts more;   ///< program, scene's file, size and number of samples, which identify it
  double exposure_stops = 0.0;  ///< exposure of its display
  ToneCurve curve = ToneCurve::plain;
};

/// A film file's text: its render, its part, and its progress.
struct FilmOrigin {
  RenderIdentity identity;
  std::optional<RenderPart> part;  ///< nullopt: the whole
  RenderProgress progress;         ///< without its pixels
};

/// Whether a file of this name is a film: a .film.
bool is_film(const std::filesystem::path& path);

/// The identity of a render with these settings. facts: of its image.
RenderIdentity identity_of(const RenderReport& report, const RenderSettings& settings,
                           ImageFacts facts, ToneCurve curve);

/// Writes a render's current state; the file appears whole or not at all, and replaces an earlier
/// one. Throws Error if it cannot be written.
void write_film(const std::filesystem::path& path, const FilmOrigin& origin);

/// The origin of the film at `path`, with its pixels. Throws Error if it cannot be read.
FilmOrigin read_film(const std::filesystem::path& path);

/// Throws Error unless the film at `path` is of the same render, and the same part of it.
void require_same_render(const std::filesystem::path& path, const FilmOrigin& film,
                         const RenderIdentity& identity, const std::optional<RenderPart>& part);

/// The result of merging a render's parts.
struct MergedRender {
  FilmImage image;
  RenderIdentity identity;
  std::uint64_t samples = 0;
  std::uint64_t non_finite = 0;
  std::size_t parts = 0;
};

/// Merges all parts of one render, each of which is complete. Pixels in several parts are summed
/// independently of the parts' order. Throws Error if one is missing, incomplete, of another render
/// or program, or damaged.
MergedRender merged(const std::vector<std::filesystem::path>& parts, const Workers& workers);

/// "3/16 by tiles".
std::string text_of(const RenderPart& part);

}  // namespace foveola
