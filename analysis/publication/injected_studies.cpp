#include "analysis/publication/injected_studies.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include <fmt/format.h>

#include "renderer/base/random.h"
#include "study/protocol/read_procedure.h"

namespace foveola::analysis {
namespace {

using study::Value;

std::vector<int> random_order(std::size_t count, Pcg32& generator) {
  std::vector<int> order(count);
  std::iota(order.begin(), order.end(), 0);
  shuffle(std::span(order), generator);
  return order;
}

Value measured(double number) { return {.state = Value::State::measured, .number = number}; }

/// A participant's trials, one after the other.
class DrawnParticipant {
 public:
  /// `others` draws what the published study did not measure.
  DrawnParticipant(const InjectedEffects& effects, std::uint32_t session, Pcg32& generator,
                   Pcg32& others)
      : effects_(effects), session_(session), generator_(generator), others_(others) {
    speed_ = effects.speed_sd * generator.normal();
    comfort_ = 50.0 + 10.0 * others.normal();
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
        const study::TrialRow row{.session = session_,
                                  .trial = static_cast<std::uint32_t>(trial),
                                  .scene = static_cast<std::uint16_t>(scenes[i]),
                                  .method = static_cast<std::uint16_t>(methods[j]),
                                  .scene_position = static_cast<std::uint16_t>(i),
                                  .method_position = static_cast<std::uint16_t>(j),
                                  .attempt = 1};
        records.add_trial(row, draw_values(scenes[i], methods[j], trial++));
      }
    }
  }

 private:
  std::vector<Value> draw_values(int scene, int method, int trial) {
    constexpr double first_scene_s = 5.0;
    const auto method_index = static_cast<std::size_t>(method);
    const double log_time = std::log(first_scene_s * (1.0 + scene)) + speed_ +
                            std::log(effects_.ratios[method_index]) + interactions_[method_index] +
                            effects_.change_per_trial * trial;
    const double outline_s = std::exp(log_time + effects_.trial_sd * generator_.normal());
    const double longer = 1.0 + std::exp(effects_.trial_sd * generator_.normal());
    const double rating = std::clamp(std::round(2.5 + generator_.normal()), 1.0, 5.0);
    const double recognition_s = 3.0 * outline_s * std::exp(effects_.trial_sd * others_.normal());
    const double shift = method_index + 1 == effects_.ratios.size() ? effects_.comfort_shift : 0.0;
    const double comfort = std::round(comfort_ + shift + 8.0 * others_.normal());
    return {measured(outline_s), measured(outline_s * longer), measured(recognition_s),
            measured(rating), measured(std::clamp(comfort, 0.0, 100.0))};
  }

  const InjectedEffects& effects_;
  std::uint32_t session_;
  Pcg32& generator_;
  Pcg32& others_;
  double speed_ = 0.0;
  double comfort_ = 0.0;
  std::vector<double> interactions_;
};

std::vector<study::Measure> measures_with_effects() {
  std::vector<study::MarkEntry> marks = study::published_marks();
  marks.push_back({.id = "recognition", .instruction = "Press when you know what it is."});
  std::vector<study::Question> ratings = study::published_ratings();
  ratings.push_back(
      {.id = "comfort", .text = "How comfortable?", .minimum = 0.0, .maximum = 100.0});
  return study::trial_measures(marks, ratings);
}

}  // namespace

study::StudyRecords study_with_injected_effects(const InjectedEffects& effects,
                                                std::uint64_t seed) {
  Pcg32 generator(seed);
  Pcg32 others(seed, 1);
  study::StudyRecords records;
  records.protocol.name = "injected";
  records.protocol.title = "A study with injected effects";
  records.words = {""};
  records.measures = measures_with_effects();
  for (int scene = 1; scene <= effects.scenes; ++scene) {
    records.scenes.push_back(fmt::format("scene-{}", scene));
  }
  const std::vector<std::string> published = {"od", "vp", "fv"};
  for (std::size_t method = 0; method < effects.ratios.size(); ++method) {
    records.methods.push_back(method < published.size() ? published[method]
                                                        : fmt::format("method-{}", method + 1));
  }
  for (int i = 0; i < effects.participants; ++i) {
    records.sessions.push_back({.participant = fmt::format("S{:05}", i + 1),
                                .kind = "simulated",
                                .state = "completed",
                                .design_row = {},
                                .reason = {}});
    DrawnParticipant(effects, static_cast<std::uint32_t>(i), generator, others).add_trials(records);
  }
  return records;
}

}  // namespace foveola::analysis
