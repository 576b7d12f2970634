#include "study/person/changed_setup.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/base/error.h"

namespace foveola::study {
namespace {

bool is_demanded(SetupPart part, const PreflightGate& gate) {
  switch (part) {
    case SetupPart::display:
      return gate.same_display;
    case SetupPart::machine:
    case SetupPart::speed:
      return gate.same_machine;
    case SetupPart::refreshes:
    case SetupPart::program:
    case SetupPart::other:
      break;
  }
  return false;
}

}  // namespace

SetupChanges setup_changes(const std::vector<SessionSetup>& sessions,
                           const std::string& participant, const std::string& now,
                           const PreflightGate& gate) {
  SetupChanges changes;
  const auto own = std::ranges::find(sessions, participant, &SessionSetup::participant);
  const bool is_continued = own != sessions.end();
  std::set<std::string> named;
  const auto compare = [&](const SessionSetup& session) {
    for (const SetupDifference& found : setup_differences(session.devices.back(), now)) {
      if (!named.insert(found.name).second) {
        continue;
      }
      const bool depends_on_moment =
          found.part == SetupPart::speed || found.part == SetupPart::refreshes;
      const bool must_be_same =
          is_demanded(found.part, gate) || (is_continued && !depends_on_moment);
      (must_be_same ? changes.demanded : changes.others)
          .push_back(fmt::format("{} {} ({}: {})", found.name, found.now,
                                 is_continued ? "before" : session.participant, found.before));
    }
  };
  if (is_continued) {
    compare(*own);
    return changes;
  }
  for (const SessionSetup& session : sessions) {
    if (session.kind == "human") {
      compare(session);
    }
  }
  return changes;
}

void require_same_setup(const SetupChanges& changes, const std::string& participant) {
  if (!changes.demanded.empty()) {
    throw Error("participant " + participant,
                fmt::format("would have other equipment: {}", fmt::join(changes.demanded, "; ")),
                "restore it, or accept it by --despite-changes, which the record notes");
  }
}

std::string note_of_changes(const std::vector<std::string>& changes) {
  return fmt::format("despite changes: {}", fmt::join(changes, "; "));
}

}  // namespace foveola::study
