// A study whose program is killed again and again, and goes on.
//
// FOVEOLA_KILLS=1000 kills it so often instead of a few times.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <map>
#include <random>
#include <set>
#include <thread>
#include <utility>

#include "renderer/base/files/files.h"
#include "renderer/base/text/csv.h"
#include "study/record/maintain/maintenance.h"
#include "tests/end_to_end/hall.h"
#include "tests/end_to_end/running_program.h"
#include "tests/end_to_end/study_rows.h"
#include "tests/matchers.h"

namespace fs = std::filesystem;

namespace foveola::test {
namespace {

using Clock = std::chrono::steady_clock;

/// Every kind of step, each as short as can be.
std::string every_step() {
  return R"(
name = "kills"
title = "A study that is interrupted"
scenes = ["hall"]
methods = ["od", "fv"]

[texts]
consent = "Please agree."

[tracker.validation]
points = 5
max_accuracy_deg = 5

[timing]
mark_timeout_s = 3
rating_s = 0.5

[reaction]
presses = 2

[catch_trials]
count = 1
timeout_s = 0.5

[[practice]]
scene = "hall"
method = "fv"
)" + std::string(small_tables) +
         questionnaire_table("background", {age_question}) + questionnaire_table("debrief", {R"(
id = "comment"
text = "Anything else?"
kind = "text"
)"});
}

std::vector<std::string> command(const fs::path& database) {
  return {"study",  "simulate", "kills",          "--db", database.string(), "--threads", "1",
          "--seed", "11",       "--participants", "2",    "--resume"};
}

/// The hall with a study in it that nothing interrupted.
struct UninterruptedStudy {
  UninterruptedStudy() {
    hall.folder.write("share/protocols/kills.toml", every_step());
    finish(database);  // and all that is only made once, such as the scene's reference image
    const Clock::time_point start = Clock::now();
    finish(hall.folder / "timed.sqlite");
    run_time = Clock::now() - start;
    results = results_of(database);
    events = count_events(database);
  }

  void finish(const fs::path& study) const { succeeded(hall.run(command(study))); }

  Hall hall;
  fs::path database = hall.folder / "uninterrupted.sqlite";
  Clock::duration run_time{};
  Rows results;
  int events = 0;
};

/// So many kills in all, a few by default.
int kills() {
  const char* asked = std::getenv("FOVEOLA_KILLS");
  return asked != nullptr ? std::stoi(asked) : 12;
}

class Kill : public testing::Test {
 protected:
  static const UninterruptedStudy& uninterrupted() {
    static const UninterruptedStudy study;  // made once for all tests
    return study;
  }

  ~Kill() override { remove_study(); }

  void remove_study() const {
    for (const char* end : {"", "-wal", "-shm", ".controller"}) {
      fs::remove(study_.string() + end);
    }
  }

  bool has_events(int count) const { return count_events(study_) >= count; }

  /// Starts the study, or goes on with it, and sends it `signal` once `enough` says so; remembers
  /// what it had acknowledged, and what it said. Returns its exit code.
  template <typename Enough>
  int run_and_send(int signal, const Enough& enough) {
    RunningProgram program(command(study_), hall_.environment());
    while (!program.has_ended() && !enough()) {
      std::this_thread::sleep_for(std::chrono::microseconds(200));
    }
    const Rows log = log_of(study_);
    program.kill(signal);
    acknowledged_.insert(log.begin(), log.end());
    const int exit_code = program.wait_for_end();
    said_ = program.said();
    return exit_code;
  }

  /// Returns whether it was killed before it ended.
  template <typename Enough>
  bool run_and_kill(const Enough& enough) {
    return run_and_send(SIGKILL, enough) == 128 + SIGKILL;
  }

  /// Ends a new study by `signal`, however often it takes until the study had not come to its end
  /// by then: on a busy machine this process may sleep through it.
  template <typename Enough>
  void end_early_by(int signal, const Enough& enough) {
    constexpr int most_tries = 100;
    int exit_code = run_and_send(signal, enough);
    for (int tries = 1; exit_code == 0; ++tries) {
      ASSERT_LT(tries, most_tries) << "it always ends before: " << said_;
      acknowledged_.clear();
      remove_study();
      exit_code = run_and_send(signal, enough);
    }
    ASSERT_EQ(exit_code, 128 + signal) << said_;
  }

  /// Finishes the study and holds it against what was acknowledged, and against the one that was
  /// never interrupted.
  void finish_and_compare() {
    uninterrupted().finish(study_);
    const Rows log = log_of(study_);
    for (const std::string& event : acknowledged_) {
      EXPECT_THAT(log, Contains(event)) << "was lost";
    }
    EXPECT_THAT(results_of(study_), ElementsAreArray(uninterrupted().results));
    const study::Verification verified = study::verify_study(study_);
    EXPECT_GT(verified.events, 0U);
    for (const study::RecordFault& fault : verified.faults) {
      ADD_FAILURE() << fault.participant << ": " << fault.what;
    }
    acknowledged_.clear();
    remove_study();
  }

  const Hall& hall_ = uninterrupted().hall;
  const int events_ = uninterrupted().events;
  const fs::path study_ = hall_.folder / "study.sqlite";
  std::set<std::string> acknowledged_;
  std::string said_;
};

// The first half of the kills: each right after an event, spread over them or at each of them.
TEST_F(Kill, AfterAnEventNothingIsLost) {
  ASSERT_GT(events_, 50);
  const int kills_here = std::min(kills() / 2, events_);
  for (int kill = 0; kill < kills_here; ++kill) {
    const int after = 1 + kill * (events_ - 1) / kills_here;
    ASSERT_NO_FATAL_FAILURE(end_early_by(SIGKILL, [&] { return has_events(after); }));
    EXPECT_GE(acknowledged_.size(), static_cast<std::size_t>(after));
    finish_and_compare();
  }
}

// The others: at any moment, several in one study. A busy machine is slower at one time than at
// another, so how long a run takes follows what they took.
TEST_F(Kill, AtAnyMomentNothingIsLost) {
  std::mt19937 random(2018);
  std::uniform_real_distribution<double> moment(0.0, 1.0);
  const int kills_here = kills() - std::min(kills() / 2, events_);
  constexpr int max_in_a_study = 6;
  Clock::duration run_time = uninterrupted().run_time;
  int killed_in_study = 0;
  int studies = 0;
  for (int killed = 0; killed < kills_here;) {
    const Clock::time_point start = Clock::now();
    const Clock::duration until =
        std::chrono::duration_cast<Clock::duration>(moment(random) * run_time);
    if (run_and_kill([&] { return Clock::now() >= start + until; })) {
      ++killed;
      ++killed_in_study;
      run_time += run_time / 50;
    } else {
      killed_in_study = max_in_a_study;  // it has come to its end
      run_time = Clock::now() - start;
    }
    if (killed_in_study == max_in_a_study || killed == kills_here) {
      finish_and_compare();
      killed_in_study = 0;
      ++studies;
    }
  }
  std::cout << kills_here << " kills in " << studies << " studies\n";
}

/// A number of four bytes in SQLite's log, the highest first.
std::size_t number_at(const std::string& log, std::size_t offset) {
  std::size_t number = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    number = number << 8U | static_cast<unsigned char>(log.at(offset + i));
  }
  return number;
}

/// The file's first page as the log has it newest, by SQLite's "WAL-mode File Format".
std::string first_page_in(const std::string& log) {
  constexpr std::size_t header = 32;
  constexpr std::size_t frame_header = 24;
  const std::size_t page_size = number_at(log, 8);
  const std::string salt = log.substr(16, 8);
  std::string page;
  for (std::size_t frame = header; frame + frame_header + page_size <= log.size();
       frame += frame_header + page_size) {
    if (log.substr(frame + 8, 8) == salt && number_at(log, frame) == 1) {
      page = log.substr(frame + frame_header, page_size);
    }
  }
  return page;
}

// What a kill leaves that comes after the first page of a checkpoint: the file is longer by its own
// account than it is, and only its log makes it whole.
TEST_F(Kill, InACheckpointNothingIsLost) {
  ASSERT_NO_FATAL_FAILURE(end_early_by(SIGKILL, [&] { return has_events(events_ - 10); }));
  const std::string page = first_page_in(read_file(study_.string() + "-wal"));
  ASSERT_FALSE(page.empty());
  std::string file = read_file(study_);
  file.replace(0, page.size(), page);
  write_file(study_, file);
  finish_and_compare();
}

/// Without the column that counts a trial's attempts, if there is one.
std::vector<CsvRow> without_attempts(std::vector<CsvRow> table) {
  const auto column = std::find(table.front().begin(), table.front().end(), "attempt");
  if (column != table.front().end()) {
    const auto index = column - table.front().begin();
    for (CsvRow& row : table) {
      row.erase(row.begin() + index);
    }
  }
  return table;
}

using Tables = std::map<std::string, std::vector<CsvRow>>;

/// The tables that an analysis writes.
Tables tables_in(const fs::path& analysis) {
  Tables tables;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(analysis)) {
    const fs::path& path = entry.path();
    if (path.extension() == ".csv") {
      tables[path.filename().string()] = parse_csv(read_file(path), path.string());
    }
  }
  return tables;
}

TEST_F(Kill, TheAnalysisOfAResumedStudyIsThatOfAnUninterruptedOne) {
  ASSERT_NO_FATAL_FAILURE(end_early_by(SIGKILL, [&] { return has_events(events_ / 2); }));
  uninterrupted().finish(study_);
  std::vector<Tables> tables;
  for (const fs::path& study : {study_, uninterrupted().database}) {
    const fs::path output = study.string() + ".analysis";
    succeeded(run_foveola({"analyze", study.string(), "-o", output.string()}));
    tables.push_back(tables_in(output));
  }
  EXPECT_FALSE(tables[0].empty());
  // The kill may have fallen into a session, and into an attempt, which is then timed again: that
  // alone is told of.
  for (Tables& of_study : tables) {
    const std::size_t erased =
        std::erase_if(of_study.at("data_quality.csv"),
                      [](const CsvRow& row) { return row.front() == "Interrupted sessions"; });
    EXPECT_EQ(erased, 1U);
  }
  const std::vector<CsvRow> again = tables[0].at("trials_timed_again.csv");
  ASSERT_LE(again.size(), 2U);
  if (again.size() == 2) {
    EXPECT_THAT(again.back(), Contains("interrupted"));
    for (Tables& of_study : tables) {
      of_study.at("trials_timed_again.csv").resize(1);
      for (auto& [name, table] : of_study) {
        table = without_attempts(std::move(table));
      }
    }
  }
  EXPECT_EQ(tables[0], tables[1]);
}

// By Ctrl-C, which the program answers itself.
TEST_F(Kill, AStoppedStudyGoesOnAsWell) {
  ASSERT_NO_FATAL_FAILURE(end_early_by(SIGINT, [&] { return has_events(events_ / 3); }));
  EXPECT_THAT(said_, HasSubstr("repeat the command with --resume"));
  EXPECT_EQ(rows_of(study_, "SELECT state FROM session WHERE state <> 'completed'"),
            Rows{"interrupted"});
  finish_and_compare();
}

TEST_F(Kill, SessionsSideBySideAreThereWholeOrNotAtAll) {
  const auto side_by_side = [](const fs::path& study) {
    std::vector<std::string> jobs = command(study);
    *(std::find(jobs.begin(), jobs.end(), "--participants") + 1) = "6";
    jobs.insert(jobs.end(), {"--jobs", "2"});
    return jobs;
  };
  const fs::path whole = hall_.folder / "side-by-side.sqlite";
  ASSERT_EQ(hall_.run(side_by_side(whole)).exit_code, 0);
  for (const int signal : {SIGKILL, SIGINT}) {
    RunningProgram program(side_by_side(study_), hall_.environment());
    while (!program.has_ended() && !has_events(1)) {
      std::this_thread::sleep_for(std::chrono::microseconds(200));
    }
    program.kill(signal);
    program.wait_for_end();
    EXPECT_EQ(rows_of(study_, "SELECT state FROM session WHERE state <> 'completed'"), Rows{});
    ASSERT_EQ(hall_.run(side_by_side(study_)).exit_code, 0);
    EXPECT_EQ(results_of(study_), results_of(whole));
    remove_study();
  }
}

TEST_F(Kill, EveryAttemptOfAResumedSessionIsReplayedBitForBit) {
  ASSERT_NO_FATAL_FAILURE(end_early_by(SIGKILL, [&] { return has_events(events_ / 3); }));
  uninterrupted().finish(study_);
  const ProgramResult replayed =
      hall_.run({"study", "replay", study_.string(), "--participant", "P001"});
  EXPECT_EQ(replayed.exit_code, 0) << replayed.output << replayed.errors;
  const auto attempts = rows_of(study_,
                                "SELECT trial, attempt FROM film_hash JOIN session ON"
                                " session.id = session WHERE participant = 'P001'");
  ASSERT_TRUE(attempts);
  EXPECT_GE(attempts->size(), 4U) << "practice, two methods and a catch trial";
  std::size_t same = 0;
  for (std::size_t at = replayed.output.find("bit-identical"); at != std::string::npos;
       at = replayed.output.find("bit-identical", at + 1)) {
    ++same;
  }
  EXPECT_EQ(same, attempts->size()) << replayed.output;
}

TEST_F(Kill, ASessionOfAnotherSeedIsNotResumed) {
  ASSERT_NO_FATAL_FAILURE(end_early_by(SIGKILL, [&] { return has_events(5); }));
  std::vector<std::string> other = command(study_);
  *(std::find(other.begin(), other.end(), "--seed") + 1) = "12";
  const ProgramResult refused = hall_.run(other);
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.errors, AllOf(HasSubstr("unfinished session of P001"),
                                    HasSubstr("seed 11, not 12"), HasSubstr("--seed 11")));
}

}  // namespace
}  // namespace foveola::test
