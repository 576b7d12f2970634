// Models a person who judges the presented pixels.
#pragma once

#include <functional>

#include "study/participant/observer/cells.h"
#include "study/participant/observer/decision.h"
#include "study/participant/observer/scan_path.h"
#include "study/participant/participant.h"
#include "study/participant/population.h"

namespace foveola::study {

/// The converged image of a scene. The simulation knows it; the study does not.
struct KnownScene {
  const RgbImage* panorama = nullptr;  ///< Linear radiance, equirect.
  double exposure_stops = 0.0;
};
using SceneKnowledge = std::function<KnownScene(const std::string& scene)>;

/// Marks an outline when its contrast stands out of the noise, the difference from the expected
/// image, and a material when that difference is no longer noticed; both after a reaction time.
/// Rates by the difference noticed while looking around. Equal seeds are equal persons.
class SimulatedParticipant : public Participant {
 public:
  SimulatedParticipant(const Population& population, SceneKnowledge knowledge, std::uint64_t seed);

  std::vector<Answer> answer(const std::string& form,
                             const std::vector<Question>& questions) override;
  Nanoseconds react(std::uint32_t attempt) override;
  /// Chooses the same object each time in a scene, so that methods are compared on the same one.
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
  /// Judges ratings if is_judged() says so. Answers the others as on a form; require_judgements()
  /// allows only free text for these.
  std::vector<Answer> rate(const std::vector<Question>& ratings) override;

  std::optional<Nanoseconds> consider(const Evidence& evidence, Nanoseconds now) override;
  /// Returns the scan path that gaze() and head() follow.
  ScanPath& path() { return path_; }

 private:
  /// The cells of a task on one scale, and their expected values in the view.
  struct Scale {
    Cells cells;
    Visibility visibility;
    CellPixels pixels{};
    std::vector<ChannelValues> expected{};
  };
  struct Area {
    Task task = Task::mark_outline;
    Vec3 looked_at{0.0F};  ///< Centre of the area: the object, or, while looking around, the gaze.
    std::optional<Viewport> view;
    std::vector<Scale> scales;
  };
  Evidence look(const Stimulus& stimulus);
  double difference_jnd(const Stimulus& stimulus, const Area& area) const;
  std::vector<PatchEnergies> energies(const Stimulus& stimulus, const Scale& scale,
                                      bool with_contrast) const;
  /// Returns the task's cells around `looked_at`, on all scales.
  std::vector<Scale> make_scales(const Vec3& looked_at) const;
  /// Returns the expected values in the stimulus's view, cached until the view or the area changes.
  const Area& expect(const Stimulus& stimulus);
  /// Whether this moment is judged: while looking around, not during a saccade nor just after.
  bool judges(Nanoseconds now);
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
  double artifact_powers_ = 0.0;  ///< Sum over the glances while looking around.
  int looks_ = 0;                 ///< Number of these glances.
};

}  // namespace foveola::study
