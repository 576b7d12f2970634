// Other programs at the files of a running session: those that read the study, those that take its
// log away, and commands that were told to write where they read.
//
// FOVEOLA_KILLS=1000 kills so many sessions instead of a few.
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>
#include <random>
#include <set>
#include <thread>

#include <fmt/format.h>
#include <sqlite3.h>

#include "renderer/base/files/files.h"
#include "study/record/maintain/maintenance.h"
#include "tests/end_to_end/render/rendered_room.h"
#include "tests/end_to_end/run/study_run.h"
#include "tests/end_to_end/tracker_profile.h"
#include "tests/file_locks.h"
#include "tests/matchers.h"

namespace fs = std::filesystem;

namespace foveola::test {
namespace {

/// Consent and two trials.
constexpr const char* two_trials_keys = R"(
methods = ["od", "fv"]
phases = ["consent", "trials"]
)";

/// A page of the session, and the event that is recorded before it comes.
struct SessionMoment {
  std::string page;
  std::string event;
};
const std::vector<SessionMoment> moments = {
    {"consent", "session_started"}, {"marking", "trial_started"}, {"ready", "rated"},
    {"paused", "pause_requested"},  {"completed", "rated"},       {"backup", "rated"}};

class RunWithNeighbours : public StudyRun {
 protected:
  RunWithNeighbours() {
    participant_.write_protocol(two_trials_keys,
                                std::string("[texts]\nconsent = \"Agreed?\"\n") + short_look);
  }

  void begin(int participant) {
    participant_.seat(fmt::format("P{}", participant));
    participant_.begin();
    participant_.answer_page("Return");  // welcome
    EXPECT_EQ(participant_.wait_for_page(), "consent");
  }
  /// From a page of `moments` to the next.
  void go_on_from(const std::string& page) {
    if (page == "consent") {
      participant_.type_all({"Return", "Down", "Return"});
      participant_.answer_page("Return");  // choosing
      participant_.answer_page("space");   // ready
      EXPECT_EQ(participant_.wait_for_page(), "marking");
    } else if (page == "marking") {
      mark_and_rate();
      EXPECT_EQ(participant_.wait_for_page(), "ready");
    } else if (page == "ready") {
      participant_.type("Escape");
      EXPECT_EQ(participant_.wait_for_page(), "paused");
    } else if (page == "paused") {
      participant_.type("space");
      participant_.answer_page("space");  // ready
      participant_.wait_for_page();
      mark_and_rate();
      EXPECT_EQ(participant_.wait_for_page(), "completed");
    } else {
      participant_.type("Return");  // the backup
    }
  }
  /// Returns once it was acknowledged.
  void note(const std::string& text) {
    participant_.program().type_line("note " + text);
    participant_.program().wait_for("Note: " + text);
  }
  /// Of a page, unless the session is over by then.
  void note_at(const std::string& page) {
    if (page != "completed") {
      note(page);
    }
  }
  /// Both marks, from the page that waits for the first.
  void mark_and_rate() {
    participant_.type("space");
    participant_.answer_page("space");
    participant_.wait_for_page();
    rate("3");
  }

  fs::path study() const { return participant_.database(); }
  bool is_locked() { return is_locked_by(participant_.program().process(), study()); }
  /// Some tenths of a second.
  void make_the_backup_last() {
    for (int i = 0; i < 10; ++i) {
      participant_.program().type_line("note " + std::string(2'000'000, 'x'));
    }
    participant_.program().wait_for("Note: x");
  }
  /// Whether a copy is being made.
  bool is_backing_up() const {
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(study().string() + ".backups", ignored)) {
      if (entry.path().filename().string().starts_with(".")) {
        return true;
      }
    }
    return false;
  }
};

/// SQLite's own program and Python's read a study in turn, at any moment, in a thread.
class Readers {
 public:
  explicit Readers(const fs::path& study)
      : thread_([this, study](const std::stop_token& stop) {
          while (!stop.stop_requested()) {
            read(study);
            std::this_thread::sleep_for(std::chrono::milliseconds(pause_ms_(random_)));
          }
        }) {}
  int times() const { return times_; }

 private:
  void read(const fs::path& study) {
    const std::string python =
        "import sqlite3, sys; c = sqlite3.connect(sys.argv[1]);"
        " print(c.execute('SELECT count(*) FROM event').fetchone()); c.close()";
    const std::string command =
        times_ % 2 == 0 ? fmt::format("sqlite3 '{}' .dump >/dev/null", study.string())
                        : fmt::format("python3 -c \"{}\" '{}' >/dev/null", python, study.string());
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    ++times_;
  }

  std::atomic<int> times_ = 0;
  std::mt19937 random_{2018};
  std::uniform_int_distribution<int> pause_ms_{0, 300};
  std::jthread thread_;
};

TEST_F(RunWithNeighbours, TheStudyIsLockedInEveryPhase) {
  begin(1);
  for (const SessionMoment& moment : moments) {
    if (moment.page != "backup") {
      EXPECT_TRUE(is_locked()) << moment.page;
      note_at(moment.page);
      EXPECT_TRUE(is_locked()) << moment.page << ", after another event";
      if (moment.page == "paused") {
        make_the_backup_last();
      }
      go_on_from(moment.page);
    }
  }
  int seen = 0;
  while (!participant_.program().has_ended()) {
    // Between two looks at the copy there was one.
    if (is_backing_up()) {
      const bool is_locked_meanwhile = is_locked();
      if (is_backing_up()) {
        EXPECT_TRUE(is_locked_meanwhile);
        ++seen;
      }
    }
  }
  EXPECT_GT(seen, 0) << "the backup was over too soon";
}

TEST_F(RunWithNeighbours, WhatOtherProgramsReadIsNotLostByAKill) {
  const char* const asked = std::getenv("FOVEOLA_KILLS");
  const int kills = asked != nullptr ? std::stoi(asked) : static_cast<int>(moments.size());
  std::mt19937 random(2018);
  std::uniform_int_distribution<int> moment_ms(0, 100);
  std::set<std::string> acknowledged;
  std::map<std::string, int> killed;
  int reads = 0;
  for (int i = 0; i < kills; ++i) {
    const SessionMoment& moment = moments[static_cast<std::size_t>(i) % moments.size()];
    begin(i);
    const Readers readers(study());
    std::string page = "consent";
    for (std::size_t next = 1; page != moment.page; ++next) {
      note_at(page);
      go_on_from(page);
      page = moments[next].page;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(moment_ms(random)));
    const Rows log = log_of(study());
    participant_.program().kill(SIGKILL);
    acknowledged.insert(log.begin(), log.end());
    killed[moment.page] += participant_.program().wait_for_end() == 128 + SIGKILL ? 1 : 0;
    reads += readers.times();
    const std::string of_participant =
        fmt::format(" JOIN session ON session.id = session WHERE participant = 'P{}'", i);
    EXPECT_THAT(participant_.ask("SELECT type FROM event" + of_participant), Contains(moment.event))
        << moment.page;
    EXPECT_THAT(log_of(study()), IsSupersetOf(acknowledged)) << moment.page;
    EXPECT_THAT(study::verify_study(study()).faults, IsEmpty()) << moment.page;
  }
  for (const auto& [page, times] : killed) {
    std::cout << page << ": " << times << " kills\n";
  }
  std::cout << reads << " reads by others, " << acknowledged.size() << " events acknowledged\n";
}

TEST_F(RunWithNeighbours, AnothersLockIsWaitedForAndSaid) {
  begin(1);
  sqlite3* other = nullptr;
  ASSERT_EQ(sqlite3_open(study().c_str(), &other), SQLITE_OK);
  ASSERT_EQ(sqlite3_exec(other, "BEGIN IMMEDIATE", nullptr, nullptr, nullptr), SQLITE_OK);
  participant_.type_all({"Return", "Down", "Return"});
  participant_.program().wait_for("another program has locked it");
  std::this_thread::sleep_for(std::chrono::seconds(5));  // SQLite's programs wait for as long
  EXPECT_EQ(sqlite3_exec(other, "COMMIT", nullptr, nullptr, nullptr), SQLITE_OK);
  sqlite3_close(other);
  EXPECT_EQ(participant_.wait_for_page(), "choosing_object");
  note("after");
  participant_.quit();
  EXPECT_THAT(study::verify_study(study()).faults, IsEmpty());
}

class OutputsApart : public Render {};

TEST_F(OutputsApart, NoCommandWritesOverWhatItReads) {
  const std::string study = (folder_ / "study.sqlite").string();
  const std::string scene = (folder_ / "room.gltf").string();
  write_file(study, "a study");
  const std::string link = (folder_ / "link.sqlite").string();
  fs::create_hard_link(study, link);
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {"study", "gaze", study, "--participant", "P1", "--trial", "0", "-o", study},
           {"study", "gaze", study, "--participant", "P1", "--trial", "0", "-o", link},
           {"study", "gaze", study, "--participant", "P1", "--trial", "0", "-o", study + "-wal"},
           {"study", "run", "demo", "--db", study, "--participant", "P1", "--receipt", study},
           {"study", "run", "demo", "--db", study, "--participant", "P1", "--receipt",
            study + ".controller"},
           {"study", "run", "demo", "--db", study, "--participant", "P1", "--screens",
            study + ".backups"},
           {"study", "merge", study, "-o", study + "-journal"},
           {"analyze", study, "-o", study + ".backups"},
           {"render", scene, "-o", scene},
           {"render", scene, "-o", (folder_ / "x.png").string(), "--view", scene}}) {
    SCOPED_TRACE(fmt::format("{} {}", arguments[0], arguments.back()));
    const auto before = folder_.content();
    const ProgramResult result = run_foveola(arguments);
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.errors, HasSubstr("name another file"));
    EXPECT_TRUE(folder_.content() == before);
  }
}

/// A room whose wall has a texture, and whose buffer lies in a file.
std::string room_of_files() {
  std::string room = replaced(room_gltf(), "\"materials\":[",
                              "\"images\":[{\"uri\":\"texture.png\"},{\"uri\":\"unused.png\"}],"
                              "\"textures\":[{\"source\":0}],\"materials\":[");
  room = replaced(room, "\"metallicFactor\":0",
                  "\"metallicFactor\":0,\"baseColorTexture\":{\"index\":0}");
  const std::size_t begin = room.find("data:application");
  return room.replace(begin, room.find('"', begin) - begin, "buffer.film");
}

TEST_F(OutputsApart, NoCommandWritesOverWhatItsInputsName) {
  const auto write = [&](const std::string& name, const std::string& content) {
    return folder_.write(name, content).string();
  };
  const auto path = [&](const char* name) { return (folder_ / name).string(); };
  const std::string room = write("files.gltf", room_of_files());
  for (const char* name : {"texture.png", "unused.png", "mask.png", "wall.png"}) {
    write(name, name);
  }
  write("buffer.film", std::string(228, '\0'));
  fs::create_hard_link(path("texture.png"), path("hard.png"));
  fs::create_symlink("texture.png", path("soft.png"));
  const std::string wall = write("wall.obj",
                                 "mtllib wall.mtl\nv 0 0 -1\nv 1 0 -1\nv 0 1 -1\n"
                                 "usemtl wall\nf 1 2 3\n");
  write("wall.mtl", "newmtl wall\nmap_Kd wall.png\n");
  write("gaze.csv", "time_ns,x,y,z,valid\n0,0,0,-1,1\n");
  write("form.toml", "title = \"A form\"\n[[question]]\n" + std::string(age_question));
  write("camera.toml", tracker_profile("recorded", 60) + "recording = \"gaze.csv\"\n");
  const std::string protocol = write("study.toml", R"(
name = "study"
title = "A study"
scenes = ["room.gltf"]
methods = ["od", "fv"]
phases = ["form", "trials"]
[tracker]
profile = "camera.toml"
[[questionnaire]]
id = "form"
file = "form.toml"
)");
  const auto run_with_receipt = [&](const char* name) {
    return std::vector<std::string>{"study",         "run", protocol,   "--db",      path("new"),
                                    "--participant", "P1",  "--resume", "--receipt", path(name)};
  };
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {"render", room, "-o", path("texture.png")},
           {"render", room, "-o", path("hard.png")},
           {"render", room, "-o", path("soft.png")},
           {"render", room, "-o", path("unused.png")},
           {"render", room, "-o", path("buffer.film"), "--spp", "1"},
           {"render", room, "-o", path("x.png"), "--view", path("texture.png")},
           {"render", wall, "-o", path("wall.png")},
           {"render", path("room.gltf"), "--method", "mask:file=" + path("mask.png"), "-o",
            path("mask.png")},
           run_with_receipt("room.gltf"),
           run_with_receipt("camera.toml"),
           run_with_receipt("form.toml")}) {
    SCOPED_TRACE(fmt::format("{} {}", arguments[0], arguments.back()));
    const auto before = folder_.content();
    const ProgramResult result = run_foveola(arguments);
    EXPECT_NE(result.exit_code, 0);
    EXPECT_THAT(result.errors,
                AllOf(HasSubstr("is read by the command, too"), HasSubstr("name another file")));
    EXPECT_TRUE(folder_.content() == before);
  }
  succeeded(render("room.png", {"--spp", "1", "--size", "16x8"}));
  EXPECT_EQ(render("room.png", {"--spp", "1", "--size", "16x8"}).exit_code, 0) << "once more";
}

}  // namespace
}  // namespace foveola::test
