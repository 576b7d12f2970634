#include <algorithm>
#include <memory>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/base/text/print.h"
#include "study/commands/command_line.h"
#include "study/commands/commands.h"
#include "study/design/participant_code.h"
#include "study/design/plan.h"
#include "study/person/forms/missing_letters.h"
#include "study/protocol/cautions.h"
#include "study/protocol/protocol.h"
#include "study/protocol/reference/protocol_reference.h"
#include "study/protocol/reference/protocol_schema.h"
#include "study/tables/protocol_json.h"
#include "study/tables/protocol_tables.h"

namespace foveola::study {
namespace {

struct ProtocolArguments {
  std::string protocol;
  int participants = 0;
  std::uint64_t seed = 0;
  bool json = false;
};

std::vector<Plan> plans_of(const Protocol& protocol, int participants, std::uint64_t seed) {
  std::vector<Plan> plans;
  plans.reserve(static_cast<std::size_t>(participants));
  for (int row = 0; row < participants; ++row) {
    plans.push_back(make_plan(protocol, seed, row));
  }
  return plans;
}

/// Returns the planned number, else one per row of the design; 0 if neither is known. Fewer if
/// their trials would not fit in memory.
int expected_participants(const Protocol& protocol) {
  constexpr int max_trials = 2'000'000;
  const auto trials = static_cast<int>(protocol.scenes.size() * protocol.methods.size());
  return std::min(protocol.analysis.participants.value_or(design_rows(protocol)),
                  max_trials / trials);
}

std::string balance_heading(const Protocol& protocol, int participants) {
  const bool draws =
      protocol.scene_order == Order::random || protocol.method_order == Order::random;
  return fmt::format("balance of {} participants{}", participants,
                     draws ? ", an example: orders are drawn (seed 0)" : "");
}

void print_check(const Protocol& protocol, const std::vector<SceneSource>& scenes) {
  print_text("{}\n{}", protocol_table(protocol, scenes), duration_table(session_parts(protocol)));
  if (const int participants = expected_participants(protocol); participants > 0) {
    const Balance balance = balance_of(protocol, plans_of(protocol, participants, 0));
    print_text("\n{}\n{}", balance_heading(protocol, participants),
               balance_table(protocol, balance));
  }
}

nlohmann::json json_check(const Protocol& protocol) {
  nlohmann::json json = json_of(protocol);
  json["session"] = json_of(session_parts(protocol));
  if (const int participants = expected_participants(protocol); participants > 0) {
    json["balance"] = json_of(protocol, balance_of(protocol, plans_of(protocol, participants, 0)));
    json["balance"]["participants"] = participants;
  }
  return json;
}

void run_check(const ProtocolArguments& arguments, const SceneFinderBeside& find_scene) {
  const Protocol protocol = load_protocol(find_protocol(arguments.protocol));
  warn_of_missing_letters(protocol);
  const std::vector<SceneSource> scenes = find_scenes(protocol, find_scene);
  print_notes(protocol.notes);
  print_warnings(cautions(protocol, scenes));
  if (arguments.json) {
    print_text("{}\n", json_check(protocol).dump(2));
  } else {
    print_check(protocol, scenes);
  }
}

nlohmann::json json_plans(const Protocol& protocol, const std::vector<Plan>& plans) {
  nlohmann::json list = nlohmann::json::array();
  for (std::size_t i = 0; i < plans.size(); ++i) {
    list.push_back(
        {{"participant", participant_code(static_cast<int>(i))}, {"trials", json_of(plans[i])}});
  }
  return {{"plans", list}, {"balance", json_of(protocol, balance_of(protocol, plans))}};
}

void run_plan(const ProtocolArguments& arguments) {
  const Protocol protocol = load_protocol(find_protocol(arguments.protocol));
  const std::vector<Plan> plans = plans_of(protocol, arguments.participants, arguments.seed);
  if (arguments.json) {
    print_text("{}\n", json_plans(protocol, plans).dump(2));
  } else {
    print_text("{}\n{}", plan_table(plans), balance_table(protocol, balance_of(protocol, plans)));
  }
}

}  // namespace

void add_check(CLI::App& study, const SceneFinderBeside& find_scene) {
  const auto arguments = std::make_shared<ProtocolArguments>();
  CLI::App* command = add_command(study, "check",
                                  "Check a protocol: its contents, whether it is valid and can "
                                  "be analysed, how long a session takes",
                                  "check demo");
  add_protocol(command, arguments->protocol);
  add_json_option(*command, arguments->json);
  command->callback([arguments, find_scene] { run_check(*arguments, find_scene); });
}

void add_plan(CLI::App& study) {
  const auto arguments = std::make_shared<ProtocolArguments>();
  CLI::App* command = add_command(
      study, "plan", "Print the order of trials of each participant, and the balance of the orders",
      "plan demo --participants 16 --seed 7");
  add_protocol(command, arguments->protocol);
  add_participants_and_seed(command, arguments->participants, arguments->seed);
  add_json_option(*command, arguments->json);
  command->callback([arguments] { run_plan(*arguments); });
}

void add_keys(CLI::App& study) {
  const auto json = std::make_shared<bool>(false);
  const auto schema = std::make_shared<bool>(false);
  CLI::App* command = add_command(
      study, "keys",
      "Print every key that protocols, questionnaires' files and profiles may have: type, range, "
      "default and meaning, as Markdown",
      "keys > PROTOCOL.md");
  add_json_option(*command, *json);
  command->add_flag("--schema", *schema, "Print the JSON schema by which editors explain the keys")
      ->excludes("--json");
  command->callback([json, schema] {
    print_text("{}", *schema ? protocol_schema()
                     : *json ? protocol_reference_json().dump(2) + "\n"
                             : protocol_reference());
  });
}

}  // namespace foveola::study
