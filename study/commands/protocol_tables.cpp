#include "study/commands/protocol_tables.h"

#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "study/commands/aligned_rows.h"
#include "study/commands/participant_code.h"

namespace foveola::study {
namespace {

std::string objects_of(const SceneSource& source) {
  std::vector<std::string> names;
  names.reserve(source.objects.size());
  for (const ObjectOfInterest& object : source.objects) {
    names.push_back(object.name);
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

/// " (NAME)" of a profile; empty if there is none.
template <typename Profile>
std::string in_brackets(const std::optional<Profile>& profile) {
  return profile ? fmt::format(" ({})", profile->name) : "";
}

std::string text_of(const TrackerSettings& tracker) {
  return fmt::format("{} Hz, {:.4g} ms, {} degrees of noise{}", tracker.simulated.rate_hz,
                     1e3 * tracker.simulated.latency_s, tracker.simulated.precision_deg,
                     in_brackets(tracker.profile));
}

std::string text_of(const ValidationSettings& validation) {
  return fmt::format("{} points{}, {} attempts: accuracy {} degrees, precision {} degrees, loss {}",
                     validation.points, validation.correct ? ", corrected" : "",
                     validation.attempts, validation.gate.max_accuracy_deg,
                     validation.gate.max_precision_deg, validation.gate.max_data_loss);
}

}  // namespace

std::string protocol_table(const Protocol& protocol, const std::vector<SceneSource>& sources) {
  std::vector<Row> rows = {
      {"protocol", protocol.name},
      {"title", protocol.title},
      {"sha256", protocol.sha256},
      {"methods", fmt::format("{} (baseline {})", fmt::join(protocol.methods, ", "),
                              protocol.methods.front())},
      {"trials", fmt::format("{} per participant", sources.size() * protocol.methods.size())},
      {"machine", fmt::format("{} samples per second at {} Hz", protocol.machine.samples_per_second,
                              protocol.machine.frame_rate_hz)},
      {"display",
       fmt::format("{} x {} pixels, {:.4g} x {:.4g} degrees{}", protocol.display.view_width,
                   protocol.display.view_height, protocol.display.horizontal_fov_deg,
                   protocol.display.vertical_fov_deg, in_brackets(protocol.display.profile))},
      {"tracker", text_of(protocol.tracker)},
      {"film", fmt::format("{} x {} pixels, {} surface vertices", protocol.film.width,
                           protocol.film.height, protocol.film.max_depth)},
      {"questions", fmt::format("{}", protocol.background.size())},
  };
  if (protocol.tracker.validation) {
    rows.push_back({"validation", text_of(*protocol.tracker.validation)});
  }
  for (const MethodFile& file : protocol.method_files) {
    rows.push_back({"file", fmt::format("{} of {}: {}", file.file, file.method, file.sha256)});
  }
  for (const SceneSource& source : sources) {
    rows.push_back({"scene", fmt::format("{}: {}", source.name, objects_of(source))});
  }
  return aligned(rows);
}

std::string plan_table(const std::vector<Plan>& plans) {
  std::vector<Row> rows = {{"participant", "position", "scene", "methods"}};
  for (std::size_t index = 0; index < plans.size(); ++index) {
    for (const PlannedTrial& trial : plans[index]) {
      if (trial.method_position == 0) {
        rows.push_back({participant_code(static_cast<int>(index)),
                        fmt::format("{}", trial.scene_position + 1), trial.scene, trial.method});
      } else {
        rows.back().back() += ", " + trial.method;
      }
    }
  }
  return aligned(rows);
}

}  // namespace foveola::study
