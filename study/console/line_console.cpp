#include "study/console/line_console.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/base/text/utf8.h"

namespace foveola::study {

void LineConsole::tell(const ToldEvent& event) { writer_.write(line_of(event)); }

void LineConsole::show(const SessionStatus& status) {
  for (const StatusWarning& warning : new_warnings(warnings_, status.warnings)) {
    writer_.write(warning.text);
  }
  warnings_ = status.warnings;
}

std::string line_of(const ToldEvent& event) {
  return fmt::format("{:9.3f} s  {}", seconds(event.time), printable(event.words));
}

void JsonConsole::say(const std::string& text) {
  writer_.write(json_line("text", {{"text", text}}));
}

void JsonConsole::tell(const ToldEvent& event) {
  writer_.write(json_line("event", json_of(event)));
}

void JsonConsole::show(const SessionStatus& status) {
  constexpr Nanoseconds interval = std::chrono::seconds(1);
  if (shown_ && status.time - *shown_ < interval &&
      new_warnings(warnings_, status.warnings).empty()) {
    return;
  }
  shown_ = status.time;
  warnings_ = status.warnings;
  writer_.write(json_line("status", json_of(status)));
}

nlohmann::ordered_json json_of(const ToldEvent& event) {
  return {{"time_s", seconds(event.time)},
          {"event", event.name},
          {"phase", event.phase},
          {"words", event.words}};
}

std::string json_line(const char* kind, const nlohmann::ordered_json& members) {
  nlohmann::ordered_json line = {{"kind", kind}};
  line.update(members);
  return line.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace foveola::study
