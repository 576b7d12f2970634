// A participant made of numbers, who takes part by looking at the presented pixels.
#pragma once

#include <functional>

#include "study/participant/cells.h"
#include "study/participant/decision.h"
#include "study/participant/population.h"
#include "study/participant/simulated_observer.h"

namespace foveola::study {

/// What a scene's image converges to. The simulation knows it; the study does not.
struct KnownScene {
  const RgbImage* panorama = nullptr;  ///< linear radiance, equirect
  double exposure_stops = 0.0;
};
using SceneKnowledge = std::function<KnownScene(const std::string& scene)>;

/// Marks an outline when it stands out of what differs from the picture that is expected, and a
/// material when no such difference is noticed any more; then reacts. Rates by the difference
/// noticed while looking around. Same seed, same person.
class SimulatedParticipant final : public SimulatedObserver {
 public:
  SimulatedParticipant(const Population& population, SceneKnowledge knowledge, std::uint64_t seed);

  std::vector<Answer> answer(const std::string& form,
                             const std::vector<Question>& questions) override;
  Nanoseconds react(std::uint32_t attempt) override;
  /// Stays with one object per scene, so that methods are compared on the same one.
  std::size_t choose_object(const std::string& scene,
                            const std::vector<OfferedObject>& offered) override;
  void begin_attempt(const Attempt& attempt) override;
  void turn_to(const std::string& scene, const OfferedObject& object, Nanoseconds now) override;
  void look_at(const Vec3& target, Nanoseconds now) override { path_.fixate(target, now); }
  void begin(Task task, Nanoseconds now) override;
  AzimuthElevation head(Nanoseconds time) override { return path_.head(time); }
  Vec3 gaze(Nanoseconds time) override { return path_.gaze(time); }
  std::optional<Nanoseconds> see(const Stimulus& stimulus) override;
  bool wants_retime() const override { return decision_.wants_retime(); }
  bool wants_to_withdraw(int /*trials_before*/) const override { return false; }
  /// See is_judged(); any other as if it were asked on a form, which require_judgements() lets be
  /// only for words.
  std::vector<Answer> rate(const std::vector<Question>& ratings) override;

  std::optional<Nanoseconds> consider(const Evidence& evidence, Nanoseconds now) override;
  bool looks() const override { return true; }
  ScanPath& path() override { return path_; }

 private:
  /// What a task is judged by on one scale, and how that should look in the view.
  struct Scale {
    Cells cells;
    Visibility visibility;
    CellPixels pixels{};
    std::vector<ChannelValues> expected{};
  };
  struct Area {
    Task task = Task::mark_outline;
    std::optional<Viewport> view;
    std::vector<Scale> scales;
  };
  Evidence look(const Stimulus& stimulus);
  double difference_jnd(const Stimulus& stimulus, const Area& area) const;
  std::vector<PatchEnergies> energies(const Stimulus& stimulus, const Scale& scale,
                                      bool with_contrast) const;
  /// The cells that the task is judged by.
  std::vector<Scale> judged_scales() const;
  /// What they should look like in the stimulus's view; made anew only when view or task change.
  const Area& expect(const Stimulus& stimulus);
  double noticed_jnd(Pcg32& random) const;

  Population population_;
  SceneKnowledge knowledge_;
  std::uint64_t seed_;
  Traits traits_;
  Decision decision_;
  ScanPath path_;
  Attempt attempt_;
  KnownScene scene_;
  OfferedObject object_;
  std::optional<Area> area_;
  std::optional<Task> task_;
  double artifacts_jnd_ = 0.0;  ///< sum over the looks around
  int looks_ = 0;
};

}  // namespace foveola::study
