#include <chrono>
#include <cstdio>
#include <memory>
#include <thread>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/base/error.h"
#include "renderer/base/text/print.h"
#include "renderer/base/text/utf8.h"
#include "study/commands/command_line.h"
#include "study/commands/commands.h"
#include "study/console/console_words.h"
#include "study/console/line_console.h"
#include "study/record/log/event_log.h"
#include "study/record/read/recorded_session.h"
#include "study/record/read/study_records.h"
#include "study/record/setup/session_devices.h"

namespace foveola::study {
namespace {

using namespace std::chrono_literals;

/// Maximum delay of an event for a watcher, at negligible cost to its writer.
constexpr std::chrono::milliseconds poll_interval = 500ms;

struct WatchArguments {
  std::string database;
  std::string participant;
  bool json = false;
};

/// Returns the last participant who began. Throws Error if there is none.
std::string newest_participant(const StudyRecords& records, const std::string& database) {
  if (records.sessions.empty()) {
    throw Error(database, "has no session yet", "begin one with foveola study run");
  }
  return records.sessions.back().participant;
}

class Watch {
 public:
  Watch(const WatchArguments& arguments, const Protocol& protocol, std::string participant)
      : arguments_(arguments), protocol_(protocol), participant_(std::move(participant)) {}

  /// Prints new events. Returns whether the session can still continue.
  bool print_new_events() {
    const RecordedSession session = read_session(arguments_.database, participant_);
    const Plan told_plan =
        is_experimenter_blind(session.known.devices) ? without_methods(session.plan) : session.plan;
    SessionState state;
    std::size_t count = 0;
    for_each_step(
        session.procedure, session.events, participant_,
        [&](const LoggedEvent& logged, const SessionState& /*before*/, const SessionState& after) {
          state = after;
          if (++count > told_) {
            tell_of(logged, after);
          }
        });
    if (count > told_ && !arguments_.json) {
      say(printable(fmt::format("           now {}; then {}",
                                words_for(state, session.procedure, told_plan),
                                words_for_next(state, session.procedure, told_plan))));
    }
    told_ = count;
    return !state.is_over();
  }

 private:
  void tell_of(const LoggedEvent& logged, const SessionState& after) const {
    const ToldEvent told{.time = logged.time,
                         .name = name_of(logged.event),
                         .phase = name_of(after.phase),
                         .words = words_for(logged.event, after, protocol_)};
    if (arguments_.json) {
      nlohmann::ordered_json json = {{"participant", participant_}, {"utc", logged.utc}};
      json.update(json_of(told));
      say(json_line("event", json));
    } else {
      say(line_of(told));
    }
  }

  static void say(const std::string& line) {
    print_text("{}\n", line);
    std::fflush(stdout);
  }

  const WatchArguments& arguments_;
  const Protocol& protocol_;
  std::string participant_;
  std::size_t told_ = 0;  ///< number of printed events
};

void run_watch(const WatchArguments& arguments, const std::stop_token& stop) {
  const StudyRecords records = read_study(arguments.database);
  Watch watch(arguments, records.protocol,
              arguments.participant.empty() ? newest_participant(records, arguments.database)
                                            : arguments.participant);
  while (watch.print_new_events() && !stop.stop_requested()) {
    std::this_thread::sleep_for(poll_interval);
  }
}

}  // namespace

void add_watch(CLI::App& study, const std::stop_token& stop) {
  const auto arguments = std::make_shared<WatchArguments>();
  CLI::App* command = add_command(
      study, "watch", "Follow a running session, without touching its file", "watch study.sqlite");
  add_database(command, arguments->database);
  command->add_option("--participant", arguments->participant,
                      "The participant's code (default: the last one begun)");
  add_json_option(*command, arguments->json);
  command->callback([arguments, stop] { run_watch(*arguments, stop); });
}

}  // namespace foveola::study
