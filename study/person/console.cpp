#include "study/person/console.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

namespace foveola::study {
namespace {

struct CommandWord {
  std::string_view word;
  ConsoleAction action;
  std::string_view argument;  ///< empty: it takes none
  std::string_view help;
};

constexpr std::array words = {
    CommandWord{"state", ConsoleAction::state, "", "where the session is"},
    CommandWord{"next", ConsoleAction::next, "", "what comes then"},
    CommandWord{"note", ConsoleAction::note, "TEXT", "keeps a note in the record"},
    CommandWord{"pause", ConsoleAction::pause, "",
                "a trial that has begun is timed again after it"},
    CommandWord{"resume", ConsoleAction::resume, "", "after a pause"},
    CommandWord{"retime", ConsoleAction::retime, "", "the timing failed: times the method again"},
    CommandWord{"exclude", ConsoleAction::exclude, "REASON", "ends the session; its data stay"},
    CommandWord{"withdraw", ConsoleAction::withdraw, "", "the participant stops taking part"},
    CommandWord{"quit", ConsoleAction::quit, "", "interrupts; --resume goes on later"},
    CommandWord{"help", ConsoleAction::help, "", "these lines"},
};

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blank = " \t\r";
  const std::size_t begin = text.find_first_not_of(blank);
  if (begin == std::string_view::npos) {
    return {};
  }
  return text.substr(begin, text.find_last_not_of(blank) + 1 - begin);
}

}  // namespace

std::optional<ConsoleCommand> parse_console_line(std::string_view line) {
  const std::string_view command = trimmed(line);
  const std::size_t gap = std::min(command.find_first_of(" \t"), command.size());
  const std::string_view word = command.substr(0, gap);
  const std::string_view text = trimmed(command.substr(gap));
  const auto* const known = std::find_if(words.begin(), words.end(),
                                         [&](const CommandWord& one) { return one.word == word; });
  const bool is_whole = known != words.end() && known->argument.empty() == text.empty();
  return is_whole
             ? std::optional(ConsoleCommand{.action = known->action, .text = std::string(text)})
             : std::nullopt;
}

std::string console_help() {
  std::string help;
  for (const CommandWord& one : words) {
    help += fmt::format("  {:<16}{}\n", fmt::format("{} {}", one.word, one.argument), one.help);
  }
  return help;
}

ConsoleLines::ConsoleLines(int descriptor)
    : thread_([this, descriptor](const std::stop_token& stop) { read(descriptor, stop); }) {}

std::vector<std::string> ConsoleLines::take() {
  const std::scoped_lock lock(mutex_);
  return std::exchange(lines_, {});
}

void ConsoleLines::read(int descriptor, const std::stop_token& stop) {
  constexpr int patience_ms = 50;
  std::array<char, 4096> bytes{};
  while (!stop.stop_requested()) {
    pollfd input{.fd = descriptor, .events = POLLIN, .revents = 0};
    if (::poll(&input, 1, patience_ms) <= 0) {
      continue;
    }
    const ssize_t count = ::read(descriptor, bytes.data(), bytes.size());
    if (count <= 0) {
      return;
    }
    keep({bytes.data(), static_cast<std::size_t>(count)});
  }
}

void ConsoleLines::keep(std::string_view bytes) {
  unfinished_ += bytes;
  for (std::size_t end = unfinished_.find('\n'); end != std::string::npos;
       end = unfinished_.find('\n')) {
    const std::scoped_lock lock(mutex_);
    lines_.push_back(unfinished_.substr(0, end));
    unfinished_.erase(0, end + 1);
  }
}

}  // namespace foveola::study
