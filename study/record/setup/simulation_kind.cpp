#include "study/record/setup/simulation_kind.h"

#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/base/error.h"
#include "study/protocol/scaled_protocol.h"
#include "study/record/setup/shown_scene.h"
#include "study/record/sqlite/damage_remedy.h"

namespace foveola::study {
namespace {

/// Earlier versions called it "plant".
std::string injected_in(const nlohmann::json& simulation) {
  return simulation.at(simulation.contains("injected") ? "injected" : "plant").get<std::string>();
}

std::optional<double> speed_in(const nlohmann::json& simulation) {
  const auto found = simulation.find("samples_per_second");
  return found != simulation.end() ? std::optional(found->get<double>()) : std::nullopt;
}

}  // namespace

Protocol simulated_protocol(Protocol protocol, const SimulationKind& kind) {
  constexpr double slowest = 1.0;  // as a protocol's own machine
  constexpr double fastest = 1e12;
  if (kind.samples_per_second) {
    const double speed = *kind.samples_per_second;
    if (!(speed >= slowest && speed <= fastest)) {
      throw UsageError("--samples-per-second", "must be from 1 to 1e12");
    }
    protocol.machine.samples_per_second = speed;
  }
  return scaled_protocol(std::move(protocol), kind.scale);
}

std::string devices_of(const SimulationKind& kind) {
  nlohmann::json simulation = {{"scale", kind.scale},
                               {"predicted", kind.predicted},
                               {"real_time", kind.real_time},
                               {"injected", kind.injected},
                               {"people_sha256", kind.people_sha256}};
  if (kind.samples_per_second) {
    simulation["samples_per_second"] = *kind.samples_per_second;
  }
  return nlohmann::json{{"simulation", simulation}}.dump();
}

std::optional<SimulationKind> simulation_kind_in(const std::string& devices) {
  try {
    const nlohmann::json recorded = nlohmann::json::parse(devices);
    if (!recorded.contains("simulation")) {
      return std::nullopt;
    }
    const nlohmann::json& simulation = recorded.at("simulation");
    return SimulationKind{.scale = simulation.at("scale").get<double>(),
                          .samples_per_second = speed_in(simulation),
                          .predicted = simulation.at("predicted").get<bool>(),
                          .real_time = simulation.value("real_time", false),
                          .injected = injected_in(simulation),
                          .people_sha256 = simulation.at("people_sha256").get<std::string>()};
  } catch (const nlohmann::json::exception&) {
    throw Error("a simulated session", "does not say how it was simulated", damage_remedy);
  }
}

void require_same_kind(const std::string& database, const std::vector<KnownSession>& sessions,
                       const SimulationKind& kind) {
  const std::string now = devices_of(kind);
  for (const KnownSession& session : sessions) {
    if (session.kind != SessionKind::simulated) {
      continue;
    }
    const std::optional<SimulationKind> then = simulation_kind_in(session.devices);
    const std::string other = difference(then ? devices_of(*then) : session.devices, now);
    if (!other.empty()) {
      throw Error(database,
                  fmt::format("{} was simulated in another way ({})", session.participant, other),
                  "simulate all in one way, or begin a new database");
    }
  }
}

}  // namespace foveola::study
