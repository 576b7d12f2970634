#include "analysis/publication/injected_studies.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include <fmt/format.h>

#include "renderer/base/random.h"

namespace foveola::analysis {
namespace {

std::vector<int> random_order(std::size_t count, Pcg32& generator) {
  std::vector<int> order(count);
  std::iota(order.begin(), order.end(), 0);
  shuffle(std::span(order), generator);
  return order;
}

/// A participant's trials, one after the other.
class DrawnParticipant {
 public:
  DrawnParticipant(const InjectedEffects& effects, std::string code, Pcg32& generator)
      : effects_(effects), code_(std::move(code)), generator_(generator) {
    speed_ = effects.speed_sd * generator.normal();
    for (std::size_t method = 0; method < effects.ratios.size(); ++method) {
      // Each of a ratio's two methods gives half of the variance of its interaction.
      interactions_.push_back(effects.interaction_sd / std::sqrt(2.0) * generator.normal());
    }
  }

  void add_trials(study::StudyRecords& records) {
    int trial = 0;
    const std::vector<int> scenes = random_order(records.scenes.size(), generator_);
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      const std::vector<int> methods = random_order(records.methods.size(), generator_);
      for (std::size_t j = 0; j < methods.size(); ++j) {
        study::TrialRow row = trial_row(records, scenes[i], methods[j], trial++);
        row.scene_position = static_cast<int>(i);
        row.method_position = static_cast<int>(j);
        records.trials.push_back(std::move(row));
      }
    }
  }

 private:
  study::TrialRow trial_row(const study::StudyRecords& records, int scene, int method, int trial) {
    constexpr double first_scene_s = 5.0;
    const auto method_index = static_cast<std::size_t>(method);
    const double log_time = std::log(first_scene_s * (1.0 + scene)) + speed_ +
                            std::log(effects_.ratios[method_index]) + interactions_[method_index] +
                            effects_.change_per_trial * trial;
    study::TrialRow row;
    row.participant = code_;
    row.scene = records.scenes[static_cast<std::size_t>(scene)];
    row.method = records.methods[method_index];
    row.attempts = 1;
    const double outline = std::exp(log_time + effects_.trial_sd * generator_.normal());
    const double longer = 1.0 + std::exp(effects_.trial_sd * generator_.normal());
    row.outline_s = outline;
    row.material_s = outline * longer;
    row.artifact_rating =
        std::clamp(static_cast<int>(std::lround(2.5 + generator_.normal())), 1, 5);
    return row;
  }

  const InjectedEffects& effects_;
  std::string code_;
  Pcg32& generator_;
  double speed_ = 0.0;
  std::vector<double> interactions_;
};

}  // namespace

study::StudyRecords study_with_injected_effects(const InjectedEffects& effects,
                                                std::uint64_t seed) {
  Pcg32 generator(seed);
  study::StudyRecords records;
  records.protocol_name = "injected";
  records.protocol_title = "A study with injected effects";
  for (int scene = 1; scene <= effects.scenes; ++scene) {
    records.scenes.push_back(fmt::format("scene-{}", scene));
  }
  const std::vector<std::string> published = {"od", "vp", "fv"};
  for (std::size_t method = 0; method < effects.ratios.size(); ++method) {
    records.methods.push_back(method < published.size() ? published[method]
                                                        : fmt::format("method-{}", method + 1));
  }
  for (int i = 1; i <= effects.participants; ++i) {
    const std::string code = fmt::format("S{:05}", i);
    study::SessionRow session;
    session.participant = code;
    session.kind = "simulated";
    session.state = "completed";
    records.sessions.push_back(session);
    DrawnParticipant(effects, code, generator).add_trials(records);
  }
  return records;
}

}  // namespace foveola::analysis
