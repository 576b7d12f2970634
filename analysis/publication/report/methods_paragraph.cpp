#include "analysis/publication/report/methods_paragraph.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/dataset/wording.h"
#include "analysis/koskela2018/profile.h"
#include "analysis/publication/data_quality/gaze_sources.h"

namespace foveola::analysis {
namespace {

using study::MeasureKind;

std::string measures_in_words(const Dataset& set) {
  std::vector<std::string> marks;
  for (const std::size_t mark : set.marks()) {
    marks.push_back(reason_for_mark(set, set.measures[mark]));
  }
  std::string text = fmt::format(", and marked when {}",
                                 fmt::join(marks, marks.size() == 2 ? " and when " : ", when "));
  std::vector<std::string> ratings;
  std::string amendments;
  for (std::size_t i = 0; i < set.measures.size(); ++i) {
    const Measure& measure = set.measures[i];
    if (measure.kind == MeasureKind::rating) {
      ratings.push_back(fmt::format("“{}” ({}: {})", measure.question.text, measure.id(),
                                    study::scale_in_words(measure)));
      amendments += amendments_of_scale(set, i);
    }
  }
  if (!ratings.empty()) {
    text += fmt::format("; then they rated {}", fmt::join(ratings, ", "));
  }
  return text + "." + amendments;
}

std::string questionnaires_in_words(const study::Protocol& protocol) {
  std::vector<std::string> forms;
  for (const study::Questionnaire& form : protocol.questionnaires) {
    forms.push_back(form.source.empty() ? form.id : fmt::format("{} ({})", form.id, form.source));
  }
  return forms.empty() ? "" : fmt::format(" They filled in {}.", fmt::join(forms, "; "));
}

std::string other_trials_in_words(const study::Protocol& protocol) {
  std::string text;
  if (!protocol.practice.empty()) {
    text += fmt::format(" {} before.",
                        protocol.practice.size() == 1
                            ? std::string("One practice trial came")
                            : fmt::format("{} practice trials came", protocol.practice.size()));
  }
  if (protocol.catch_trials.count > 0) {
    text += fmt::format(" Among the trials {}, in which nothing was rendered.",
                        protocol.catch_trials.count == 1
                            ? std::string("was one catch trial")
                            : fmt::format("were {} catch trials", protocol.catch_trials.count));
  }
  return text;
}

std::string orders_in_words(const study::Protocol& protocol) {
  return fmt::format(" The order of scenes was {}, that of methods within a scene {}.",
                     name_of(protocol.scene_order), name_of(protocol.method_order));
}

std::string apparatus_in_words(const study::StudyRecords& records) {
  std::string text = fmt::format(" Images of the whole sphere had {} × {} pixels.",
                                 records.protocol.film.width, records.protocol.film.height);
  if (!records.display_profile.empty()) {
    text += fmt::format(" The display was of profile {}{}.", records.display_profile,
                        records.tracker_profile.empty()
                            ? ""
                            : ", the eye tracker of profile " + records.tracker_profile);
  }
  return text + fmt::format(" The time-out of a mark was {:g} s; later marks are right-censored.",
                            records.protocol.timing.mark_timeout_s);
}

std::string gaze_in_words(const Dataset& set, const study::DataQualityRecords& quality) {
  const std::vector<GazeSource> sources = gaze_sources(set, quality.gaze);
  if (sources.empty()) {
    return "";
  }
  return sources.size() == 1 ? fmt::format(" Gaze came from {}.", gaze_sources_in_words(sources))
                             : fmt::format(" Gaze came from different sources: {}.",
                                           gaze_sources_in_words(sources));
}

/// The recorded equipment of people's sessions, without momentary speeds.
std::string setup_in_words(const Dataset& set, const study::DataQualityRecords& quality) {
  std::vector<study::SessionSetup> analysed = of_analysed(set, quality.setups);
  std::erase_if(analysed, [](const study::SessionSetup& row) { return row.kind == "simulated"; });
  std::vector<std::string> facts;
  for (const study::SetupSummary& fact : study::summarize_setups(analysed)) {
    if (fact.part != study::SetupPart::speed && fact.part != study::SetupPart::refreshes) {
      facts.push_back(fact.name + (fact.varies ? " (" + fact.words + ")" : " " + fact.words));
    }
  }
  return facts.empty() ? "" : fmt::format(" Sessions ran with {}.", fmt::join(facts, "; "));
}

/// The programs of the analysed sessions, and whether they differed.
std::string programs_in_words(const Dataset& set, const study::StudyRecords& records) {
  const std::vector<study::ProgramUse> uses =
      study::program_uses(of_analysed(set, records.programs));
  if (uses.empty()) {
    return "";
  }
  if (uses.size() == 1) {
    return fmt::format(" Sessions were run by {}.", uses.front().program);
  }
  std::vector<std::string> words;
  std::ranges::transform(uses, std::back_inserter(words), study::use_in_words);
  return fmt::format(" Sessions were run by different programs: {}.", fmt::join(words, "; "));
}

/// The measures whose primary analyses are of this kind, as the subject of a sentence: times,
/// ratings or both.
std::string compared_by(AnalysisKind kind, const Comparisons& comparisons) {
  bool times = false;
  bool ratings = false;
  for (const MethodComparison& row : comparisons.methods) {
    if (row.primary && row.primary->kind == kind &&
        (row.planned || comparisons.plan.primary.empty())) {
      (row.is_time ? times : ratings) = true;
    }
  }
  return times && ratings ? "Logarithms of times, and ratings,"
         : times          ? "Logarithms of times"
         : ratings        ? "Ratings"
                          : "";
}

std::string primary_in_words(const StudyTables& tables, const Comparisons& comparisons) {
  std::string text;
  const auto add = [&](AnalysisKind kind, const std::string& how) {
    if (const std::string what = compared_by(kind, comparisons); !what.empty()) {
      text += fmt::format(" {} were compared by {}.", what, how);
    }
  };
  add(AnalysisKind::crossed_model,
      "a mixed model with participants and scenes as crossed random effects, each with its own "
      "difference between the methods (restricted maximum likelihood, Satterthwaite’s degrees of "
      "freedom)");
  add(AnalysisKind::participant_t,
      fmt::format("a paired t test of the participants’ mean differences over the {}, whose "
                  "interval generalises to participants only, in these scenes",
                  count_with_noun(tables.set.scenes.size(), "scene")));
  add(AnalysisKind::tobit_model,
      fmt::format("a Tobit model where some were right-censored, with terms for participants and "
                  "scenes{}",
                  comparisons.plan.scenes == study::SceneEffects::random
                      ? " and a standard error by the mixed model of each pair’s influence on the "
                        "ratio, with participants and scenes as crossed random effects"
                      : ", a ratio for each scene and a standard error clustered by participant, "
                        "whose interval generalises to participants only, in these scenes"));
  add(AnalysisKind::ordinal_model,
      fmt::format(
          "a cumulative link mixed model with random effects of participants{} and of their "
          "differences between the methods, its P by the likelihood ratio and its interval by the "
          "profile likelihood, scaled as the standard error of a balanced linear model of the "
          "latent variable is",
          comparisons.plan.scenes == study::SceneEffects::random ? ", of scenes" : ""));
  add(AnalysisKind::signed_ranks,
      "Wilcoxon’s signed-rank test of the participants’ means, with Hodges and Lehmann’s estimate "
      "of the difference");
  if (!comparisons.models.versions.empty()) {
    std::vector<std::string> versions;
    for (const auto& [name, version] : comparisons.models.versions) {
      versions.push_back(fmt::format("{} {}", name, version));
    }
    text += fmt::format(" Models were fitted by {}.", comma_list(versions));
  }
  return text;
}

std::string analysis_in_words(const StudyTables& tables, const Comparisons& comparisons) {
  std::string text = primary_in_words(tables, comparisons);
  text += comparisons.plan.primary.empty()
              ? " No comparison was planned in the protocol; P-values are exploratory and not "
                "adjusted for their number."
              : fmt::format(
                    " {} planned before data were collected, with Holm’s adjustment at a "
                    "level of {:g}; all others are exploratory and not adjusted.",
                    comparisons.plan.primary.size() == 1
                        ? std::string("One comparison was")
                        : fmt::format("{} comparisons were", comparisons.plan.primary.size()),
                    comparisons.plan.alpha);
  const auto missing = static_cast<std::size_t>(std::ranges::count_if(
      comparisons.methods,
      [](const MethodComparison& row) { return row.planned && !row.missing.empty(); }));
  if (missing > 0) {
    text += fmt::format(
        " {} of those planned had no P-value and {} as not significant in the adjustment.", missing,
        missing == 1 ? "counts" : "count");
  }
  return text;
}

std::string exclusions_in_words(const StudyTables& tables) {
  std::map<std::string, std::size_t> sessions;
  std::size_t all = 0;
  for (const Exclusion& row : tables.set.exclusions) {
    if (row.scene.empty() && row.method.empty() && row.measure.empty()) {
      ++sessions[row.reason];
      ++all;
    }
  }
  if (all == 0) {
    return "";
  }
  std::vector<std::string> reasons;
  for (const auto& [reason, count] : sessions) {
    reasons.push_back(fmt::format("{}: {}", reason, count));
  }
  return fmt::format(
      " {} not analysed ({}).",
      all == 1 ? std::string("One session was") : fmt::format("{} sessions were", all),
      fmt::join(reasons, "; "));
}

std::string missing_ratings_in_words(const Dataset& set) {
  std::size_t ratings = 0;
  std::size_t missing = 0;
  for (std::size_t i = 0; i < set.values.size(); ++i) {
    if (set.measures[i % set.measures.size()].kind == MeasureKind::rating) {
      ++ratings;
      missing += set.values[i].state == Value::State::missing ? 1 : 0;
    }
  }
  return missing == 0 ? ""
                      : fmt::format(" Of {} ratings {} {} missing.", ratings, missing,
                                    missing == 1 ? "was" : "were");
}

/// Counts right-censored and missing times among those that were planned.
std::string gaps_in_words(const Dataset& set) {
  std::size_t times = 0;
  std::size_t censored = 0;
  std::size_t missing = 0;
  for (std::size_t trial = 0; trial < set.trials.size(); ++trial) {
    for (const std::size_t mark : set.marks()) {
      const Value::State state = set.values[trial * set.measures.size() + mark].state;
      ++times;
      censored += state == Value::State::right_censored ? 1 : 0;
      missing += state == Value::State::missing ? 1 : 0;
    }
  }
  return censored + missing == 0
             ? ""
             : fmt::format(" Of {} times {} {} right-censored and {} missing.", times, censored,
                           censored == 1 ? "was" : "were", missing);
}

std::string other_analyses_in_words(const Comparisons& comparisons) {
  const auto any = [&](auto has) { return std::ranges::any_of(comparisons.methods, has); };
  const auto any_omnibus = [&](auto has) { return std::ranges::any_of(comparisons.omnibus, has); };
  std::string text;
  if (any([](const MethodComparison& row) { return row.equivalent.has_value(); })) {
    text += fmt::format(
        " Equivalence within the protocol’s margins was tested by two one-sided tests of the "
        "primary analysis with {:g} % intervals, those of planned comparisons with Holm’s "
        "adjustment of their own.",
        100.0 * (1.0 - 2.0 * comparisons.plan.alpha));
  }
  std::vector<std::string> done;
  const auto add = [&](bool was_done, const char* what) {
    if (was_done) {
      done.emplace_back(what);
    }
  };
  add(any([](const MethodComparison& row) { return row.ratio.has_value(); }),
      "paired t tests over participants of log times, of all pairs and of complete cases");
  add(any([](const MethodComparison& row) { return row.ratio_bca.has_value(); }),
      "bootstrap intervals (BCa)");
  add(any([](const MethodComparison& row) { return row.ranks.has_value(); }),
      "Wilcoxon’s signed-rank tests with Hodges and Lehmann’s estimates");
  add(any_omnibus([](const OmnibusTest& row) { return row.variance.has_value(); }),
      "repeated-measures analyses of variance of log times (Greenhouse and Geisser’s correction)");
  add(any_omnibus([](const OmnibusTest& row) { return row.ranks.has_value(); }),
      "Friedman’s tests");
  add(std::ranges::any_of(comparisons.order,
                          [](const OrderTest& row) { return row.change_per_step.has_value(); }),
      "trends over trials and over the order of methods");
  add(any([](const MethodComparison& row) { return row.planned && row.influence.has_value(); }),
      "the planned estimates without each participant in turn");
  return done.empty()
             ? text
             : text + fmt::format(" As sensitivity analyses there are {}.", comma_list(done));
}

std::string amendments_in_words(const StudyTables& tables) {
  std::size_t analysed = 0;
  std::set<std::string> keys;
  for (const AmendedSession& session : tables.amended) {
    if (session.is_analysed) {
      ++analysed;
      keys.insert(session.changed_keys.begin(), session.changed_keys.end());
    }
  }
  if (analysed == 0) {
    return "";
  }
  return fmt::format(
      " {} of the {} followed a protocol that was amended after the study had begun ({}).",
      analysed, count_with_noun(tables.set.participants.size(), "analysed session"),
      keys.empty() ? std::string("comments or spaces only")
                   : "changed: " + comma_list({keys.begin(), keys.end()}));
}

}  // namespace

std::string methods_paragraph(const StudyTables& tables, const Comparisons& comparisons,
                              const study::StudyRecords& records,
                              const study::DataQualityRecords& quality) {
  const std::string warning = data_warning(tables);
  std::string text = warning.empty() ? "" : warning + " ";
  text += fmt::format(
      "{} saw {} ({}), each with {} ({}) of progressive path tracing",
      participants_in_words(tables), count_with_noun(tables.set.scenes.size(), "scene"),
      comma_list(tables.set.scenes), count_with_noun(tables.set.methods.size(), "preview"),
      comma_list(tables.set.methods));
  return text + measures_in_words(tables.set) + orders_in_words(records.protocol) +
         other_trials_in_words(records.protocol) + questionnaires_in_words(records.protocol) +
         apparatus_in_words(records) + gaze_in_words(tables.set, quality) +
         setup_in_words(tables.set, quality) + programs_in_words(tables.set, records) +
         amendments_in_words(tables) + exclusions_in_words(tables) + gaps_in_words(tables.set) +
         missing_ratings_in_words(tables.set) + analysis_in_words(tables, comparisons) +
         other_analyses_in_words(comparisons);
}

}  // namespace foveola::analysis
