#include "study/record/gaze_json.h"

#include "study/record/stored_number.h"

namespace foveola::study {
namespace {

using Json = nlohmann::ordered_json;

template <typename Vector>
Json json_of_vector(const Vector& v) {
  return Json::array({v.x, v.y, v.z});
}

template <typename Vector>
Vector vector_from(const Json& json) {
  using Number = typename Vector::value_type;
  return {finite_number<Number>(json.at(0)), finite_number<Number>(json.at(1)),
          finite_number<Number>(json.at(2))};
}

Json json_of(const GazeFigures& figures) {
  return {{"accuracy_deg", figures.accuracy_deg},
          {"precision_rms_deg", figures.precision_rms_deg},
          {"precision_sd_deg", figures.precision_sd_deg}};
}

GazeFigures figures_from(const Json& json) {
  return {.accuracy_deg = json.at("accuracy_deg"),
          .precision_rms_deg = json.at("precision_rms_deg"),
          .precision_sd_deg = json.at("precision_sd_deg")};
}

Json json_of(const SeenTarget& seen) {
  return {{"mean_gaze", json_of_vector(seen.mean_gaze)},
          {"samples", seen.samples},
          {"figures", json_of(seen.figures)}};
}

SeenTarget seen_target_from(const Json& json) {
  return {.mean_gaze = vector_from<Vec3>(json.at("mean_gaze")),
          .samples = whole_number<std::size_t>(json.at("samples")),
          .figures = figures_from(json.at("figures"))};
}

Json json_of(const TargetQuality& target) {
  return {{"direction", json_of_vector(target.direction)},
          {"data_loss", target.data_loss},
          {"seen", target.seen ? json_of(*target.seen) : Json()}};
}

TargetQuality target_from(const Json& json) {
  TargetQuality target{.direction = vector_from<Vec3>(json.at("direction")),
                       .data_loss = json.at("data_loss")};
  if (const Json& seen = json.at("seen"); !seen.is_null()) {
    target.seen = seen_target_from(seen);
  }
  return target;
}

}  // namespace

Json json_of(const GazeCorrection& correction) {
  return {{"azimuth", json_of_vector(correction.azimuth)},
          {"elevation", json_of_vector(correction.elevation)}};
}

GazeCorrection gaze_correction_from(const Json& json) {
  return {.azimuth = vector_from<DVec3>(json.at("azimuth")),
          .elevation = vector_from<DVec3>(json.at("elevation"))};
}

Json json_of(const GazeRun& run) {
  Json targets = Json::array();
  for (const TargetQuality& target : run.quality.targets) {
    targets.push_back(json_of(target));
  }
  return {{"targets", std::move(targets)},
          {"data_loss", run.quality.data_loss},
          {"figures", run.quality.figures ? json_of(*run.quality.figures) : Json()},
          {"correction", run.correction ? json_of(*run.correction) : Json()},
          {"passed", run.passed}};
}

GazeRun gaze_run_from(const Json& json) {
  GazeRun run;
  const Json& targets = json.at("targets");
  for (const Json& target : targets) {
    run.quality.targets.push_back(target_from(target));
  }
  run.quality.data_loss = json.at("data_loss");
  if (const Json& figures = json.at("figures"); !figures.is_null()) {
    run.quality.figures = figures_from(figures);
  }
  if (const Json& correction = json.at("correction"); !correction.is_null()) {
    run.correction = gaze_correction_from(correction);
  }
  run.passed = json.at("passed");
  return run;
}

}  // namespace foveola::study
