#include "analysis/koskela2018/background.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <fmt/format.h>

#include "renderer/base/error.h"

namespace foveola::analysis {
namespace {

/// [participant code][question id]
using Answers = std::map<std::string, std::map<std::string, double>>;

Answers answers_by_participant(const std::vector<BackgroundAnswer>& rows) {
  Answers answers;
  for (const BackgroundAnswer& row : rows) {
    if (!std::isfinite(row.value)) {
      throw Error(
          fmt::format("participant {}, background question {}", row.participant, row.question),
          "has an answer that is not a number", "correct the record");
    }
    answers[row.participant][row.question] = row.value;
  }
  return answers;
}

/// Returns the mean of a participant's answers on the scale; empty if one was not given.
std::optional<double> background_of(const Answers& answers, const std::string& participant,
                                    const std::vector<std::string>& scale) {
  const auto given = answers.find(participant);
  if (given == answers.end()) {
    return std::nullopt;
  }
  std::vector<double> values;
  for (const std::string& question : scale) {
    const auto answer = given->second.find(question);
    if (answer == given->second.end()) {
      return std::nullopt;
    }
    values.push_back(answer->second);
  }
  return mean(values);
}

double speed_up(TimeSaved quantity, double baseline_s, double method_s) {
  return quantity == TimeSaved::log_ratio ? std::log(baseline_s) - std::log(method_s)
                                          : baseline_s - method_s;
}

std::optional<double> mean_speed_up(const Dataset& set, std::size_t participant,
                                    const BackgroundCorrelation& row, std::size_t mark,
                                    std::size_t method) {
  std::vector<double> of_scenes;
  for (std::size_t scene = 0; scene < set.scenes.size(); ++scene) {
    if (set.is_complete(participant, scene, mark)) {
      of_scenes.push_back(speed_up(row.quantity,
                                   set.value(participant, scene, baseline, mark).number,
                                   set.value(participant, scene, method, mark).number));
    }
  }
  return mean(of_scenes);
}

struct TimesOfMethod {
  std::size_t mark = 0;
  std::size_t method = 0;
};

/// Returns the first planned comparison of times with the baseline, in either direction.
std::optional<TimesOfMethod> first_planned_times(const Dataset& set,
                                                 const study::AnalysisPlan& plan) {
  for (const study::PlannedComparison& planned : plan.primary) {
    const auto measure = set.measure_named(planned.measure);
    const auto a = position_of(set.methods, planned.method);
    const auto b = position_of(set.methods, planned.baseline);
    if (measure && a && b && set.measures[*measure].kind == MeasureKind::time &&
        std::min(*a, *b) == baseline) {
      return TimesOfMethod{*measure, std::max(*a, *b)};
    }
  }
  return std::nullopt;
}

void exclude_without_answers(const Answers& answers, const std::vector<std::string>& scale,
                             Dataset& set) {
  std::vector<Exclusion> exclusions;
  for (const std::string& participant : set.participants) {
    if (!background_of(answers, participant, scale)) {
      exclusions.push_back({participant, "", "", "background", "a question was not answered"});
    }
  }
  exclude(exclusions, set);
}

}  // namespace

const char* name_of(TimeSaved quantity) {
  return quantity == TimeSaved::log_ratio ? "log_ratio" : "seconds_saved";
}

std::vector<BackgroundAnswer> answers_in_numbers(const study::StudyRecords& records,
                                                 const std::string& questionnaire) {
  std::vector<BackgroundAnswer> answers;
  for (const study::AnswerRow& row : records.answers) {
    if (row.value.is_measured() && records.questionnaire_of(row) == questionnaire) {
      answers.push_back(
          {records.sessions[row.session].participant, records.question_of(row), row.value.number});
    }
  }
  return answers;
}

std::vector<BackgroundAnswer> background_answers(const study::StudyRecords& records) {
  return answers_in_numbers(records, "background");
}

std::vector<QuestionAnswers> describe_background(const Dataset& set,
                                                 const std::vector<BackgroundAnswer>& rows) {
  const Answers answers = answers_by_participant(rows);
  std::set<std::string> questions;
  for (const BackgroundAnswer& row : rows) {
    questions.insert(row.question);
  }
  std::vector<QuestionAnswers> result;
  for (const std::string& question : questions) {
    std::vector<double> values;
    for (const std::string& participant : set.participants) {
      const auto given = answers.find(participant);
      if (given != answers.end() && given->second.contains(question)) {
        values.push_back(given->second.at(question));
      }
    }
    result.push_back({question, describe(values), set.participants.size() - values.size()});
  }
  return result;
}

BackgroundCorrelation correlate_background(const Dataset& set,
                                           const std::vector<BackgroundAnswer>& rows,
                                           const std::vector<std::string>& questions,
                                           TimeSaved quantity, std::size_t mark,
                                           std::size_t method) {
  const Answers answers = answers_by_participant(rows);
  BackgroundCorrelation row{
      .quantity = quantity, .method = set.methods[method], .mark = set.measures[mark].id()};
  std::vector<double> background;
  std::vector<double> speed_ups;
  for (std::size_t participant = 0; participant < set.participants.size(); ++participant) {
    const auto experience = background_of(answers, set.participants[participant], questions);
    const auto found = mean_speed_up(set, participant, row, mark, method);
    if (experience && found) {
      background.push_back(*experience);
      speed_ups.push_back(*found);
    }
  }
  row.participants = background.size();
  row.pearson = pearson(background, speed_ups);
  row.spearman = spearman(background, speed_ups);
  return row;
}

Background analyse_background(const std::vector<BackgroundAnswer>& answers,
                              const study::AnalysisPlan& plan, Dataset& set) {
  Background background{.scale = plan.background, .answers = describe_background(set, answers)};
  if (plan.background.empty()) {
    return background;
  }
  if (const std::optional<TimesOfMethod> times = first_planned_times(set, plan)) {
    background.correlation = correlate_background(set, answers, plan.background,
                                                  TimeSaved::log_ratio, times->mark, times->method);
  }
  exclude_without_answers(answers_by_participant(answers), plan.background, set);
  return background;
}

}  // namespace foveola::analysis
