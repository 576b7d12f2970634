// A participant in front of `foveola study run`, on a display without a screen, whose hands are the
// test's; and the experimenter's console.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tests/end_to_end/hall.h"
#include "tests/end_to_end/running_program.h"
#include "tests/end_to_end/study_rows.h"
#include "tests/x_server.h"

namespace foveola::test {

/// When a key went down, in seconds of the session's clock.
struct KeyPress {
  double asked_s = 0.0;    ///< the X server was about to be asked for it
  double taken_s = 0.0;    ///< the X server had said that it had done it
  double stamped_s = 0.0;  ///< the X server's own time then, whole milliseconds of this machine's
};

/// The study is called keys and its only scene hall, which offers a wall, ahead, and a lamp.
class SeatedParticipant {
 public:
  SeatedParticipant();

  /// keys and tables: of the protocol's TOML, beside its name, scenes and orders.
  void write_protocol(const std::string& keys, const std::string& tables) const;

  /// What the monitor's profile says that it has: a frame has as long to be in time.
  void set_refresh_rate(int hz) const;

  /// Another participant takes the seat, which at first is P1's.
  void seat(std::string participant) { code_ = std::move(participant); }

  /// Of the windows that open from now on.
  void set_window(std::string size) { window_ = std::move(size); }

  /// Starts the program for the participant, with more options if there are any, and waits until
  /// the session has begun.
  void begin(const std::vector<std::string>& options = {});

  /// Makes a process that is at a terminal the program for the participant.
  std::function<int()> at_terminal() const;

  /// Waits until the next page that the participant comes to stands, and returns the session's
  /// phase. Throws std::runtime_error if it never does.
  std::string wait_for_page();

  /// The picture of the page that was waited for last.
  std::filesystem::path picture() const;

  /// Waits until the signal of the reaction test, which lights the whole page, has been seen for as
  /// long as anybody needs to react.
  void wait_for_signal();

  /// Windows are managed from now on: see WindowManager.
  void manage_windows(const std::string& name) { manager_.emplace(name, server_.display()); }

  /// Presses a key and lets it go.
  KeyPress type(const std::string& key);
  void type_all(const std::vector<std::string>& keys);
  /// Moves the pointer to a place in the window, from its top left corner.
  void point_at(int x, int y);
  /// Keys go to another program's window, or to the participant's again.
  void focus_elsewhere() { user_->focus_elsewhere(); }
  void focus_window() { user_->focus("Foveola"); }
  void minimise() { user_->say_minimised("Foveola", true); }

  /// Presses `key` once the next page stands.
  void answer_page(const std::string& key);
  /// From the welcome, by the choice of the object ahead, to the question whether to start.
  void begin_trials();

  RunningProgram& program() { return *program_; }
  /// The experimenter ends the program.
  void quit();
  const TemporaryFolder& folder() const { return hall_.folder; }
  /// Renames another file into the place of the scene's.
  void replace_scene(const std::string& glb) const;
  std::filesystem::path database() const { return database_; }
  void keep_study_in(const std::filesystem::path& folder) { database_ = folder / "study.sqlite"; }
  /// The X server crashes. Nobody can press keys from then on.
  void take_display_away();

  /// Another run of the command, to its end.
  ProgramResult run_besides(const std::string& participant,
                            const std::vector<std::string>& options) const;
  /// `study replay` of the session.
  ProgramResult replay() const;
  /// `study status` of the database.
  ProgramResult status() const;

  void expect_no_fault() const;
  /// The rows of a query of the database.
  Rows ask(const std::string& sql) const { return all_rows_of(database(), sql); }

 private:
  /// The program's arguments.
  std::vector<std::string> command() const;

  XServer server_;
  std::optional<WindowManager> manager_;
  std::optional<XUser> user_{std::in_place, server_.display()};
  Hall hall_;
  std::filesystem::path database_ = hall_.folder / "study.sqlite";
  std::string code_ = "P1";
  std::string window_ = "640x480";
  std::unique_ptr<RunningProgram> program_;
  std::filesystem::path screens_;  ///< a picture of each page
  int runs_ = 0;
  int pages_ = 0;
  double zero_s_ = 0.0;  ///< the monotonic clock's time at which the session's is 0
};

}  // namespace foveola::test
