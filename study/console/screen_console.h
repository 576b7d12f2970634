// The experimenter's console as a full screen of the terminal.
#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "study/console/console.h"
#include "study/console/line_writer.h"
#include "study/console/screen_layout.h"
#include "study/console/terminal.h"

namespace foveola::study {

/// Paints and reads keys in a thread of its own. At its end the terminal is restored, and shows the
/// session's messages as LineConsole would have written them.
class ScreenConsole final : public Console {
 public:
  /// Returns null unless standard input and output are a terminal that can be painted on. Nothing
  /// else may write or read there during the console's lifetime. afterwards: for standard output;
  /// must outlive it.
  static std::unique_ptr<ScreenConsole> open(LineWriter& afterwards);
  ~ScreenConsole() override;
  ScreenConsole(const ScreenConsole&) = delete;
  ScreenConsole& operator=(const ScreenConsole&) = delete;

  void say(const std::string& text) override;
  void tell(const ToldEvent& event) override;
  void show(const SessionStatus& status) override;
  std::vector<std::string> take_commands() override;

 private:
  explicit ScreenConsole(LineWriter& afterwards);
  /// Returns whether the terminal could be opened.
  bool wait_until_open();
  void run(const std::stop_token& stop);
  void follow_keys(Terminal& terminal);
  void follow(const TypedKey& key);
  void paint(Terminal& terminal);

  LineWriter& afterwards_;
  std::mutex mutex_;
  std::condition_variable changed_;
  SessionStatus status_;
  std::vector<std::string> said_;
  CommandEntry entry_;
  std::vector<std::string> asked_for_;
  bool is_to_paint_ = true;
  bool has_tried_ = false;  ///< whether opening the terminal was tried
  bool is_open_ = false;
  std::jthread thread_;
};

/// Returns a console on standard output. output must outlive it. is_json: JSON lines. Otherwise a
/// screen if input and output are a terminal that can be painted on, or else lines, of which the
/// first explains the commands.
std::unique_ptr<Console> open_console(bool is_json, LineWriter& output);

/// Returns a console without commands, for messages before and after a session: lines, or JSON.
std::unique_ptr<Console> open_output(bool is_json, LineWriter& output);

}  // namespace foveola::study
