// A participant for tests: does what a test asks for, and keeps what it was asked.
#pragma once

#include <algorithm>
#include <atomic>
#include <string>
#include <vector>

#include "study/participant/participant.h"

namespace foveola::study {

/// Chooses the last object, looks straight ahead unless its eye is to turn, and presses `thought`
/// after as many looks at a task as it needs.
class FakeParticipant final : public Participant {
 public:
  // What it does.
  Nanoseconds reaction = std::chrono::milliseconds(300);
  Nanoseconds thought = std::chrono::milliseconds(150);
  int looks_needed = 1;
  bool sees_in_blackness = true;     ///< a look at a black picture counts
  bool regrets = false;              ///< every timing
  double gaze_deg_per_s = 0.0;       ///< how fast its eye turns to the right
  std::ptrdiff_t retimed_turn = -1;  ///< the turn to an object whose second mark is regretted
  int withdraws_before = -1;         ///< the trial

  // What it was asked.
  std::vector<std::string> forms;
  std::vector<std::uint32_t> attempts;
  std::vector<int> trials_before;
  std::vector<std::string> objects;
  std::vector<Nanoseconds> turns;  ///< when it turned to them
  std::vector<Task> tasks;
  std::vector<Nanoseconds> look_times;
  std::atomic<int> look_count = 0;  ///< also while another thread shows it something

  std::vector<Answer> answer(const std::string& form,
                             const std::vector<Question>& /*questions*/) override {
    forms.push_back(form);
    return {};
  }
  Nanoseconds react(std::uint32_t /*attempt*/) override { return reaction; }
  std::size_t choose_object(const std::string& /*scene*/,
                            const std::vector<OfferedObject>& offered) override {
    return offered.size() - 1;
  }
  void begin_attempt(const Attempt& attempt) override {
    attempts.push_back(attempt.conduct);
    trials_before.push_back(attempt.trials_before);
  }
  void turn_to(const std::string& /*scene*/, const OfferedObject& object,
               Nanoseconds now) override {
    objects.push_back(object.name);
    turns.push_back(now);
  }
  void look_at(const Vec3& /*target*/, Nanoseconds /*now*/) override {}
  void begin(Task task, Nanoseconds /*now*/) override {
    tasks.push_back(task);
    looks_left_ = task == Task::look_around ? 0 : looks_needed;
  }
  AzimuthElevation head(Nanoseconds /*time*/) override { return {}; }
  Vec3 gaze(Nanoseconds time) override {
    return direction_from({.azimuth_rad = radians(gaze_deg_per_s * foveola::seconds(time))});
  }
  std::optional<Nanoseconds> see(const Stimulus& stimulus) override {
    const auto is_lit = [](const Rgb& pixel) { return pixel.x > 0.0F; };
    const std::vector<Rgb>& pixels = stimulus.image.pixels;
    if (!sees_in_blackness && std::none_of(pixels.begin(), pixels.end(), is_lit)) {
      return std::nullopt;
    }
    return consider({}, stimulus.presented);
  }
  std::optional<Nanoseconds> consider(const Evidence& /*evidence*/, Nanoseconds now) override {
    look_times.push_back(now);
    ++look_count;
    const bool presses = looks_left_ == 1;
    looks_left_ = std::max(0, looks_left_ - 1);
    return presses ? std::optional(now + thought) : std::nullopt;
  }
  bool wants_retime() const override {
    return regrets || (std::ssize(objects) == retimed_turn && tasks.back() == Task::mark_material);
  }
  bool wants_to_withdraw(int trials) const override { return trials == withdraws_before; }
  std::vector<Answer> rate(const std::vector<Question>& ratings) override {
    std::vector<Answer> answers;
    for (const Question& question : ratings) {
      answers.push_back({question.id, question.maximum});
    }
    return answers;
  }

 private:
  int looks_left_ = 0;  ///< until it presses
};

}  // namespace foveola::study
