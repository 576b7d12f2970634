// What is acknowledged stays: through kills, full disks and, as far as a test can see it, power
// cuts.
#include <atomic>
#include <csignal>
#include <random>

#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include "study/record/read/study_records.h"
#include "study/record/write/study_store.h"
#include "tests/matchers.h"
#include "tests/study/record/small_study.h"

namespace fs = std::filesystem;

namespace {

std::atomic<int> sync_count = 0;

}  // namespace

// SQLite finds these before the C library's, so that the tests can count how often it syncs.
extern "C" int fsync(int file) {
  ++sync_count;
  return static_cast<int>(::syscall(SYS_fsync, file));
}
extern "C" int fdatasync(int file) {
  ++sync_count;
  return static_cast<int>(::syscall(SYS_fdatasync, file));
}

namespace foveola::study {
namespace {

int syncs_during(const std::function<void()>& work) {
  const int before = sync_count;
  work();
  return sync_count - before;
}

TEST(Durability, EveryCallIsSyncedBeforeItReturns) {
  const TemporaryFolder folder;
  StudyStore store(folder / "study.sqlite", small_protocol());
  std::int64_t session = 0;
  EXPECT_GE(syncs_during([&] { session = store.begin_session(facts_of("P01"), small_plan()); }), 1);
  const SessionState ready{.phase = Phase::ready, .step = 1, .object = "vase"};
  const SessionState armed{.phase = Phase::armed, .step = 1, .object = "vase"};
  EXPECT_GE(
      syncs_during([&] {
        store.record(
            session,
            EventEntry{.time = ms(1), .event = TrialStarted{}, .before = ready, .after = armed});
      }),
      1);
  EXPECT_GE(syncs_during([&] {
              store.record(session, FrameChunk{.attempt = {}, .first = 0, .frames = {FrameRow{}}});
            }),
            1);
  EXPECT_GE(syncs_during([&] {
              store.record(session,
                           GazeChunk{.attempt = {}, .first = 0, .samples = {GazeSample{}}});
            }),
            1);
  EXPECT_GE(syncs_during([&] {
              store.record(
                  session,
                  FilmEntry{.attempt = {}, .hash = {.frame = 0, .sha256 = std::string(64, '0')}});
            }),
            1);
}

/// Times one method again and again, with one byte on `acknowledgements` for each recorded event.
[[noreturn]] void record_until_killed(const fs::path& path, int acknowledgements) {
  StudyStore store(path, small_protocol());
  PlayedSession session(store, facts_of("P01"), small_plan());
  const auto acknowledge = [&](const Event& event) {
    session.happen(ms(1), event);
    if (::write(acknowledgements, "!", 1) != 1) {
      ::_exit(1);
    }
  };
  acknowledge(SessionStarted{});
  acknowledge(QuestionnaireAnswered{.questionnaire = "background", .answers = {}});
  acknowledge(ObjectChosen{"vase"});
  while (true) {
    acknowledge(TrialStarted{});
    acknowledge(FirstFramePresented{ms(1)});
    acknowledge(Marked{ms(1)});
    acknowledge(RetimeRequested{});
  }
}

/// Kills a recording program once it has acknowledged `enough` events. Returns how many it had.
int kill_after(const fs::path& path, int enough) {
  std::array<int, 2> pipe_ends{};
  EXPECT_EQ(::pipe(pipe_ends.data()), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    record_until_killed(path, pipe_ends[1]);
  }
  ::close(pipe_ends[1]);
  int acknowledged = 0;
  char byte = 0;
  while (acknowledged < enough && ::read(pipe_ends[0], &byte, 1) == 1) {
    ++acknowledged;
  }
  ::kill(child, SIGKILL);
  while (::read(pipe_ends[0], &byte, 1) == 1) {
    ++acknowledged;
  }
  ::close(pipe_ends[0]);
  int status = 0;
  EXPECT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFSIGNALED(status)) << "the program ended by itself";
  return acknowledged;
}

TEST(Durability, KilledProgramHasKeptAllItAcknowledged) {
  for (const int enough : {1, 3, 20, 100}) {
    const TemporaryFolder folder;
    const fs::path path = folder / "study.sqlite";
    const int acknowledged = kill_after(path, enough);
    EXPECT_GE(acknowledged, enough);

    EXPECT_EQ(read_study(path).sessions.size(), 1U);
    {
      const StudyStore recovered(path, small_protocol());
    }
    EXPECT_THAT(folder.content(), SizeIs(1));
    EXPECT_EQ(query(path, "PRAGMA integrity_check"), "ok");
    const int kept = std::stoi(query(path, "SELECT count(*) FROM event"));
    EXPECT_GE(kept, acknowledged);
    EXPECT_LE(kept, acknowledged + 1) << "only the event at work may be kept unacknowledged";
    EXPECT_EQ(query(path, "SELECT max(sequence) FROM event"), std::to_string(kept));
  }
}

/// No file can grow beyond a size for the length of a scope.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    ::getrlimit(RLIMIT_FSIZE, &original_);
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{.rlim_cur = bytes, .rlim_max = original_.rlim_max};
    EXPECT_EQ(::setrlimit(RLIMIT_FSIZE, &limit), 0);
  }
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &original_);
    std::signal(SIGXFSZ, SIG_DFL);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit original_{};
};

/// Frames that compression makes no smaller.
std::vector<FrameRow> noisy_frames(std::uint64_t count) {
  std::mt19937 noise(1);
  std::vector<FrameRow> frames(count);
  for (FrameRow& frame : frames) {
    frame.time = Nanoseconds(noise());
    frame.gaze_age = Nanoseconds(noise());
    frame.samples = static_cast<std::uint32_t>(noise());
  }
  return frames;
}

TEST(Durability, FailedWriteIsReportedAndLosesNothingBeforeIt) {
  const TemporaryFolder folder;
  const fs::path path = folder / "study.sqlite";
  constexpr std::uint64_t frames_per_chunk = 1000;
  std::uint64_t acknowledged = 0;
  {
    StudyStore store(path, small_protocol());
    PlayedSession session = begun_session(store);
    session.choose_and_start(ms(20));
    const std::vector<FrameRow> frames = noisy_frames(frames_per_chunk);
    const auto record_chunk = [&] {
      store.record(
          session.id(),
          FrameChunk{.attempt = {}, .first = acknowledged * frames_per_chunk, .frames = frames});
      ++acknowledged;
    };
    {
      const FileSizeLimit limit(1'000'000);
      const std::string message = refusal([&] {
        while (acknowledged < 1000) {
          record_chunk();
        }
      });
      EXPECT_THAT(message,
                  AllOf(StartsWith(path.string() + ": "), HasSubstr("acknowledged is safe")));
    }
    EXPECT_GT(acknowledged, 0U);
    record_chunk();
  }
  EXPECT_EQ(query(path, "SELECT count(*) FROM frame_chunk"), std::to_string(acknowledged));
  EXPECT_EQ(query(path, "PRAGMA integrity_check"), "ok");
}

}  // namespace
}  // namespace foveola::study
