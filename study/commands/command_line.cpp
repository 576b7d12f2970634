#include "study/commands/command_line.h"

namespace foveola::study {

CLI::App* add_command(CLI::App& study, const std::string& name, const std::string& purpose,
                      const std::string& example) {
  CLI::App* command = study.add_subcommand(name, purpose);
  command->footer("Example: foveola study " + example);
  return command;
}

void add_protocol(CLI::App* command, std::string& protocol) {
  command
      ->add_option("PROTOCOL", protocol, "A .toml file, or the name of one that comes with Foveola")
      ->required();
}

void add_database(CLI::App* command, std::string& database) {
  command->add_option("DB", database, "The study's file")->required();
}

void add_participants_and_seed(CLI::App* command, int& participants, std::uint64_t& seed) {
  command->add_option("--participants", participants, "How many take part")
      ->check(CLI::Range(1, most_participants))
      ->required();
  command->add_option("--seed", seed, "Another seed gives other orders and people")
      ->capture_default_str();
}

void add_threads(CLI::App* command, int& threads) {
  constexpr int most_threads = 1024;
  command->add_option("--threads", threads, "0: every core")
      ->check(CLI::Range(0, most_threads))
      ->capture_default_str();
}

void add_json(CLI::App* command, bool& json) {
  command->add_flag("--json", json, "Print the result as JSON");
}

}  // namespace foveola::study
