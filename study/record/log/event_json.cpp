#include "study/record/log/event_json.h"

#include <stdexcept>
#include <type_traits>
#include <variant>

#include <nlohmann/json.hpp>

#include "study/record/sqlite/stored_number.h"

namespace foveola::study {
namespace {

using Json = nlohmann::ordered_json;

// What a validation of the gaze found, as JSON that gives it back exactly.

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

std::string on_one_line(const Json& json) {
  constexpr int no_indent = -1;
  return json.dump(no_indent, ' ', false, Json::error_handler_t::replace);
}

Json json_of(const std::vector<Answer>& answers) {
  Json list = Json::array();
  for (const Answer& answer : answers) {
    const Json value = std::visit([](const auto& v) { return Json(v); }, answer.value);
    list.push_back({{"question", answer.question}, {"value", value}});
    if (answer.response) {
      list.back()["response_ns"] = answer.response->count();
    }
  }
  return list;
}

Nanoseconds nanoseconds_from(const Json& json) {
  return time_from(whole_number<std::int64_t>(json));
}

/// Throws std::invalid_argument for one that is not above zero.
Nanoseconds duration_from(const Json& json) {
  const Nanoseconds duration = nanoseconds_from(json);
  if (duration <= Nanoseconds(0)) {
    throw std::invalid_argument("a response time is not above zero");
  }
  return duration;
}

std::vector<Answer> answers_from(const Json& list) {
  std::vector<Answer> answers;
  for (const Json& json : list) {
    const Json& value = json.at("value");
    Answer answer{.question = json.at("question"), .value = {}};
    if (json.contains("response_ns")) {
      answer.response = duration_from(json.at("response_ns"));
    }
    if (value.is_string()) {
      answer.value = value.get<std::string>();
    } else {
      answer.value = value.get<double>();
    }
    answers.push_back(std::move(answer));
  }
  return answers;
}

// Each event's values as JSON, and back.

Json values_of(const ConsentGiven& event) {
  return event.text_sha256.empty()
             ? Json::object()
             : Json{{"text_sha256", event.text_sha256}, {"language", event.language}};
}
void read_values(const Json& json, ConsentGiven& event) {
  if (!json.empty()) {
    event.text_sha256 = json.at("text_sha256");
    event.language = json.at("language");
  }
}

Json values_of(const QuestionnaireAnswered& event) {
  return {{"questionnaire", event.questionnaire}, {"answers", json_of(event.answers)}};
}
void read_values(const Json& json, QuestionnaireAnswered& event) {
  event.questionnaire = json.at("questionnaire");
  event.answers = answers_from(json.at("answers"));
}

Json values_of(const GazeValidated& event) {
  Json runs = Json::array();
  for (const GazeRun& run : event.runs) {
    runs.push_back(json_of(run));
  }
  return {{"passed", event.passed}, {"runs", std::move(runs)}};
}
void read_values(const Json& json, GazeValidated& event) {
  event.passed = json.at("passed");
  const Json& runs = json.at("runs");
  for (const Json& run : runs) {
    event.runs.push_back(gaze_run_from(run));
  }
}

Json values_of(const ReactionPressed& event) {
  return {{"shown_ns", event.shown.count()}, {"time_ns", event.time.count()}};
}
void read_values(const Json& json, ReactionPressed& event) {
  event.shown = nanoseconds_from(json.at("shown_ns"));
  event.time = nanoseconds_from(json.at("time_ns"));
}

Json values_of(const ObjectChosen& event) { return {{"object", event.object}}; }
void read_values(const Json& json, ObjectChosen& event) { event.object = json.at("object"); }

Json values_of(const Rated& event) {
  Json values{{"answers", json_of(event.answers)}};
  if (event.looked_around) {
    values["looked_around_ns"] = event.looked_around->count();
  }
  return values;
}
void read_values(const Json& json, Rated& event) {
  event.answers = answers_from(json.at("answers"));
  if (json.contains("looked_around_ns")) {
    event.looked_around = duration_from(json.at("looked_around_ns"));
  }
}

Json values_of(const NoteWritten& event) { return {{"text", event.text}}; }
void read_values(const Json& json, NoteWritten& event) { event.text = json.at("text"); }

Json values_of(const Excluded& event) { return {{"reason", event.reason}}; }
void read_values(const Json& json, Excluded& event) { event.reason = json.at("reason"); }

template <typename TimedEvent>
  requires requires(TimedEvent event) { event.time; }
Json values_of(const TimedEvent& event) {
  return {{"time_ns", event.time.count()}};
}
template <typename TimedEvent>
  requires requires(TimedEvent event) { event.time; }
void read_values(const Json& json, TimedEvent& event) {
  event.time = nanoseconds_from(json.at("time_ns"));
}

template <typename BareEvent>
  requires std::is_empty_v<BareEvent>
Json values_of(const BareEvent& /*event*/) {
  return Json::object();
}
template <typename BareEvent>
  requires std::is_empty_v<BareEvent>
void read_values(const Json& /*json*/, BareEvent& /*event*/) {}

/// Tries the events from the one at `index` of the variant on.
template <std::size_t index = 0>
Event event_of_type(const std::string& type, const Json& values) {
  if constexpr (index < std::variant_size_v<Event>) {
    std::variant_alternative_t<index, Event> event;
    if (type != name_of(Event(event))) {
      return event_of_type<index + 1>(type, values);
    }
    read_values(values, event);
    return event;
  } else {
    throw std::invalid_argument("there is no event " + type);
  }
}

}  // namespace

std::string payload_of(const Event& event) {
  return on_one_line(std::visit([](const auto& e) { return values_of(e); }, event));
}

Event event_from(const std::string& type, const std::string& payload) {
  try {
    return event_of_type(type, Json::parse(payload));
  } catch (const Json::exception& fault) {
    throw std::invalid_argument(fault.what());
  }
}

}  // namespace foveola::study
