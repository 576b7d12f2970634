#include "analysis/koskela2018/background.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "analysis/statistics/rank_correlation.h"
#include "renderer/base/error.h"

namespace foveola::analysis {
namespace {

bool is_five_point(double answer) {
  return answer >= 1.0 && answer <= 5.0 && answer == std::floor(answer);
}

/// The questions in the order of their first answers, each with whether it is on five points.
std::vector<std::pair<std::string, bool>> questions_of(
    const std::vector<BackgroundAnswer>& answers) {
  std::vector<std::pair<std::string, bool>> questions;
  for (const BackgroundAnswer& row : answers) {
    const auto known = std::find_if(questions.begin(), questions.end(), [&](const auto& question) {
      return question.first == row.question;
    });
    if (known == questions.end()) {
      questions.emplace_back(row.question, is_five_point(row.value));
    } else {
      known->second = known->second && is_five_point(row.value);
    }
  }
  return questions;
}

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

/// The mean of a participant's answers on the scale; empty if one was not given.
std::optional<double> background_of(const Answers& answers, const std::string& participant,
                                    const BackgroundScale& scale) {
  const auto given = answers.find(participant);
  if (given == answers.end()) {
    return std::nullopt;
  }
  std::vector<double> values;
  for (const std::string& question : scale.questions) {
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

/// The mean over complete scenes.
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

BackgroundCorrelation correlate_with_method(const Dataset& set, const Answers& answers,
                                            const BackgroundScale& scale, TimeSaved quantity,
                                            std::size_t mark, std::size_t method) {
  BackgroundCorrelation row{
      .quantity = quantity, .method = set.methods[method], .mark = set.measures[mark].id()};
  std::vector<double> background;
  std::vector<double> speed_ups;
  for (std::size_t participant = 0; participant < set.participants.size(); ++participant) {
    const auto experience = background_of(answers, set.participants[participant], scale);
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

BackgroundScale choose_background_scale(const std::vector<BackgroundAnswer>& answers) {
  const auto questions = questions_of(answers);
  const std::vector<std::string> published = {"graphics_3d", "offline_rendering"};
  const bool as_published =
      std::all_of(published.begin(), published.end(), [&](const std::string& id) {
        return std::any_of(questions.begin(), questions.end(),
                           [&](const auto& question) { return question.first == id; });
      });
  if (as_published) {
    return {published, true};
  }
  BackgroundScale scale;
  for (const auto& [question, five_point] : questions) {
    if (five_point && question != "gender") {
      scale.questions.push_back(question);
    }
  }
  std::sort(scale.questions.begin(), scale.questions.end());
  return scale;
}

std::vector<QuestionAnswers> describe_background(const Dataset& set,
                                                 const std::vector<BackgroundAnswer>& rows) {
  const Answers answers = answers_by_participant(rows);
  std::vector<QuestionAnswers> result;
  for (const auto& [question, five_point] : questions_of(rows)) {
    std::vector<double> values;
    for (const std::string& participant : set.participants) {
      const auto given = answers.find(participant);
      if (given != answers.end() && given->second.contains(question)) {
        values.push_back(given->second.at(question));
      }
    }
    result.push_back({question, describe(values), set.participants.size() - values.size()});
  }
  std::sort(result.begin(), result.end(), [](const QuestionAnswers& a, const QuestionAnswers& b) {
    return a.question < b.question;
  });
  return result;
}

std::vector<Exclusion> list_missing_answers(const Dataset& set,
                                            const std::vector<BackgroundAnswer>& rows,
                                            const BackgroundScale& scale) {
  const Answers answers = answers_by_participant(rows);
  std::vector<Exclusion> exclusions;
  for (const std::string& participant : set.participants) {
    if (!scale.questions.empty() && !background_of(answers, participant, scale)) {
      exclusions.push_back({participant, "", "", "background", "a question was not answered"});
    }
  }
  return exclusions;
}

std::vector<BackgroundCorrelation> correlate_background(const Dataset& set,
                                                        const std::vector<BackgroundAnswer>& rows,
                                                        const BackgroundScale& scale) {
  const Answers answers = answers_by_participant(rows);
  std::vector<BackgroundCorrelation> correlations;
  for (const TimeSaved quantity : {TimeSaved::log_ratio, TimeSaved::seconds_saved}) {
    for (const std::size_t mark : set.times()) {
      for (std::size_t method = baseline + 1; method < set.methods.size(); ++method) {
        correlations.push_back(correlate_with_method(set, answers, scale, quantity, mark, method));
      }
    }
  }
  return correlations;
}

Background analyse_background(const std::vector<BackgroundAnswer>& answers, Dataset& set) {
  const BackgroundScale scale = choose_background_scale(answers);
  Background background{scale, describe_background(set, answers),
                        correlate_background(set, answers, scale)};
  exclude(list_missing_answers(set, answers, scale), set);
  return background;
}

}  // namespace foveola::analysis
