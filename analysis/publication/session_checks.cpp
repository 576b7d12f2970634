#include "analysis/publication/session_checks.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "analysis/dataset/wording.h"
#include "analysis/publication/gaze_by_trial.h"
#include "renderer/base/utf8.h"

namespace foveola::analysis {
namespace {

/// Those of the analysed participants.
std::vector<study::SessionCourse> analysed_courses(
    const Dataset& set, const std::vector<study::SessionCourse>& courses) {
  std::vector<study::SessionCourse> analysed;
  std::ranges::copy_if(
      courses, std::back_inserter(analysed), [&](const study::SessionCourse& course) {
        return std::ranges::find(set.participants, course.participant) != set.participants.end();
      });
  return analysed;
}

/// All participants with what was found of them, or "none".
std::string all_in_words(const std::vector<std::string>& findings) {
  return findings.empty() ? "none" : fmt::format("{}", fmt::join(findings, "; "));
}

DataQualityCheck check_cut_off(const std::vector<study::SessionCourse>& courses) {
  DataQualityCheck check{"Sessions that were cut off", "no sessions recorded", "none, ours"};
  if (courses.empty()) {
    return check;
  }
  std::vector<std::string> cut_off;
  for (const study::SessionCourse& course : courses) {
    if (course.interruptions > 0) {
      cut_off.push_back(fmt::format("{}: {}, {} lost", course.participant,
                                    counted(course.interruptions, "time"),
                                    counted(course.attempts_lost, "attempt")));
    }
  }
  check.found = all_in_words(cut_off);
  check.verdict = within(cut_off.empty());
  return check;
}

DataQualityCheck check_notes(const std::vector<study::SessionCourse>& courses) {
  constexpr std::size_t most_characters = 80;
  DataQualityCheck check{"Notes in the sessions’ records", "no sessions recorded",
                         "none but those of routine, ours"};
  if (courses.empty()) {
    return check;
  }
  std::vector<std::string> noted;
  for (const study::SessionCourse& course : courses) {
    if (!course.notes.empty()) {
      const std::size_t others = course.notes.size() - 1;
      noted.push_back(fmt::format("{}: {}{}", course.participant,
                                  beginning_of(course.notes.front(), most_characters),
                                  others == 0 ? "" : fmt::format(" (and {} more)", others)));
    }
  }
  check.found = all_in_words(noted);
  check.verdict = within(noted.empty());
  return check;
}

/// How a trial's timings that do not count ended, but for those that an interruption ended.
using EarlierOutcomes = std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::string>>;

/// By session and trial.
EarlierOutcomes earlier_outcomes(const study::StudyRecords& records) {
  EarlierOutcomes outcomes;
  for (const study::TrialRow& row : records.trials) {
    const std::string& outcome = records.words[row.outcome];
    if (!row.counts && outcome != "interrupted") {
      outcomes[{row.session, row.trial}].push_back(outcome);
    }
  }
  return outcomes;
}

DataQualityCheck check_timed_again(const Dataset& set, const study::StudyRecords& records) {
  const EarlierOutcomes earlier = earlier_outcomes(records);
  const std::vector<std::size_t> trials = analysed_trials(records, set);
  std::vector<Finding> again;
  for (const std::size_t i : trials) {
    const study::TrialRow& row = records.trials[i];
    if (const auto found = earlier.find({row.session, row.trial}); found != earlier.end()) {
      const std::string& participant = records.participant_of(row);
      again.push_back(
          {participant, fmt::format("{}, {}, {} ({})", participant, records.scenes[row.scene],
                                    records.methods[row.method], listed(found->second))});
    }
  }
  return {"Trials timed again",
          fmt::format("{} of {}{}", again.size(), counted(trials.size(), "trial"),
                      colon_and_findings(again)),
          "none but after an interruption, ours", within(again.empty())};
}

/// Times depend on the renderer.
DataQualityCheck check_programs(const Dataset& set,
                                const std::vector<study::SessionPrograms>& sessions) {
  DataQualityCheck check{"Programs that ran the sessions", "no programs recorded",
                         "one, of one version and built with the same tools, ours"};
  std::vector<study::SessionPrograms> analysed;
  std::ranges::copy_if(
      sessions, std::back_inserter(analysed), [&](const study::SessionPrograms& session) {
        return std::ranges::find(set.participants, session.participant) != set.participants.end();
      });
  const std::vector<study::ProgramUse> uses = study::program_uses(analysed);
  if (uses.empty()) {
    return check;
  }
  std::vector<std::string> words;
  std::ranges::transform(uses, std::back_inserter(words), study::use_in_words);
  for (const study::SessionPrograms& session : analysed) {
    if (session.programs.size() > 1) {
      words.push_back(
          fmt::format("{} by {}", session.participant, study::programs_in_words(session.programs)));
    }
  }
  check.found = fmt::format("{}", fmt::join(words, "; "));
  check.verdict = within(uses.size() == 1);
  return check;
}

DataQualityCheck check_setups(const Dataset& set, std::vector<study::SessionSetup> sessions) {
  std::erase_if(sessions, [&](const study::SessionSetup& session) {
    return std::ranges::find(set.participants, session.participant) == set.participants.end();
  });
  const std::vector<std::string> varying = study::varying_setup(sessions);
  return {"Displays, machines and trackers",
          varying.empty() ? "the same for everybody, as far as recorded" : all_in_words(varying),
          "the same for everybody, ours", within(varying.empty())};
}

}  // namespace

std::vector<DataQualityCheck> check_sessions(const Dataset& set, const study::StudyRecords& records,
                                             const study::DataQualityRecords& quality) {
  const std::vector<study::SessionCourse> analysed = analysed_courses(set, quality.courses);
  return {check_cut_off(analysed), check_timed_again(set, records), check_notes(analysed),
          check_programs(set, records.programs), check_setups(set, quality.setups)};
}

}  // namespace foveola::analysis
