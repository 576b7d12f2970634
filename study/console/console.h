// The experimenter's side of a session: what it tells them, and what they ask of it.
#pragma once

#include <string>
#include <vector>

#include "renderer/base/clock.h"
#include "study/console/session_status.h"

namespace foveola::study {

/// An event that is in the record.
struct ToldEvent {
  Nanoseconds time{0};  ///< session clock
  std::string name;     ///< as the record has it: "marked"
  std::string phase;    ///< that it led to
  std::string words;    ///< "outline was marked after 3.214 s."
};

/// All of it returns at once, whatever becomes of the terminal.
class Console {
 public:
  virtual ~Console() = default;

  /// A sentence, or several lines of them.
  virtual void say(const std::string& text) = 0;
  virtual void tell(const ToldEvent& event) = 0;
  /// How the session stands now. To be called several times a second.
  virtual void show(const SessionStatus& status) = 0;
  /// What was asked for since the last call, in order: lines of parse_console_line().
  virtual std::vector<std::string> take() = 0;
};

/// For a session that nobody watches.
class SilentConsole final : public Console {
 public:
  void say(const std::string& /*text*/) override {}
  void tell(const ToldEvent& /*event*/) override {}
  void show(const SessionStatus& /*status*/) override {}
  std::vector<std::string> take() override { return {}; }
};

}  // namespace foveola::study
