// A participant made of numbers, who takes part by looking at the presented pixels.
#pragma once

#include <functional>

#include "study/participant/participant.h"
#include "study/participant/population.h"
#include "study/participant/scan_path.h"
#include "study/participant/visible_difference.h"

namespace foveola::study {

/// What a scene's image converges to. The simulation knows it; the study does not.
struct KnownScene {
  const RgbImage* panorama = nullptr;  ///< linear radiance, equirect
  double exposure_stops = 0.0;
};
using SceneKnowledge = std::function<KnownScene(const std::string& scene)>;

/// Marks an outline when the object's contrast stands out of the presented image's deviation from
/// what is expected, and a material when that deviation is no longer noticed; then reacts. Rates by
/// the deviation noticed while looking around. Same seed, same person.
class SimulatedParticipant final : public Participant {
 public:
  SimulatedParticipant(const Population& population, SceneKnowledge knowledge, std::uint64_t seed);

  std::vector<Answer> answer(const std::string& form,
                             const std::vector<Question>& questions) override;
  Nanoseconds react(std::uint32_t occasion) override;
  /// Stays with one object per scene, so that methods are compared on the same one.
  std::size_t choose_object(const std::string& scene,
                            const std::vector<OfferedObject>& offered) override;
  void begin_occasion(std::uint32_t conduct) override;
  void turn_to(const std::string& scene, const OfferedObject& object, Nanoseconds now) override;
  void look_at(const Vec3& target, Nanoseconds now) override { path_.fixate(target, now); }
  void begin(Task task, Nanoseconds now) override;
  AzimuthElevation head(Nanoseconds time) override { return path_.head(time); }
  Vec3 gaze(Nanoseconds time) override { return path_.gaze(time); }
  std::optional<Nanoseconds> see(const Percept& percept) override;
  /// "artifacts" by what was noticed, others as if it were asked on a form.
  std::vector<Answer> rate(const std::vector<Question>& ratings) override;

 private:
  /// What a view should look like, and where in it to look.
  struct Expectation {
    Viewport viewport;
    RgbImage image;  ///< sRGB-encoded
    Region outline;
    Region material;
  };

  /// The expectation for the percept's view; made anew only when the view changes.
  const Expectation& expect(const Percept& percept);
  bool outline_stands_out(const Percept& percept);
  bool material_is_right(const Percept& percept);
  void notice_artifacts(const Percept& percept);
  double judge_artifacts(const Question& scale) const;
  Nanoseconds reaction_time(Pcg32& random) const;

  ObserverModel observer_;
  GazeHabits habits_;
  SceneKnowledge knowledge_;
  std::uint64_t seed_;
  Pcg32 random_;  ///< of the occasion
  ScanPath path_;
  double outline_criterion_;   ///< individual
  double material_criterion_;  ///< individual, in just noticeable differences
  double rating_bias_;         ///< individual; multiplies what is noticed
  KnownScene scene_;
  OfferedObject object_;
  std::optional<Expectation> expectation_;
  std::optional<Task> task_;
  std::optional<Nanoseconds> satisfied_since_;
  double noticed_jnd_ = 0.0;  ///< sum over the looks around
  int looks_ = 0;
};

}  // namespace foveola::study
