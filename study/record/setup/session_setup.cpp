#include "study/record/setup/session_setup.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "renderer/base/build_info.h"
#include "study/record/log/json_member.h"
#include "study/record/setup/session_devices.h"
#include "study/record/sqlite/database.h"
#include "study/record/write/session_rows.h"

namespace foveola::study {
namespace {

using Json = nlohmann::ordered_json;

struct SetupFact {
  const char* name;
  const char* place;  ///< in the devices' JSON
  SetupPart part = SetupPart::other;
  double tolerance = 0.0;  ///< as a part of the larger number
};

constexpr double rate_tolerance = 0.05;
constexpr double speed_tolerance = 0.5;
constexpr double angle_tolerance = 0.001;

constexpr std::array setup_facts{
    SetupFact{"display profile", "/display/profile", SetupPart::display},
    SetupFact{"pixels", "/display/framebuffer", SetupPart::display},
    SetupFact{"horizontal degrees", "/display/horizontal_fov_deg", SetupPart::display,
              angle_tolerance},
    SetupFact{"vertical degrees", "/display/vertical_fov_deg", SetupPart::display, angle_tolerance},
    SetupFact{"display size in mm", "/display/size_mm", SetupPart::display},
    SetupFact{"viewing distance in mm", "/display/distance_mm", SetupPart::display},
    SetupFact{"full screen", "/preflight/full_screen"},
    SetupFact{"frame rate in Hz", "/display/refresh_rate_hz", SetupPart::other, rate_tolerance},
    SetupFact{"frame rate measured", "/display/refresh_is_measured", SetupPart::refreshes},
    SetupFact{"graphics", "/display/graphics", SetupPart::machine},
    SetupFact{"processor", "/machine/processor", SetupPart::machine},
    SetupFact{"threads", "/machine/threads", SetupPart::machine},
    SetupFact{"instruction set", "/renderer/instruction_set", SetupPart::machine},
    SetupFact{"ray instructions", "/renderer/ray_instructions", SetupPart::machine},
    SetupFact{"samples a second", "/speed", SetupPart::speed, speed_tolerance},
    SetupFact{"program", "/machine/program", SetupPart::program},
    SetupFact{"commit", "/machine/commit"},
    SetupFact{"film", "/preflight/film_px"},
    SetupFact{"tracker", "/tracker/profile"},
    SetupFact{"gaze filter", "/tracker/filter"},
    SetupFact{"source of key times", "/keys/time_source"},
};

/// The geometric mean over scenes and methods; null if none was measured.
Json mean_speed_in(const Json& devices) {
  double sum = 0.0;
  int count = 0;
  for (const Json& speed : member_or_null(member_or_null(devices, "preflight"), "speeds")) {
    if (const Json samples = member_or_null(speed, "samples_per_second");
        samples.is_number() && samples.get<double>() > 0.0) {
      sum += std::log(samples.get<double>());
      ++count;
    }
  }
  return count > 0 ? Json(std::exp(sum / count)) : Json();
}

/// One value for each fact; null where the devices say nothing. No filter is one, too.
std::vector<Json> values_in(const std::string& devices) {
  Json json = parse_json(devices);
  if (!json.is_object()) {
    return std::vector<Json>(setup_facts.size());
  }
  json["speed"] = mean_speed_in(json);
  if (json.contains("tracker") && json["tracker"].is_object() &&
      !json["tracker"].contains("filter")) {
    json["tracker"]["filter"] = "none";
  }
  std::vector<Json> values;
  for (const SetupFact& fact : setup_facts) {
    const Json::json_pointer place(fact.place);
    values.push_back(json.contains(place) ? json.at(place) : Json());
  }
  return values;
}

bool is_same(const Json& a, const Json& b, double tolerance) {
  if (!a.is_number() || !b.is_number()) {
    return a == b;
  }
  const auto x = a.get<double>();
  const auto y = b.get<double>();
  return std::abs(x - y) <= tolerance * std::max(std::abs(x), std::abs(y));
}

std::string in_words(const Json& value) {
  if (value.is_number()) {
    return fmt::format("{:.6g}", value.get<double>());
  }
  if (value.is_boolean()) {
    return value.get<bool>() ? "yes" : "no";
  }
  if (value.is_array()) {
    std::vector<std::string> parts;
    for (const Json& part : value) {
      parts.push_back(in_words(part));
    }
    return fmt::format("{}", fmt::join(parts, " x "));
  }
  return value.is_string() ? value.get<std::string>() : value.dump();
}

/// Adds the processor and program of the session's row: the devices of older versions have neither.
std::string add_machine_facts(const std::string& devices, const std::string& processor,
                              const BuildInfo& build) {
  Json json = parse_json(devices);
  if (!json.is_object() || json.contains("machine")) {
    return devices;
  }
  json["machine"] = {{"processor", processor}, {"program", program_name(build)}};
  return json.dump();
}

/// A value of a fact that was found, and who had it.
struct FoundValue {
  Json value;
  std::vector<std::string> participants;
};

}  // namespace

std::vector<SetupDifference> setup_differences(const std::string& before, const std::string& now) {
  const std::vector<Json> was = values_in(before);
  const std::vector<Json> is = values_in(now);
  std::vector<SetupDifference> differences;
  for (std::size_t i = 0; i < setup_facts.size(); ++i) {
    if (!was[i].is_null() && !is[i].is_null() &&
        !is_same(was[i], is[i], setup_facts[i].tolerance)) {
      differences.push_back(
          {setup_facts[i].name, setup_facts[i].part, in_words(was[i]), in_words(is[i])});
    }
  }
  return differences;
}

std::vector<SessionSetup> session_setups(SQLite::Database& study) {
  std::vector<SessionSetup> sessions;
  std::map<std::int64_t, std::size_t> indices;
  SQLite::Statement rows(study, "SELECT * FROM session ORDER BY id");
  while (rows.executeStep()) {
    indices.emplace(rows.getColumn("id").getInt64(), sessions.size());
    sessions.push_back(
        {.participant = rows.getColumn("participant").getString(),
         .kind = rows.getColumn("kind").getString(),
         .devices = {add_machine_facts(rows.getColumn("devices").getString(),
                                       rows.getColumn("processor").getString(), build_of(rows))}});
  }
  SQLite::Statement notes(study, "SELECT session, text FROM note ORDER BY session, sequence");
  while (notes.executeStep()) {
    if (std::optional<std::string> devices = devices_in_note(notes.getColumn("text").getString())) {
      sessions[indices.at(notes.getColumn("session").getInt64())].devices.push_back(
          std::move(*devices));
    }
  }
  return sessions;
}

std::vector<SessionSetup> read_session_setups(const std::filesystem::path& path) {
  std::vector<SessionSetup> sessions;
  with_clear_errors(path, [&] {
    SQLite::Database study = open_study_to_read(path);
    sessions = session_setups(study);
  });
  return sessions;
}

std::vector<SetupSummary> summarize_setups(const std::vector<SessionSetup>& sessions) {
  std::array<std::vector<FoundValue>, setup_facts.size()> found;
  for (const SessionSetup& session : sessions) {
    for (const std::string& devices : session.devices) {
      const std::vector<Json> values = values_in(devices);
      for (std::size_t i = 0; i < setup_facts.size(); ++i) {
        if (values[i].is_null() || setup_facts[i].part == SetupPart::program) {
          continue;
        }
        auto known = std::ranges::find_if(found[i], [&](const FoundValue& value) {
          return is_same(value.value, values[i], setup_facts[i].tolerance);
        });
        if (known == found[i].end()) {
          known = found[i].insert(known, FoundValue{values[i], {}});
        }
        if (known->participants.empty() || known->participants.back() != session.participant) {
          known->participants.push_back(session.participant);
        }
      }
    }
  }
  std::vector<SetupSummary> summaries;
  for (std::size_t i = 0; i < setup_facts.size(); ++i) {
    const bool varies = found[i].size() > 1;
    std::vector<std::string> values;
    for (const FoundValue& value : found[i]) {
      values.push_back(in_words(value.value) +
                       (varies ? fmt::format(" in {}", fmt::join(value.participants, ", ")) : ""));
    }
    if (!values.empty()) {
      summaries.push_back({.name = setup_facts[i].name,
                           .part = setup_facts[i].part,
                           .varies = varies,
                           .words = fmt::format("{}", fmt::join(values, "; "))});
    }
  }
  return summaries;
}

std::vector<std::string> varying_setup(const std::vector<SessionSetup>& sessions) {
  std::vector<std::string> lines;
  for (const SetupSummary& summary : summarize_setups(sessions)) {
    if (summary.varies) {
      lines.push_back(fmt::format("{}: {}", summary.name, summary.words));
    }
  }
  return lines;
}

}  // namespace foveola::study
