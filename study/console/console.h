// The experimenter's console: shows a session, and takes commands.
#pragma once

#include <string>
#include <vector>

#include "renderer/base/clock.h"
#include "study/console/session_status.h"

namespace foveola::study {

/// A recorded event, told to the experimenter.
struct ToldEvent {
  Nanoseconds time{0};  ///< session clock
  std::string name;     ///< as recorded: "marked"
  std::string phase;    ///< phase after the event
  std::string words;    ///< "outline was marked after 3.214 s."
};

/// No function waits for the terminal.
class Console {
 public:
  virtual ~Console() = default;

  /// Prints one or more sentences.
  virtual void say(const std::string& text) = 0;
  virtual void tell(const ToldEvent& event) = 0;
  /// Shows the session's status. Call several times a second.
  virtual void show(const SessionStatus& status) = 0;
  /// Returns the commands since the last call, in order, as lines of parse_console_line().
  virtual std::vector<std::string> take_commands() = 0;
};

/// A console without an experimenter.
class SilentConsole final : public Console {
 public:
  void say(const std::string& /*text*/) override {}
  void tell(const ToldEvent& /*event*/) override {}
  void show(const SessionStatus& /*status*/) override {}
  std::vector<std::string> take_commands() override { return {}; }
};

}  // namespace foveola::study
