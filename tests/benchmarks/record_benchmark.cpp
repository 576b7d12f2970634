// How long a frame loop is kept by what it gives to be recorded, and how large a session's file
// becomes.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <thread>
#include <utility>

#include <benchmark/benchmark.h>

#include "renderer/base/digest.h"
#include "renderer/base/quantile.h"
#include "renderer/base/random.h"
#include "study/record/threaded_recorder.h"
#include "tests/temporary_folder.h"

namespace foveola::study {
namespace {

constexpr int frames_per_chunk = 70;  // a second of frames
constexpr double frame_rate_hz = 70.0;
constexpr double gaze_rate_hz = 120.0;

Protocol two_marks() {
  Protocol protocol;
  protocol.name = "benchmark";
  protocol.title = "A benchmark";
  protocol.scenes = {{.name = "box"}};
  protocol.methods = {"od"};
  protocol.marks = {{.id = "outline"}, {.id = "material"}};
  protocol.ratings = {{.id = "artifacts"}};
  protocol.phases = {{.kind = PhaseEntry::Kind::trials}};
  protocol.text = "name = \"benchmark\"\n";
  protocol.sha256 = sha256(protocol.text);
  return protocol;
}

SessionFacts facts() {
  return {.participant = "P01",
          .scenes = {{.name = "box",
                      .file_name = "box.glb",
                      .sha256 = std::string(64, 'a'),
                      .shown_as = "{}"}}};
}

Vec3 direction(double azimuth_rad, double elevation_rad) {
  return {static_cast<float>(std::sin(azimuth_rad) * std::cos(elevation_rad)),
          static_cast<float>(std::sin(elevation_rad)),
          static_cast<float>(-std::cos(azimuth_rad) * std::cos(elevation_rad))};
}

/// A head that turns slowly and an eye that jumps, with a tracker's noise, which no compression
/// makes smaller.
class PlausiblePerson {
 public:
  FrameRow frame() {
    time_s_ += 1.0 / frame_rate_hz;
    const double head_rad = 0.4 * std::sin(0.3 * time_s_);
    const double noise = jitter();
    return {.time = nanoseconds_from_seconds(time_s_ + 1e-4 * jitter()),
            .presented = nanoseconds_from_seconds(time_s_ + 0.009 + 1e-4 * noise),
            .head_azimuth_rad = static_cast<float>(head_rad + 1e-4 * jitter()),
            .head_elevation_rad = static_cast<float>(0.1 * std::cos(0.2 * time_s_)),
            .gaze = look(),
            .gaze_valid = true,
            .gaze_age = nanoseconds_from_seconds(0.008 + 0.004 * random_.uniform()),
            .samples = 600 + random_.below(30)};
  }
  GazeSample sample(double time_s) {
    return {.time = nanoseconds_from_seconds(time_s + 1e-4 * jitter()),
            .direction = look(),
            .valid = true,
            .mark = GazeMark::fixation};
  }

 private:
  double jitter() { return random_.normal(); }
  Vec3 look() {
    const bool jumps = random_.uniform() < 0.02;
    target_rad_ = jumps ? random_.uniform() - 0.5 : target_rad_;
    const double up_rad = 0.1 + 0.002 * jitter();
    return direction(target_rad_ + 0.002 * jitter(), up_rad);
  }

  Pcg32 random_{1, 1};
  double time_s_ = 0.0;
  double target_rad_ = 0.0;
};

/// An attempt in which marks can be asked for.
struct OpenAttempt {
  std::int64_t session = 0;
  SessionState state;
};

OpenAttempt begin_attempt(StudyStore& store, const Protocol& protocol) {
  const Plan plan = {{.scene = "box", .method = "od"}};
  const Procedure procedure = procedure_of(protocol, plan);
  OpenAttempt attempt{.session = store.begin_session(facts(), plan), .state = {}};
  for (const Event& event : {Event(SessionStarted{}), Event(ObjectChosen{"box"}),
                             Event(TrialStarted{}), Event(FirstFramePresented{})}) {
    const SessionState next = step(procedure, attempt.state, event).value().state;
    store.record(
        attempt.session,
        EventEntry{.time = Nanoseconds(0), .event = event, .before = attempt.state, .after = next});
    attempt.state = next;
  }
  return attempt;
}

double milliseconds_of(const std::function<void()>& work) {
  const SteadyClock clock;
  const Nanoseconds start = clock.now();
  work();
  return 1e3 * seconds(clock.now() - start);
}

/// 10,000 frames, ten times as fast as a display; a chunk of frames and one of gaze every second's
/// worth of frames, and a note in between. Each frame's time is what giving that away took.
void frames_beside_the_record_thread(benchmark::State& state) {
  constexpr int frame_count = 10'000;
  constexpr auto pace = std::chrono::microseconds(1429);
  std::vector<double> kept_ms;
  for (auto _ : state) {
    const test::TemporaryFolder folder;
    const Protocol protocol = two_marks();
    StudyStore store(folder / "study.sqlite", protocol);
    const OpenAttempt attempt = begin_attempt(store, protocol);
    ThreadedRecorder recorder(store, attempt.session);
    PlausiblePerson person;
    std::vector<FrameRow> frames;
    auto next = std::chrono::steady_clock::now();
    for (int frame = 0; frame < frame_count; ++frame) {
      frames.push_back(person.frame());
      kept_ms.push_back(milliseconds_of([&] {
        if (frames.size() == frames_per_chunk) {
          const auto first = static_cast<std::uint64_t>(frame + 1 - frames_per_chunk);
          recorder.record(
              FrameChunk{.attempt = {}, .first = first, .frames = std::exchange(frames, {})});
          recorder.record(GazeChunk{
              .attempt = {},
              .first = first,
              .samples = std::vector<GazeSample>(static_cast<std::size_t>(frames_per_chunk))});
        }
        if (frame % 50 == 25) {
          recorder.record(EventEntry{.time = Nanoseconds(frame),
                                     .event = NoteWritten{.text = "a note"},
                                     .before = attempt.state,
                                     .after = attempt.state});
        }
      }));
      next += pace;
      std::this_thread::sleep_until(next);
    }
  }
  std::sort(kept_ms.begin(), kept_ms.end());
  state.counters["median_ms"] = quantile(kept_ms, 0.5);
  state.counters["p99_9_ms"] = quantile(kept_ms, 0.999);
  state.counters["worst_ms"] = kept_ms.back();
}
BENCHMARK(frames_beside_the_record_thread)->Iterations(1)->Unit(benchmark::kSecond);

/// 45 minutes of frames and gaze without a gap.
void file_of_a_session(benchmark::State& state) {
  constexpr int session_s = 45 * 60;
  double megabytes = 0.0;
  for (auto _ : state) {
    const test::TemporaryFolder folder;
    const Protocol protocol = two_marks();
    {
      StudyStore store(folder / "study.sqlite", protocol);
      const OpenAttempt attempt = begin_attempt(store, protocol);
      PlausiblePerson person;
      for (int second = 0; second < session_s; ++second) {
        std::vector<FrameRow> frames(frames_per_chunk);
        std::generate(frames.begin(), frames.end(), [&] { return person.frame(); });
        std::vector<GazeSample> samples;
        for (int i = 0; i < static_cast<int>(gaze_rate_hz); ++i) {
          samples.push_back(person.sample(second + i / gaze_rate_hz));
        }
        store.record(attempt.session,
                     FrameChunk{.attempt = {},
                                .first = static_cast<std::uint64_t>(second * frames_per_chunk),
                                .frames = frames});
        store.record(attempt.session,
                     GazeChunk{.attempt = {},
                               .first = static_cast<std::uint64_t>(second) * samples.size(),
                               .samples = samples});
      }
    }
    megabytes = 1e-6 * static_cast<double>(std::filesystem::file_size(folder / "study.sqlite"));
  }
  state.counters["megabytes"] = megabytes;
}
BENCHMARK(file_of_a_session)->Iterations(1)->Unit(benchmark::kSecond);

}  // namespace
}  // namespace foveola::study
