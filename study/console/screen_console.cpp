#include "study/console/screen_console.h"

#include <algorithm>
#include <chrono>
#include <sstream>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include "renderer/base/text/utf8.h"
#include "study/console/console_command.h"
#include "study/console/line_console.h"

namespace foveola::study {
namespace {

std::unique_ptr<Console> lines(bool is_json, LineWriter& output, int input) {
  if (is_json) {
    return std::make_unique<JsonConsole>(output, input);
  }
  return std::make_unique<LineConsole>(output, input);
}

bool may_be_pasted(const std::string& line) {
  const std::optional<ConsoleCommand> command = parse_console_line(line);
  return command && command->action == ConsoleAction::note;
}

}  // namespace

std::unique_ptr<ScreenConsole> ScreenConsole::open(LineWriter& afterwards) {
  if (!Terminal::is_there()) {
    return nullptr;
  }
  std::unique_ptr<ScreenConsole> console(new ScreenConsole(afterwards));
  return console->wait_until_open() ? std::move(console) : nullptr;
}

ScreenConsole::ScreenConsole(LineWriter& afterwards)
    : afterwards_(afterwards), thread_([this](const std::stop_token& stop) { run(stop); }) {}

ScreenConsole::~ScreenConsole() {
  thread_.request_stop();
  thread_.join();
  afterwards_.write(fmt::format("{}", fmt::join(said_, "\n")));
}

bool ScreenConsole::wait_until_open() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return has_tried_; });
  return is_open_;
}

void ScreenConsole::say(const std::string& text) {
  std::istringstream lines(text);
  const std::scoped_lock lock(mutex_);
  for (std::string line; std::getline(lines, line);) {
    said_.push_back(printable(line));
  }
  is_to_paint_ = true;
}

void ScreenConsole::tell(const ToldEvent& event) { say(line_of(event)); }

void ScreenConsole::show(const SessionStatus& status) {
  const std::scoped_lock lock(mutex_);
  status_ = status;
  is_to_paint_ = true;
}

std::vector<std::string> ScreenConsole::take_commands() {
  const std::scoped_lock lock(mutex_);
  return std::exchange(asked_for_, {});
}

void ScreenConsole::run(const std::stop_token& stop) {
  constexpr std::chrono::milliseconds moment(50);
  Terminal terminal;
  {
    const std::scoped_lock lock(mutex_);
    has_tried_ = true;
    is_open_ = terminal.is_open();
  }
  changed_.notify_all();
  while (terminal.is_open() && !stop.stop_requested() && terminal.wait(moment)) {
    follow_keys(terminal);
    paint(terminal);
  }
}

void ScreenConsole::follow_keys(Terminal& terminal) {
  for (const TypedKey& key : terminal.keys()) {
    follow(key);
  }
}

void ScreenConsole::follow(const TypedKey& key) {
  const std::scoped_lock lock(mutex_);
  is_to_paint_ = true;
  std::optional<EnteredLine> line = entry_.follow(key);
  if (!line) {
    return;
  }
  if (line->is_pasted && !may_be_pasted(line->text)) {
    said_.push_back(
        printable(fmt::format("'{}' was pasted; type commands, paste only notes", line->text)));
  } else {
    asked_for_.push_back(std::move(line->text));
  }
}

void ScreenConsole::paint(Terminal& terminal) {
  const bool is_resized = terminal.has_new_size();
  if (!terminal.send()) {
    return;
  }
  SessionStatus status;
  std::vector<std::string> said;
  std::string typed;
  {
    const std::scoped_lock lock(mutex_);
    if (!std::exchange(is_to_paint_, false) && !is_resized) {
      return;
    }
    status = status_;
    const auto newest = static_cast<std::ptrdiff_t>(std::min(said_.size(), terminal.size().rows));
    said.assign(said_.end() - newest, said_.end());
    typed = entry_.typed();
  }
  terminal.paint(lay_out_screen({.status = status, .said = said, .typed = typed}, terminal.size()));
}

std::unique_ptr<Console> open_console(bool is_json, LineWriter& output) {
  if (is_json) {
    return lines(is_json, output, STDIN_FILENO);
  }
  if (std::unique_ptr<Console> screen = ScreenConsole::open(output)) {
    return screen;
  }
  output.write("Type help for a list of commands.");
  return lines(is_json, output, STDIN_FILENO);
}

std::unique_ptr<Console> open_output(bool is_json, LineWriter& output) {
  constexpr int no_input = -1;
  return lines(is_json, output, no_input);
}

}  // namespace foveola::study
