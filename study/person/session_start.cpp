#include "study/person/session_start.h"

#include <algorithm>
#include <random>
#include <vector>

#include <fmt/format.h>
#include <strings.h>
#include <unistd.h>

#include "renderer/base/error.h"
#include "study/console/line_reader.h"
#include "study/design/plan.h"
#include "study/person/forms/words.h"

namespace foveola::study {
namespace {

/// Design rows of people whose sessions are complete or can still be completed.
std::vector<int> used_rows(const StudyStore& store) {
  std::vector<int> rows;
  for (const KnownSession& session : store.sessions()) {
    const bool counts = session.phase != Phase::withdrawn && session.phase != Phase::excluded &&
                        session.phase != Phase::refused;
    if (session.kind == SessionKind::human && counts) {
      rows.push_back(session.design_row);
    }
  }
  return rows;
}

/// Design row of the study's first person; 0 if there is none.
int first_row_of(const StudyStore& store) {
  for (const KnownSession& session : store.sessions()) {
    if (session.kind == SessionKind::human) {
      return session.design_row;
    }
  }
  return 0;
}

}  // namespace

std::uint64_t draw_seed() {
  std::random_device device;
  const std::uint64_t high = device();
  const std::uint64_t low = device();
  return ((high << 32) | low) >> 1;
}

int next_design_row(const Protocol& protocol, const StudyStore& store,
                    const std::optional<int>& first_row) {
  return least_used_row(protocol, used_rows(store), first_row.value_or(first_row_of(store)));
}

void say_if_keys_are_late(KeyTimeSource source, Console& console) {
  if (source == KeyTimeSource::arrival) {
    console.say(
        "The X server's clock is not this machine's: marks have the times at which their keys "
        "arrived.");
  }
}

void say_if_code_is_alike(const std::string& participant, const StudyStore& store,
                          Console& console) {
  for (const KnownSession& session : store.sessions()) {
    const std::string& known = session.participant;
    if (known != participant && ::strcasecmp(known.c_str(), participant.c_str()) == 0) {
      console.say(fmt::format("WARNING: {} is another participant than {}, who is in this study.",
                              participant, known));
    }
  }
}

void wait_for_confirmation(SessionDisplay& display, const Texts& texts, Console& console,
                           const std::stop_token& stop) {
  console.say("Press Enter here to begin. Ctrl+C ends the program, and nothing is begun.");
  const auto is_confirmed = [](const std::vector<std::string>& lines) {
    return std::ranges::find(lines, "") != lines.end();
  };
  for (LineReader reader(STDIN_FILENO); !is_confirmed(reader.take_lines());) {
    if (stop.stop_requested()) {
      throw Error("preflight", "was stopped", "nothing was begun or recorded");
    }
    display.show({.screen = notice_screen(Notice::loading, texts)});
  }
}

}  // namespace foveola::study
