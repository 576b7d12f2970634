#include "analysis/dataset/answer_data.h"

#include <cstdint>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "analysis/dataset/scoring.h"
#include "analysis/dataset/session_columns.h"
#include "analysis/statistics/descriptive.h"

namespace foveola::analysis {
namespace {

using study::StudyRecords;

/// A question of a questionnaire with numeric answers, in the protocol's order.
struct NumericQuestion {
  std::string questionnaire;
  std::string question;
  std::string text;
  std::string scale;
};

std::vector<NumericQuestion> numeric_questions(const StudyRecords& records) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> in_numbers;
  for (const study::AnswerRow& row : records.answers) {
    if (row.value.is_measured()) {
      in_numbers.emplace(row.questionnaire, row.question);
    }
  }
  std::set<std::pair<std::string, std::string>> answered;
  for (const auto& [questionnaire, question] : in_numbers) {
    answered.emplace(records.words[questionnaire], records.words[question]);
  }
  std::vector<NumericQuestion> questions;
  for (const study::Questionnaire& questionnaire : records.protocol.questionnaires) {
    for (const Measure& measure : study::measures_of(questionnaire)) {
      if (answered.erase({questionnaire.id, measure.id()}) > 0) {
        questions.push_back({questionnaire.id, measure.id(), measure.question.text,
                             study::scale_in_words(measure)});
      }
    }
  }
  // Questions of amended protocols, which the study's own lacks.
  for (const auto& [questionnaire, question] : answered) {
    questions.push_back({questionnaire, question,
                         fmt::format("The answer to {} of {}, which the study's own protocol lacks",
                                     question, questionnaire),
                         ""});
  }
  return questions;
}

/// [question][participant of the set]: the last numeric answer.
using NumericAnswers = std::vector<std::vector<std::optional<double>>>;

NumericAnswers numeric_answers(const StudyRecords& records, const Dataset& set,
                               const std::vector<NumericQuestion>& questions) {
  std::map<std::pair<std::string, std::string>, std::size_t> indices;
  for (const NumericQuestion& question : questions) {
    indices.emplace(std::pair(question.questionnaire, question.question), indices.size());
  }
  const auto participants = analysed_sessions(records, set);
  NumericAnswers answers(questions.size());
  for (std::vector<std::optional<double>>& given : answers) {
    given.resize(set.participants.size());
  }
  for (const study::AnswerRow& row : records.answers) {
    if (const auto& participant = participants[row.session];
        participant && row.value.is_measured()) {
      answers[indices.at({records.questionnaire_of(row), records.question_of(row)})][*participant] =
          row.value.number;
    }
  }
  return answers;
}

struct DescribedQuestion {
  NumericQuestion question;
  Description answers;
  std::size_t missing = 0;
};

}  // namespace

ColumnsOf<study::AnswerRow> answer_columns(const StudyRecords& records, const Dataset& set) {
  using study::AnswerRow;
  using study::SessionRow;
  const auto session = [&records](const AnswerRow& row) -> const SessionRow& {
    return records.sessions[row.session];
  };
  // [questionnaire, question]
  std::map<std::pair<std::string, std::string>, Measure> asked;
  for (const study::Questionnaire& questionnaire : records.protocol.questionnaires) {
    for (Measure& measure : study::measures_of(questionnaire)) {
      asked[{questionnaire.id, measure.id()}] = std::move(measure);
    }
  }
  const auto question = [&records, asked = std::move(asked)](const AnswerRow& row) {
    const auto known = asked.find({records.questionnaire_of(row), records.question_of(row)});
    return known == asked.end() ? nullptr : &known->second;
  };
  const auto words = [&records, question](const AnswerRow& row) {
    const Measure* as_asked = question(row);
    const std::string found = !row.value.is_measured() ? records.words[row.value.words]
                              : as_asked != nullptr    ? as_asked->label_of(row.value.number)
                                                       : "";
    return found.empty() ? std::nullopt : std::optional(found);
  };
  return {{"participant", "", code_meaning, path(session, &SessionRow::participant)},
          {"session_state", "", state_meaning, path(session, &SessionRow::state)},
          {"status", "", session_status_meaning,
           [&records, analysed = analysed_sessions(records, set)](const AnswerRow& row) {
             return status_of(records.sessions[row.session], analysed[row.session].has_value());
           }},
          {"status_reason", "", reason_meaning, path(session, reason_in(set))},
          {"questionnaire", "", "Id of the questionnaire",
           [&records](const AnswerRow& row) { return records.questionnaire_of(row); }},
          {"step", "", step_meaning, &AnswerRow::step},
          {"question", "", "Id of the question",
           [&records](const AnswerRow& row) { return records.question_of(row); }},
          {"number", "", "Numeric answer, in points of scale; empty if the answer is not a number",
           [](const AnswerRow& row) {
             return row.value.is_measured() ? std::optional(row.value.number) : std::nullopt;
           }},
          {"text", "", "Answer as text, or the protocol's label of the number", words},
          {"question_text", "", "Text of the question in the protocol",
           path(question, &Measure::question, &study::Question::text)},
          {"scale", "", "Scale in words: its ends and their labels",
           path(question, [](const Measure& as_asked) { return study::scale_in_words(as_asked); })},
          {"response_s", "s",
           "Time from the question's display to its answer; empty if it was not measured",
           &AnswerRow::response_s},
          {kind_column(), path(session, &SessionRow::kind)},
          {record_column(), [&set](const AnswerRow& /*row*/) { return set.record; }}};
}

ColumnsOf<std::size_t> participant_answer_columns(const StudyRecords& records, const Dataset& set) {
  const std::vector<NumericQuestion> questions = numeric_questions(records);
  NumericAnswers answers = numeric_answers(records, set, questions);
  ColumnsOf<std::size_t> columns;
  for (std::size_t i = 0; i < questions.size(); ++i) {
    const NumericQuestion& question = questions[i];
    columns.push_back(
        {fmt::format("{}.{}", question.questionnaire, question.question), "",
         question.scale.empty() ? question.text
                                : fmt::format("{} Answers: {}", question.text, question.scale),
         [given = std::move(answers[i])](std::size_t participant) { return given[participant]; }});
  }
  return columns;
}

Table answers_by_question(const StudyRecords& records, const Dataset& set) {
  const std::vector<NumericQuestion> questions = numeric_questions(records);
  const NumericAnswers answers = numeric_answers(records, set, questions);
  std::vector<DescribedQuestion> rows;
  for (std::size_t i = 0; i < questions.size(); ++i) {
    std::vector<double> values;
    for (const std::optional<double>& given : answers[i]) {
      if (given) {
        values.push_back(*given);
      }
    }
    rows.push_back({questions[i], describe(values), set.participants.size() - values.size()});
  }
  using Q = DescribedQuestion;
  const ColumnsOf<Q> columns = {
      {"questionnaire", "", "Id of the questionnaire",
       path(&Q::question, &NumericQuestion::questionnaire)},
      {"question", "", "Id of the question", path(&Q::question, &NumericQuestion::question)},
      {"scale", "", "Scale in words: its ends and their labels",
       path(&Q::question, &NumericQuestion::scale)},
      {"n", "", "Number of analysed participants with a numeric answer",
       path(&Q::answers, &Description::n)},
      {"mean", "", "Mean of the answers", path(&Q::answers, &Description::mean)},
      {"sd", "", "Standard deviation of the answers",
       path(&Q::answers, &Description::standard_deviation)},
      {"median", "", "Median of the numeric answers of the analysed participants",
       path(&Q::answers, &Description::median)},
      {"missing", "", "Number of analysed participants without a numeric answer", &Q::missing},
      {kind_column(), [&](const Q& /*row*/) { return set.kind; }}};
  return tabulate("answers_by_question", "question with numeric answers", columns, rows);
}

Table questionnaire_scores(const StudyRecords& records, const Dataset& set) {
  using S = ScoreRow;
  const std::vector<std::optional<std::size_t>> analysed = analysed_sessions(records, set);
  const ColumnsOf<S> columns = {
      {"participant", "", "Code of the participant", &S::participant},
      {"status", "", session_status_meaning,
       [&](const S& row) {
         return status_of(records.sessions[row.session], analysed[row.session].has_value());
       }},
      {"questionnaire", "", "Id of the questionnaire", &S::questionnaire},
      {"step", "", step_meaning, &S::step},
      {"instrument", "",
       "Published instrument: SSQ (Kennedy et al. 1993), NASA-TLX (Hart 2006) or SUS (Brooke "
       "1996)",
       &S::instrument},
      {"score", "", "Name of the score", &S::score},
      {"value", "", "Score by its published key; empty if an item has no answer", &S::value},
      {kind_column(), [&](const S& row) { return records.sessions[row.session].kind; }}};
  return tabulate("questionnaire_scores", "score of a completed questionnaire", columns,
                  score_questionnaires(records));
}

}  // namespace foveola::analysis
