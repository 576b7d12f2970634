// The experimenter's console as lines, for people (and for files and pipes) or for machines.
#pragma once

#include <optional>

#include "study/console/console.h"
#include "study/console/line_reader.h"
#include "study/console/line_writer.h"

namespace foveola::study {

/// Lines of text. Of the status, only new warnings are printed.
class LineConsole final : public Console {
 public:
  /// writer must outlive it. input: descriptor of the commands; -1: none.
  LineConsole(LineWriter& writer, int input) : writer_(writer), reader_(input) {}

  void say(const std::string& text) override { writer_.write(text); }
  void tell(const ToldEvent& event) override;
  void show(const SessionStatus& status) override;
  std::vector<std::string> take_commands() override { return reader_.take_lines(); }

 private:
  LineWriter& writer_;
  LineReader reader_;
  std::vector<StatusWarning> warnings_;
};

/// "   12.345 s  outline was marked after 3.214 s."
std::string line_of(const ToldEvent& event);

/// A JSON object per line. Its "kind" is text, event, or status. The status is written every
/// second, and at once with a new warning. Commands are those of LineConsole.
class JsonConsole final : public Console {
 public:
  /// As for LineConsole.
  JsonConsole(LineWriter& writer, int input) : writer_(writer), reader_(input) {}

  void say(const std::string& text) override;
  void tell(const ToldEvent& event) override;
  void show(const SessionStatus& status) override;
  std::vector<std::string> take_commands() override { return reader_.take_lines(); }

 private:
  LineWriter& writer_;
  LineReader reader_;
  std::optional<Nanoseconds> shown_;  ///< time of the last written status
  std::vector<StatusWarning> warnings_;
};

nlohmann::ordered_json json_of(const ToldEvent& event);

/// Returns a single line, whatever bytes its texts have.
std::string json_line(const char* kind, const nlohmann::ordered_json& members);

}  // namespace foveola::study
