#include "study/commands/commands.h"

namespace foveola::study {

void add_study_commands(CLI::App& app, const SceneFinderBeside& find_scene,
                        const SimulationReporter& reporter, std::stop_token stop) {
  CLI::App* study = app.add_subcommand("study", "Plan, run and inspect user studies");
  study->require_subcommand(1);
  add_check(*study, find_scene);
  add_plan(*study);
  add_keys(*study);
  add_run(*study, find_scene, stop);
  add_watch(*study, stop);
  add_simulate(*study, find_scene, reporter, stop);
  add_replay(*study, find_scene, stop);
  add_status(*study);
  add_summary(*study);
  add_gaze(*study);
  add_verify(*study);
  add_backup(*study);
  add_restore(*study);
  add_merge(*study);
  add_forget(*study);
}

}  // namespace foveola::study
