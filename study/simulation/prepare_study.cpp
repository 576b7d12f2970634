#include "study/simulation/prepare_study.h"

#include <iterator>
#include <string>

#include "renderer/base/clock.h"
#include "renderer/base/error.h"
#include "renderer/base/work/work_scope.h"
#include "study/simulation/predicted_study.h"
#include "study/simulation/simulation_setup.h"

namespace foveola::study {
namespace {

PreparedItems prepare_references(const SceneStages& stages, const Protocol& protocol,
                                 const Shard& shard, const Workers& workers,
                                 const std::stop_token& stop) {
  const ItemRange part = part_of(shard, std::ssize(stages));
  PreparedItems prepared{.items = part.size(), .rendered = 0};
  Progress progress("Reference images");
  double done = 0.0;
  auto next = std::next(stages.begin(), part.begin);
  for (std::int64_t i = part.begin; i < part.end; ++i, ++next) {
    const std::string& scene = next->first;
    SceneStage& stage = *next->second;
    const FilmSettings film = settings_of(protocol, scene, protocol.methods.front()).film;
    if (!stage.has_reference(film, protocol.reference)) {
      const auto show = [&](double fraction) {
        progress.update((done + fraction) / static_cast<double>(part.size()), scene);
      };
      stage.render_reference(film, protocol.reference, workers, show, stop);
      ++prepared.rendered;
    }
    progress.update(++done / static_cast<double>(part.size()), scene);
  }
  return prepared;
}

PreparedItems prepare(const SimulateSettings& settings, const SimulationSetup& setup,
                      const Shard& shard, const std::stop_token& stop) {
  const Workers workers(settings.threads);
  const SceneStages stages =
      load_watched(stop, [&] { return load_stages(setup.protocol, setup.sources, workers); });
  print_scene_warnings(stages);
  if (!settings.predicted) {
    return prepare_references(stages, setup.protocol, shard, workers, stop);
  }
  SimulateSettings of_all = settings;
  of_all.shard.reset();
  of_all.database.clear();
  const SimulatedStudy study = study_of(of_all, setup, stages, workers);
  const Population& population = setup.people.population;
  const PicturesWanted wanted =
      pictures_wanted(study, population.vision, sessions_ahead(of_all, setup.protocol));
  return prepare_pilots(atlas_setting(study, population, wanted), shard, stop);
}

}  // namespace

PrepareReport prepare_study(const SimulateSettings& settings, const SceneFinderBeside& find_scene,
                            const std::stop_token& stop) {
  require_ways_to_simulate(settings);
  const SteadyClock clock;
  const Nanoseconds start = clock.now();
  const SimulationSetup setup = set_up_simulation(settings, find_scene);
  PrepareReport report{.simulates_viewing = setup.simulates_viewing()};
  try {
    if (report.simulates_viewing) {
      const PreparedItems prepared =
          prepare(settings, setup, settings.shard.value_or(Shard{}), stop);
      report.items = prepared.items;
      report.rendered = prepared.rendered;
    }
  } catch (const WorkStopped&) {
    report.stopped = true;
  } catch (const Error&) {
    if (!stop.stop_requested()) {
      throw;
    }
    report.stopped = true;
  }
  report.wall_s = seconds(clock.now() - start);
  return report;
}

}  // namespace foveola::study
