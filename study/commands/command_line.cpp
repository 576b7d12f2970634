#include "study/commands/command_line.h"

#include <fmt/format.h>

#include "renderer/base/files/files.h"
#include "renderer/base/text/print.h"
#include "study/protocol/protocol.h"
#include "study/record/maintain/maintenance.h"

namespace foveola::study {

CLI::App* add_command(CLI::App& parent, const std::string& name, const std::string& purpose,
                      const std::string& example) {
  CLI::App* command = parent.add_subcommand(name, purpose);
  command->footer("Example: foveola " + parent.get_name() + " " + example);
  return command;
}

void add_protocol(CLI::App* command, std::string& protocol) {
  command
      ->add_option("PROTOCOL", protocol,
                   "The protocol: a .toml file, or the name of one that comes with Foveola (demo, "
                   "koskela2018) or lies in ~/.local/share/foveola/protocols")
      ->required();
}

void add_database(CLI::App* command, std::string& database) {
  command->add_option("DB", database, "The study's database file")->required();
}

void add_participants_and_seed(CLI::App* command, int& participants, std::uint64_t& seed) {
  command->add_option("--participants", participants, "The number of participants")
      ->check(CLI::Range(1, most_participants))
      ->required();
  command->add_option("--seed", seed, "The seed of orders and simulated people");
}

void add_simulated_studies(CLI::App* command, SimulatedBenchArguments& arguments,
                           const std::string& folder_help) {
  add_protocol(command, arguments.protocol);
  command->add_option("-o,--output", arguments.folder, folder_help)->required();
  add_participants_and_seed(command, arguments.simulation.participants, arguments.simulation.seed);
}

void add_effort_and_json(CLI::App* command, SimulatedBenchArguments& arguments) {
  add_threads_option(*command, arguments.simulation.threads);
  command->add_option("--jobs", arguments.simulation.jobs, "As in study simulate")
      ->check(CLI::Range(1, max_jobs));
  add_json_option(*command, arguments.json);
}

SimulateReport simulate_study(const SimulatedBenchArguments& arguments,
                              const std::filesystem::path& database,
                              const SceneFinderBeside& find_scene, const std::stop_token& stop) {
  SimulateSettings settings = arguments.simulation;
  settings.protocol = find_protocol(arguments.protocol);
  settings.database = database;
  return simulate_study(settings, find_scene, stop);
}

void require_backup_target(const std::filesystem::path& folder,
                           const std::filesystem::path& study) {
  require_writable(new_backup_in(folder, study));
  if (is_on_disk_of(folder, study)) {
    print_warnings({fmt::format("{}: is on the same disk as {} and does not survive its loss",
                                folder.string(), study.string())});
  }
}

}  // namespace foveola::study
