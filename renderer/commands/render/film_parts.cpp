#include "renderer/commands/render/film_parts.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <queue>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/base/build_info.h"
#include "renderer/base/error.h"
#include "renderer/base/files/files.h"
#include "renderer/base/transformed.h"
#include "renderer/film/film_file.h"

namespace foveola {
namespace {

using Json = nlohmann::ordered_json;

/// Identifies the assignment of tiles (see shard_of_pixel): parts by another one do not fit.
constexpr const char* by_tiles = "tiles of 4 pixels";
constexpr const char* by_seeds = "seeds";
constexpr const char* filmic = "filmic";

/// Of a merged image: more than 5 GB of memory.
constexpr std::int64_t max_pixels = std::int64_t{1} << 28;

const char* name_of(RenderPart::By by) { return by == RenderPart::By::tiles ? by_tiles : by_seeds; }

Json json_of(const RenderIdentity& identity) {
  return {{"facts", identity.facts},
          {"more", identity.more},
          {"exposure_stops", identity.exposure_stops},
          {"tone", identity.curve == ToneCurve::filmic ? filmic : "plain"}};
}

Json json_of(const RenderProgress& progress) {
  const Json non_finite(transformed(progress.non_finite, [&](const DroppedSample& sample) {
    return Json{sample.pixel, sample.sample_number};
  }));
  return {{"points_drawn", progress.points_drawn}, {"points", progress.points},
          {"samples", progress.samples},           {"rays", progress.rays},
          {"seconds", progress.seconds},           {"non_finite", non_finite}};
}

std::string text_of(const FilmOrigin& origin) {
  Json json = {{"render", json_of(origin.identity)}, {"progress", json_of(origin.progress)}};
  if (origin.part) {
    json["part"] = {{"shard", text_of(origin.part->shard)}, {"by", name_of(origin.part->by)}};
  }
  return json.dump();
}

RenderProgress progress_in(const Json& json) {
  RenderProgress progress{.points_drawn = json.at("points_drawn").get<std::uint64_t>(),
                          .points = json.at("points").get<std::uint64_t>(),
                          .samples = json.at("samples").get<std::uint64_t>(),
                          .rays = json.at("rays").get<std::uint64_t>(),
                          .seconds = json.at("seconds").get<double>(),
                          .non_finite = {}};
  for (const Json& sample : json.at("non_finite")) {
    progress.non_finite.push_back({.pixel = sample.at(0).get<std::uint32_t>(),
                                   .sample_number = sample.at(1).get<std::uint32_t>()});
  }
  return progress;
}

RenderIdentity identity_in(const Json& json) {
  return {.facts = json.at("facts").get<ImageFacts>(),
          .more = json.at("more").get<ImageFacts>(),
          .exposure_stops = json.at("exposure_stops").get<double>(),
          .curve = json.at("tone") == filmic ? ToneCurve::filmic : ToneCurve::plain};
}

RenderPart::By split_named(const std::string& name) {
  for (const RenderPart::By by : {RenderPart::By::tiles, RenderPart::By::seeds}) {
    if (name == name_of(by)) {
      return by;
    }
  }
  throw Error(name, "is not a known split of a render");
}

FilmOrigin origin_of(const FilmFileReader& film) {
  try {
    const Json json = Json::parse(film.header().about);
    FilmOrigin origin{.identity = identity_in(json.at("render")),
                      .part = std::nullopt,
                      .progress = progress_in(json.at("progress"))};
    if (const auto part = json.find("part"); part != json.end()) {
      origin.part = {.shard = parse_shard("shard", part->at("shard").get<std::string>()),
                     .by = split_named(part->at("by").get<std::string>())};
    }
    return origin;
  } catch (const std::exception&) {
    throw Error(film.path().string(), "does not name its render",
                "name one that foveola render has written");
  }
}

/// The differences in words; empty if there are none.
std::string difference(const RenderIdentity& here, const RenderIdentity& there) {
  const auto first_in = [](const ImageFacts& a, const ImageFacts& b) -> std::string {
    for (const auto& [name, value] : a) {
      const auto found = b.find(name);
      if (found == b.end() || found->second != value) {
        return fmt::format("{} is {}, not {}", name, found == b.end() ? "absent" : found->second,
                           value);
      }
    }
    return a.size() == b.size() ? "" : "it has more facts";
  };
  std::string found = first_in(here.more, there.more);
  found = found.empty() ? first_in(here.facts, there.facts) : found;
  return found.empty() && json_of(here) != json_of(there) ? "its exposure or tone curve differs"
                                                          : found;
}

/// A film to merge, and its next pixel.
struct Source {
  std::unique_ptr<FilmFileReader> film;
  FilmOrigin origin;
  std::optional<PixelState> next;

  const std::filesystem::path& path() const { return film->path(); }
  Shard shard() const { return origin.part.value_or(RenderPart{}).shard; }
  RenderPart::By by() const { return origin.part.value_or(RenderPart{}).by; }
};

Source opened(const std::filesystem::path& path) {
  Source source{.film = std::make_unique<FilmFileReader>(path), .origin = {}, .next = {}};
  source.origin = origin_of(*source.film);
  return source;
}

/// Throws Error unless these are all parts of one render.
void require_whole(const std::vector<Source>& sources) {
  const Source& first = sources.front();
  for (const Source& source : sources) {
    const std::string where = source.path().string();
    if (const std::string other = difference(first.origin.identity, source.origin.identity);
        !other.empty() || source.film->header().size != first.film->header().size ||
        source.film->header().statistics != first.film->header().statistics) {
      throw Error(where,
                  fmt::format("is of another render than {}: {}", first.path().string(),
                              other.empty() ? "its film differs" : other),
                  "merge the parts of one render by one program");
    }
    if (source.shard().count != first.shard().count || source.by() != first.by()) {
      throw Error(
          where,
          fmt::format("is part {}, but {} is part {} of the same render", text_of(source.shard()),
                      first.path().string(), text_of(first.shard())),
          "merge parts of one split");
    }
    if (!source.origin.progress.is_complete()) {
      throw Error(where, "is not finished", "continue it: repeat its command with --resume");
    }
  }
  for (std::int64_t number = 1; number <= first.shard().count; ++number) {
    const auto count = std::ranges::count_if(
        sources, [&](const Source& source) { return source.shard().number == number; });
    if (count != 1) {
      throw Error("merge-images",
                  fmt::format("part {} is {}", text_of(Shard{number, first.shard().count}),
                              count == 0 ? "missing" : "given more than once"),
                  "name each part once");
    }
  }
}

/// Calls take(pixel) for each pixel of all sources, in ascending order.
void for_each_pixel(std::vector<Source>& sources,
                    const std::function<void(const PixelState& pixel)>& take) {
  const auto is_later = [&](std::size_t a, std::size_t b) {
    return sources[a].next->pixel > sources[b].next->pixel;
  };
  std::priority_queue<std::size_t, std::vector<std::size_t>, decltype(is_later)> waiting(is_later);
  const auto advance = [&](std::size_t source) {
    sources[source].next = sources[source].film->next();
    if (sources[source].next) {
      waiting.push(source);
    }
  };
  for (std::size_t source = 0; source < sources.size(); ++source) {
    advance(source);
  }
  PixelSum sum;
  while (!waiting.empty()) {
    const std::uint32_t pixel = sources[waiting.top()].next->pixel;
    while (!waiting.empty() && sources[waiting.top()].next->pixel == pixel) {
      const std::size_t source = waiting.top();
      waiting.pop();
      sum.add(*sources[source].next);
      advance(source);
    }
    take(sum.take());
  }
}

}  // namespace

bool is_film(const std::filesystem::path& path) { return lower_case_extension(path) == ".film"; }

std::string text_of(const RenderPart& part) {
  return fmt::format("{} by {}", text_of(part.shard), name_of(part.by));
}

RenderIdentity identity_of(const RenderReport& report, const RenderSettings& settings,
                           ImageFacts facts, ToneCurve curve) {
  facts.erase("foveola:samples");
  const RenderBudget& budget = settings.budget;
  return {.facts = std::move(facts),
          .more = {{"program", exact_name(build_info())},
                   {"scene_sha256", report.scene_sha256},
                   {"size", fmt::format("{}x{}", report.size.x, report.size.y)},
                   {"samples", budget.samples > 0
                                   ? fmt::format("{}", budget.samples)
                                   : fmt::format("{:.17g} per pixel", budget.samples_per_pixel)}},
          .exposure_stops = report.exposure.stops,
          .curve = curve};
}

void write_film(const std::filesystem::path& path, const FilmOrigin& origin) {
  write_film_file(path,
                  {.size = origin.progress.film_size,
                   .statistics = origin.progress.statistics,
                   .about = text_of(origin)},
                  origin.progress.pixels);
}

FilmOrigin read_film(const std::filesystem::path& path) {
  FilmFileReader film(path);
  FilmOrigin origin = origin_of(film);
  origin.progress.film_size = film.header().size;
  origin.progress.statistics = film.header().statistics;
  origin.progress.pixels = rest_of(film);
  return origin;
}

void require_same_render(const std::filesystem::path& path, const FilmOrigin& film,
                         const RenderIdentity& identity, const std::optional<RenderPart>& part) {
  const std::string there = film.part ? text_of(*film.part) : "all of it";
  const std::string here = part ? text_of(*part) : "all of it";
  const std::string other = there != here ? fmt::format("it is {}, not {}", there, here)
                                          : difference(identity, film.identity);
  if (!other.empty()) {
    throw Error(path.string(), "is of another render: " + other,
                "give the options that it was begun with, or name a new file");
  }
}

MergedRender merged(const std::vector<std::filesystem::path>& parts, const Workers& workers) {
  std::vector<Source> sources =
      transformed(parts, [&](const std::filesystem::path& path) { return opened(path); });
  require_whole(sources);
  const FilmHeader& header = sources.front().film->header();
  if (static_cast<std::int64_t>(header.size.x) * header.size.y > max_pixels) {
    throw Error(sources.front().path().string(),
                fmt::format("is an image of more than {} pixels, which one machine cannot hold",
                            max_pixels),
                "render a smaller one");
  }
  MergedRender result{
      .image = {}, .identity = sources.front().origin.identity, .parts = sources.size()};
  for (const Source& source : sources) {
    result.samples += source.origin.progress.samples;
    result.non_finite += source.origin.progress.non_finite.size();
  }
  std::vector<PixelState> pixels;
  for_each_pixel(sources, [&](const PixelState& pixel) { pixels.push_back(pixel); });
  EquirectFilm film(header.size.x, header.size.y, header.statistics);
  film.restore(pixels, workers);
  result.image = film.resolve();
  return result;
}

}  // namespace foveola
