#include "study/commands/protocol_commands.h"

#include <memory>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "study/commands/command_line.h"
#include "study/commands/participant_code.h"
#include "study/commands/protocol_tables.h"
#include "study/design/plan.h"
#include "study/protocol/protocol.h"

namespace foveola::study {
namespace {

struct Arguments {
  std::string protocol;
  int participants = 0;
  std::uint64_t seed = 0;
  bool json = false;
};

nlohmann::json json_profiles(const Protocol& protocol) {
  nlohmann::json names = nlohmann::json::object();
  for (const NamedProfile& profile : named_profiles(protocol)) {
    names[profile.device] = profile.name;
  }
  return names;
}

void run_check(const Arguments& arguments, const SceneFinder& find_scene) {
  const Protocol protocol = load_protocol(find_protocol(arguments.protocol));
  const std::vector<SceneSource> scenes = find_scenes(protocol, find_scene);
  if (arguments.json) {
    nlohmann::json names = nlohmann::json::array();
    for (const SceneEntry& scene : protocol.scenes) {
      names.push_back(scene.name);
    }
    nlohmann::json files = nlohmann::json::array();
    for (const MethodFile& file : protocol.method_files) {
      files.push_back({{"method", file.method}, {"file", file.file}, {"sha256", file.sha256}});
    }
    const nlohmann::json json = {
        {"protocol", protocol.path.string()},
        {"name", protocol.name},
        {"title", protocol.title},
        {"sha256", protocol.sha256},
        {"scenes", names},
        {"methods", protocol.methods},
        {"method_files", files},
        {"profiles", json_profiles(protocol)},
        {"trials_per_participant", scenes.size() * protocol.methods.size()},
        {"background_questions", protocol.background.size()}};
    fmt::print("{}\n", json.dump(2));
  } else {
    fmt::print("{}", protocol_table(protocol, scenes));
  }
}

nlohmann::json json_plan(int participant, const Plan& plan) {
  nlohmann::json trials = nlohmann::json::array();
  for (const PlannedTrial& trial : plan) {
    trials.push_back({{"scene", trial.scene}, {"method", trial.method}});
  }
  return {{"participant", participant_code(participant)}, {"trials", trials}};
}

void run_plan(const Arguments& arguments) {
  const Protocol protocol = load_protocol(find_protocol(arguments.protocol));
  std::vector<Plan> plans;
  for (int i = 0; i < arguments.participants; ++i) {
    plans.push_back(random_plan(protocol, arguments.seed, i));
  }
  if (arguments.json) {
    nlohmann::json list = nlohmann::json::array();
    for (int i = 0; i < arguments.participants; ++i) {
      list.push_back(json_plan(i, plans[i]));
    }
    fmt::print("{}\n", list.dump(2));
  } else {
    fmt::print("{}", plan_table(plans));
  }
}

}  // namespace

void add_check(CLI::App& study, const SceneFinder& find_scene) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command =
      add_command(study, "check", "Whether a protocol and its scenes are sound", "check demo");
  add_protocol(command, arguments->protocol);
  add_json(command, arguments->json);
  command->callback([arguments, find_scene] { run_check(*arguments, find_scene); });
}

void add_plan(CLI::App& study) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = add_command(study, "plan", "The order in which each participant sees things",
                                  "plan demo --participants 16 --seed 7");
  add_protocol(command, arguments->protocol);
  add_participants_and_seed(command, arguments->participants, arguments->seed);
  add_json(command, arguments->json);
  command->callback([arguments] { run_plan(*arguments); });
}

}  // namespace foveola::study
