#include "renderer/commands/render/render_report.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>

#include "renderer/base/build_info.h"
#include "renderer/base/text/print.h"
#include "renderer/image/tone_mapping.h"

namespace foveola {
namespace {

constexpr double nearly_all = 0.98;
constexpr double mostly = 0.9;
/// Half of the first of 255 steps of the sRGB transfer function.
constexpr float black = 0.5F / 255.0F / 12.92F;

struct Shares {
  double black = 0.0;
  double white = 0.0;
};

Shares shares_of(const FilmImage& image, float scale) {
  std::size_t sampled = 0;
  std::size_t blacks = 0;
  std::size_t whites = 0;
  for (std::size_t i = 0; i < image.color.pixels.size(); ++i) {
    if (image.samples.empty() || image.samples[i] > 0) {
      const Rgb shown = scale * image.color.pixels[i];
      ++sampled;
      blacks += max_component(shown) < black ? 1 : 0;
      whites += glm::all(glm::greaterThanEqual(shown, Rgb(1.0F))) ? 1 : 0;
    }
  }
  if (sampled == 0) {
    return {};
  }
  const auto all = static_cast<double>(sampled);
  return {.black = static_cast<double>(blacks) / all, .white = static_cast<double>(whites) / all};
}

int percent(double share) { return static_cast<int>(100.0 * share); }

nlohmann::json json_angles(const AzimuthElevation& angles) {
  return {degrees(angles.azimuth_rad), degrees(angles.elevation_rad)};
}

nlohmann::json json_non_finite(const std::vector<DroppedSample>& dropped, int width) {
  constexpr std::size_t listed = 100;
  nlohmann::json list = nlohmann::json::array();
  for (std::size_t i = 0; i < std::min(dropped.size(), listed); ++i) {
    list.push_back({{"x", dropped[i].pixel % static_cast<unsigned>(width)},
                    {"y", dropped[i].pixel / static_cast<unsigned>(width)},
                    {"sample", dropped[i].sample_number}});
  }
  return list;
}

nlohmann::json json_vector(const Vec3& v) { return {v.x, v.y, v.z}; }

/// 0: no adaptive sampling.
double adaptive_contrast(const RenderSettings& settings) {
  return settings.progressive.adaptive ? settings.progressive.adaptive->contrast : 0.0;
}

const char* projection(const RenderSettings& settings) {
  return settings.picture ? "perspective" : panorama_projection;
}

/// The method of sampling.
std::string method(const RenderSettings& settings) {
  return settings.picture ? "picture" : settings.method;
}

double samples_per_pixel(const RenderReport& report) {
  return static_cast<double>(report.samples) / (static_cast<double>(report.size.x) * report.size.y);
}

/// The options that identify the part, if its paths differ from the whole render's.
std::string part_options(const RenderSettings& settings) {
  return settings.part && settings.part->by == RenderPart::By::seeds
             ? fmt::format("--shard {} --split seeds ", text_of(settings.part->shard))
             : "";
}

/// Maximum useful number of parts by tiles: with more, each takes longer to draw directions than to
/// trace. nullopt for other renders, or without measurements.
std::optional<double> parts_worth_it(const RenderReport& report, const RenderSettings& settings) {
  if (!settings.part || settings.part->by != RenderPart::By::tiles ||
      !(report.draw_seconds > 0.0 && report.trace_seconds > 0.0)) {
    return std::nullopt;
  }
  return report.trace_seconds * static_cast<double>(settings.part->shard.count) /
         report.draw_seconds;
}

std::string text_of(const Vec3& v) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", v.x, v.y, v.z);
}

std::string text_of(const AzimuthElevation& angles) {
  return fmt::format("{:.9g},{:.9g}", degrees(angles.azimuth_rad), degrees(angles.elevation_rad));
}

}  // namespace

nlohmann::json json_report(const RenderReport& report, const RenderSettings& settings,
                           const RenderNames& names) {
  const nlohmann::json clamp = std::isfinite(settings.progressive.trace.largest_radiance)
                                   ? nlohmann::json(settings.progressive.trace.largest_radiance)
                                   : nlohmann::json(nullptr);
  return {{"scene", names.scene},
          {"output", names.output},
          {"clamp", clamp},
          {"adaptive_contrast", adaptive_contrast(settings)},
          {"projection", projection(settings)},
          {"method", method(settings)},
          {"width", report.size.x},
          {"height", report.size.y},
          {"seed", settings.progressive.trace.seed},
          {"max_depth", settings.progressive.trace.max_depth},
          {"threads", report.threads},
          {"triangles", report.triangles},
          {"camera", {report.camera.x, report.camera.y, report.camera.z}},
          {"head_deg", json_angles(report.head)},
          {"gaze_deg", json_angles(report.gaze)},
          {"roll_deg", degrees(report.roll_rad)},
          {"fov_deg", {report.field_of_view.horizontal_deg, report.field_of_view.vertical_deg}},
          {"exposure_stops", report.exposure.stops},
          {"exposure_is_automatic", report.exposure.is_automatic},
          {"samples", report.samples},
          {"seconds", report.seconds},
          {"trace_seconds", report.trace_seconds},
          {"draw_seconds", report.draw_seconds},
          {"shard", settings.part ? nlohmann::json(text_of(settings.part->shard)) : nullptr},
          {"samples_per_pixel", samples_per_pixel(report)},
          {"samples_per_second", static_cast<double>(report.samples) / report.seconds},
          {"rays", report.rays},
          {"non_finite", report.non_finite.size()},
          {"non_finite_samples", json_non_finite(report.non_finite, report.size.x)},
          {"peak_memory_bytes", peak_memory_bytes()},
          {"load_seconds", report.load_seconds},
          {"build_seconds", report.build_seconds},
          {"stopped", report.stopped},
          {"warnings", report.warnings}};
}

void print_report(const RenderReport& report, const RenderSettings& settings,
                  const RenderNames& names) {
  print_warnings(report.warnings);
  if (report.exposure.is_automatic) {
    print_notes({exposure_note(report.exposure)});
  }
  if (!report.non_finite.empty()) {
    const DroppedSample& first = report.non_finite.front();
    const auto width = static_cast<unsigned>(report.size.x);
    print_text(
        stderr,
        "foveola: warning: {} samples were not finite and were dropped; --seed {} {}--replay "
        "{},{},{} traces the first of them again, --json lists more\n",
        report.non_finite.size(), settings.progressive.trace.seed, part_options(settings),
        first.pixel % width, first.pixel / width, first.sample_number);
  }
  if (const std::optional<double> most = parts_worth_it(report, settings)) {
    print_text(
        stderr,
        "foveola: note: every part draws all directions, which took {:.2g} s of {:.2g} s "
        "here: above about {:.0f} parts that takes longer than tracing; --split seeds has no "
        "such limit\n",
        report.draw_seconds, report.draw_seconds + report.trace_seconds, *most);
  }
  print_text(
      "{}: {} of {}x{}, {} samples in {:.2f} s ({:.0f} per second, {:.1f} rays each){}, {:.3g} "
      "samples per pixel\n",
      names.output, settings.picture ? "picture" : "360-degree image", report.size.x, report.size.y,
      report.samples, report.seconds, static_cast<double>(report.samples) / report.seconds,
      static_cast<double>(report.rays) / static_cast<double>(report.samples),
      report.stopped ? ", stopped early" : "", samples_per_pixel(report));
}

nlohmann::json json_path(const ReplayedPath& path) {
  nlohmann::json vertices = nlohmann::json::array();
  for (std::size_t i = 0; i < path.record.vertices.size(); ++i) {
    const PathVertex& vertex = path.record.vertices[i];
    nlohmann::json json = {{"vertex", vertex.number},
                           {"direction", json_vector(vertex.direction)},
                           {"throughput", json_vector(vertex.throughput)},
                           {"radiance", json_vector(vertex.radiance)},
                           {"pdf", vertex.pdf}};
    if (vertex.object) {
      json["object"] = path.object_names[i];
      json["distance_m"] = vertex.distance_m;
      json["position"] = json_vector(vertex.position);
      json["normal"] = json_vector(vertex.normal);
    }
    vertices.push_back(json);
  }
  return {{"direction", json_vector(path.job.direction)},
          {"pixel", path.job.pixel},
          {"sample", path.job.sample_number},
          {"radiance", json_vector(path.record.radiance)},
          {"vertices", vertices}};
}

void print_path(const ReplayedPath& path) {
  for (std::size_t i = 0; i < path.record.vertices.size(); ++i) {
    const PathVertex& vertex = path.record.vertices[i];
    print_text("{:2}  along {}: ", vertex.number, text_of(vertex.direction));
    if (vertex.object) {
      print_text("'{}' after {:.6g} m at {}, normal {}", path.object_names[i], vertex.distance_m,
                 text_of(vertex.position), text_of(vertex.normal));
    } else {
      print_text("out of the scene");
    }
    print_text("\n    throughput {}, radiance {}, pdf {:.6g}\n", text_of(vertex.throughput),
               text_of(vertex.radiance), vertex.pdf);
  }
  print_text("radiance {}\n", text_of(path.record.radiance));
}

ImageFacts facts_of(const RenderReport& report, const RenderSettings& settings,
                    const std::string& scene) {
  ImageFacts facts{
      {"foveola:version", build_info().version},
      {"foveola:instruction_set", build_info().instruction_set},
      {"foveola:scene", scene},
      {projection_fact, projection(settings)},
      {"foveola:method", method(settings)},
      {"foveola:seed", std::to_string(settings.progressive.trace.seed)},
      {"foveola:samples", std::to_string(report.samples)},
      {"foveola:max_depth", std::to_string(settings.progressive.trace.max_depth)},
      {"foveola:camera_m",
       fmt::format("{:.9g},{:.9g},{:.9g}", report.camera.x, report.camera.y, report.camera.z)},
      {"foveola:head_deg", text_of(report.head)},
      {"foveola:gaze_deg", text_of(report.gaze)},
      {"foveola:fov_deg", fmt::format("{:.9g}x{:.9g}", report.field_of_view.horizontal_deg,
                                      report.field_of_view.vertical_deg)}};
  if (report.roll_rad != 0.0) {
    facts["foveola:roll_deg"] = fmt::format("{:.9g}", degrees(report.roll_rad));
  }
  if (std::isfinite(settings.progressive.trace.largest_radiance)) {
    facts["foveola:clamp"] = fmt::format("{:.9g}", settings.progressive.trace.largest_radiance);
  }
  if (settings.scene.diffuse) {
    facts["foveola:materials"] = "diffuse";
  }
  if (settings.progressive.adaptive) {
    facts["foveola:adaptive_contrast"] = fmt::format("{:.9g}", adaptive_contrast(settings));
  }
  return facts;
}

std::vector<std::string> picture_faults(const FilmImage& image, double exposure_stops,
                                        bool is_enclosed) {
  const Shares shares = shares_of(image, exposure_scale(exposure_stops));
  if (shares.black >= nearly_all) {
    return {fmt::format(
        "{} % of the picture is black: --exposure auto or a higher number brightens it, {}, and "
        "--camera looks from elsewhere",
        percent(shares.black),
        is_enclosed ? "the scene, which is closed around the camera, needs lights within"
                    : "--environment 1,1,1 lights the scene evenly")};
  }
  if (shares.white >= mostly) {
    return {fmt::format(
        "{} % of the picture is white: --exposure auto or a lower number darkens it; if the file's "
        "lights are in lux and candela, --light-units photometric brings them to watts",
        percent(shares.white))};
  }
  return {};
}

}  // namespace foveola
