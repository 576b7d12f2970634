// Renders that are kept as films (see film_file.h): whole ones, to go on with, and parts, which
// merge-images puts together.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "renderer/image/image_file.h"
#include "renderer/progressive/headless_render.h"

namespace foveola {

/// What is the same in all parts of a render.
struct RenderIdentity {
  ImageFacts facts;  ///< as the header of the whole image has them, but for the number of samples
  ImageFacts more;   ///< program, scene's file, size and number of samples, by which it is known
  double exposure_stops = 0.0;  ///< how the image is to be shown
  ToneCurve curve = ToneCurve::plain;
};

/// A film file's text: which render it is of, which part, and how far that has come.
struct FilmOrigin {
  RenderIdentity identity;
  std::optional<RenderPart> part;  ///< empty: all of it
  RenderProgress progress;         ///< without its pixels
};

/// Whether a file of this name is a film: a .film.
bool is_film(const std::filesystem::path& path);

/// What a render with these settings is known by. facts: of its image.
RenderIdentity identity_of(const RenderReport& report, const RenderSettings& settings,
                           ImageFacts facts, ToneCurve curve);

/// Writes a render as it is; the file appears whole or not at all, and takes the place of an
/// earlier one. Throws Error if it cannot be written.
void write_film(const std::filesystem::path& path, const FilmOrigin& origin);

/// The origin of the film at `path`, with its pixels. Throws Error if it cannot be read.
FilmOrigin read_film(const std::filesystem::path& path);

/// Throws Error unless the film at `path` is of the same render, and the same part of it.
void require_same_render(const std::filesystem::path& path, const FilmOrigin& film,
                         const RenderIdentity& identity, const std::optional<RenderPart>& part);

/// What the parts of a render are together.
struct MergedRender {
  FilmImage image;
  RenderIdentity identity;
  std::uint64_t samples = 0;
  std::uint64_t non_finite = 0;
  std::size_t parts = 0;
};

/// Puts all parts of one render together, each of which is complete. Pixels that several parts have
/// are summed so that the parts' order does not matter. Throws Error if one is missing, not
/// complete, of another render or program, or damaged.
MergedRender merged(const std::vector<std::filesystem::path>& parts, const Workers& workers);

/// "3/16 by tiles".
std::string text_of(const RenderPart& part);

}  // namespace foveola
