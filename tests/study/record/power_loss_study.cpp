#include "power_loss_study.h"

#include <deque>
#include <filesystem>
#include <future>
#include <random>

#include "study/record/write/recorders.h"

namespace foveola::study {
namespace {

/// Gaze that compression makes little smaller.
std::vector<GazeSample> noisy_gaze(int count, std::mt19937& noise) {
  std::vector<GazeSample> samples;
  for (int i = 0; i < count; ++i) {
    const auto x = static_cast<float>(noise());
    const auto y = static_cast<float>(noise());
    samples.push_back({.time = Nanoseconds(noise()), .direction = {x, y, -1.0F}});
  }
  return samples;
}

/// Records as the program does it, and remembers in which order, and what was acknowledged.
class Recorder {
 public:
  Recorder(StudyStore& store, DiskWatch& watch) : store_(&store), watch_(&watch) {}

  /// A whole session; what is recorded of it is so many samples of gaze larger.
  void run_session(const std::string& participant, int gaze_samples) {
    state_ = {};
    session_ = store_->begin_session(facts_of(participant), small_plan());
    remember(&Holdings::sessions);
    watch_->acknowledge();
    ThreadedRecorder recorder(*store_, session_);
    happen(recorder, ms(0), SessionStarted{});
    happen(recorder, ms(10),
           QuestionnaireAnswered{.questionnaire = "background",
                                 .answers = {{.question = "age", .value = 31.0}}});
    for (std::size_t trial = 0; trial < small_plan().size(); ++trial) {
      run_trial(recorder, trial, gaze_samples);
    }
    wait_for_all();
  }

  /// After each commit, from none on.
  const std::vector<Holdings>& commits() const { return commits_; }
  /// Of all sessions, in order.
  const std::vector<TimedEvent>& events() const { return events_; }

 private:
  void run_trial(ThreadedRecorder& recorder, std::size_t trial, int gaze_samples) {
    const Nanoseconds start = ms(1000 * static_cast<std::int64_t>(trial + 1));
    if (state_.phase == Phase::choosing_object) {
      happen(recorder, start, ObjectChosen{"vase"});
    }
    happen(recorder, start, TrialStarted{});
    happen(recorder, start, FirstFramePresented{start});
    wait_for_all();  // as a person's session does
    add(&Holdings::frame_chunks,
        recorder.record(FrameChunk{.attempt = {.trial = trial, .attempt = 1},
                                   .first = 0,
                                   .frames = plausible_frames(60)}));
    add(&Holdings::gaze_chunks,
        recorder.record(GazeChunk{.attempt = {.trial = trial, .attempt = 1},
                                  .first = 0,
                                  .samples = noisy_gaze(gaze_samples, noise_)}));
    happen(recorder, start + ms(100), Marked{start + ms(100)});
    happen(recorder, start + ms(200), Marked{start + ms(200)});
    wait_for_all();
    add(&Holdings::frame_chunks,
        recorder.record(FrameChunk{.attempt = {.trial = trial, .attempt = 1},
                                   .first = 60,
                                   .frames = plausible_frames(20)}));
    add(&Holdings::film_hashes,
        recorder.record(FilmEntry{.attempt = {.trial = trial, .attempt = 1},
                                  .hash = {.frame = 79, .sha256 = std::string(64, 'f')}}));
    happen(recorder, start + ms(300), rated(3));
  }

  void happen(ThreadedRecorder& recorder, Nanoseconds time, const Event& event) {
    const Transition next = step(procedure_, state_, event).value();
    events_.push_back({time, std::string(name_of(event))});
    add(&Holdings::events,
        recorder.record(
            EventEntry{.time = time, .event = event, .before = state_, .after = next.state}));
    state_ = next.state;
  }

  void add(std::size_t Holdings::* kind, std::future<void> done) {
    remember(kind);
    in_flight_.push_back(std::move(done));
    while (in_flight_.size() > 2) {
      wait_for_one();
    }
  }

  void remember(std::size_t Holdings::* kind) {
    commits_.push_back(commits_.back());
    ++(commits_.back().*kind);
  }

  void wait_for_one() {
    in_flight_.front().get();
    in_flight_.pop_front();
    watch_->acknowledge();
  }

  void wait_for_all() {
    while (!in_flight_.empty()) {
      wait_for_one();
    }
  }

  StudyStore* store_;
  DiskWatch* watch_;
  Procedure procedure_ = procedure_of(small_protocol(), small_plan());
  SessionState state_;
  std::int64_t session_ = 0;
  std::mt19937 noise_{7};
  std::deque<std::future<void>> in_flight_;
  std::vector<Holdings> commits_{Holdings{}};
  std::vector<TimedEvent> events_;
};

/// Two sessions, each by a program of its own, the first with so many samples of gaze in each
/// trial.
RecordedStudy record_two_sessions(int gaze_samples) {
  constexpr int few_samples = 50;
  const TemporaryFolder folder;
  const std::filesystem::path path = folder / "study.sqlite";
  DiskWatch watch(folder.path());
  RecordedStudy study{.commits = {Holdings{}}};
  for (const char* participant : {"P01", "P02"}) {
    StudyStore store(path, small_protocol());
    Recorder recorder(store, watch);
    recorder.run_session(participant, study.events.empty() ? gaze_samples : few_samples);
    const Holdings before = study.commits.back();
    for (std::size_t i = 1; i < recorder.commits().size(); ++i) {
      const Holdings& own = recorder.commits()[i];
      study.commits.push_back({before.sessions + own.sessions, before.events + own.events,
                               before.frame_chunks + own.frame_chunks,
                               before.gaze_chunks + own.gaze_chunks,
                               before.film_hashes + own.film_hashes});
    }
    study.events.insert(study.events.end(), recorder.events().begin(), recorder.events().end());
  }
  study.calls = watch.calls();
  return study;
}

}  // namespace

const RecordedStudy& short_study() {
  static const RecordedStudy study = record_two_sessions(50);
  return study;
}

const RecordedStudy& long_study() {
  static const RecordedStudy study = record_two_sessions(100'000);
  return study;
}

}  // namespace foveola::study
