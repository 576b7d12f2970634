#include "renderer/stability/checks.h"

namespace foveola {

std::vector<StabilityCheck> stability_checks(const std::vector<SceneSource>& scenes) {
  return {{"white furnaces", 40.0, check_white_furnaces},
          {"mixed layers", 15.0, check_mixed_layers},
          {"known answers", 5.0, check_known_answers},
          {"scale and place", 15.0, check_scale_and_place},
          {"light leaks", 20.0, check_leaks},
          {"degenerate input", 5.0, check_degenerate_input},
          {"accumulation", 2.0, check_accumulation},
          {"bit equality", 5.0, check_bit_equality},
          {"finite radiance", 10.0,
           [scenes](const StabilityRun& run) { return check_finite_radiance(run, scenes); }}};
}

std::vector<StabilityFigure> measure_stability(
    const std::vector<StabilityCheck>& checks, const StabilityEffort& effort,
    const Workers& workers, const std::function<void(double, const std::string&)>& progress,
    const std::stop_token& stop) {
  double total = 0.0;
  for (const StabilityCheck& check : checks) {
    total += check.weight;
  }
  std::vector<StabilityFigure> figures;
  double done = 0.0;
  for (const StabilityCheck& check : checks) {
    const StabilityRun run{
        .workers = workers, .effort = effort, .stop = stop, .progress = [&](double fraction) {
          progress((done + fraction * check.weight) / total, check.name);
        }};
    run.progress(0.0);
    std::vector<StabilityFigure> found = check.run(run);
    if (stop.stop_requested()) {
      break;
    }
    figures.insert(figures.end(), found.begin(), found.end());
    done += check.weight;
  }
  return figures;
}

}  // namespace foveola
