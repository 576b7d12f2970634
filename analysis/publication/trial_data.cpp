#include "analysis/publication/trial_data.h"

#include <set>
#include <utility>

#include <fmt/format.h>

#include "analysis/dataset/wording.h"
#include "analysis/publication/result_tables.h"

namespace foveola::analysis {
namespace {

using study::StudyRecords;
using study::TrialRow;
using enum ColumnType;

void append_value(const StudyRecords& records, const Measure& measure, const Value& value,
                  Row& row) {
  if (measure.is_time()) {
    const bool is_known = value.state != Value::State::missing;
    row.push_back(is_known ? field(value.number) : Field());
    row.push_back(is_known ? field(value.state == Value::State::right_censored) : Field());
  } else if (value.state == Value::State::in_words) {
    row.push_back(field(records.words[value.words]));
  } else {
    row.push_back(value.is_measured() ? field(value.number) : Field());
  }
}

constexpr const char* session_status_meaning =
    "analysed; or why the session is not: excluded, withdrawn (with --withdrawn only), "
    "interrupted, "
    "refused, or of another kind (other kind)";

/// "analysed", or why the session is not.
std::string status_of(const study::SessionRow& session, bool is_analysed) {
  if (is_analysed) {
    return "analysed";
  }
  return session.state == "completed" ? "other kind" : end_of(session);
}

std::string status_of(const TrialRow& row, const study::SessionRow& session, bool is_analysed) {
  if (row.kind != study::TrialKind::test) {
    return name_of(row.kind);
  }
  return is_analysed && !row.counts ? "timed again" : status_of(session, is_analysed);
}

Field reason_in_field(const study::SessionRow& session, const Dataset& set) {
  const std::string reason = reason_not_analysed(session, set.kind);
  return reason.empty() ? Field() : field(reason);
}

Column participant_column() { return {"participant", text, "", "Code of the participant"}; }

Column state_column() {
  return {"session_state", text, "",
          "The session's recorded state: completed, excluded, withdrawn, refused by the protocol's "
          "gate, or, of a session that has not ended, the state that it was left in"};
}

Column reason_column() {
  return {"status_reason", text, "",
          "Why the session is not analysed, with the reason that was recorded; empty for one that "
          "is"};
}

/// A question of a questionnaire that has answers in numbers, in the protocol's order.
struct NumericQuestion {
  std::string questionnaire;
  std::string question;
  std::string text;
  std::string scale;
};

/// The texts of the questions that somebody answered in numbers.
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
  // Those of amended protocols, which the study's own does not have.
  for (const auto& [questionnaire, question] : answered) {
    questions.push_back(
        {questionnaire, question,
         fmt::format("The answer to {} of {}, which the study's own protocol does not have",
                     question, questionnaire),
         ""});
  }
  return questions;
}

/// [question][participant of the set]: the last answer that is a number.
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

std::vector<Column> columns_of(const Measure& measure, const std::string& scale_in_words) {
  const std::string& id = measure.id();
  if (measure.is_time()) {
    return {{id + "_s", number, "s",
             measure.kind == MeasureKind::time
                 ? fmt::format("From the first presented frame to the mark {}", id)
                 : measure.question.text},
            {id + "_censored", truth, "",
             fmt::format("True: right-censored, {}_s is a lower bound", id)}};
  }
  const std::string description =
      fmt::format("{} Answers: {}", measure.question.text, scale_in_words);
  return {{id + "_rating",
           !measure.is_numeric()                                  ? text
           : measure.question.kind == study::QuestionKind::likert ? whole
                                                                  : number,
           measure.unit(), description}};
}

TrialColumns::TrialColumns(const StudyRecords& records, const Dataset& set,
                           std::span<const study::AttemptGazeRow> gaze)
    : records_(records),
      set_(set),
      gaze_(records, gaze),
      participants_(analysed_sessions(records, set)) {
  columns_ = {
      participant_column(),
      kind_column(),
      state_column(),
      {"status", text, "",
       "analysed, the rows that every result is of; or why a row is in none: practice, catch, "
       "timed again, or its session was excluded, withdrawn (with --withdrawn only), interrupted "
       "or refused, or is of another kind (other kind: see status_reason)"},
      reason_column(),
      {"scene", text, "", "Name of the scene"},
      {"method", text, "", "How samples were placed: od, vp, fv or another sampler"},
      {"trial", whole, "", "Place among all of the session's trials as planned, from 0"},
      {"trial_kind", text, "", "test, practice, or catch: nothing was rendered"},
      {"trial_position", whole, "", "Place among the session's test trials as planned, from 0"},
      {"method_position", whole, "", "Place among the methods in the scene, from 0"},
      {"attempt", whole, "", "Which timing it is, from 1; 0: never begun"},
      {"object", text, "", "The chosen object"},
      {"outcome", text, "", "How the attempt ended, as rated or retimed"}};
  for (std::size_t i = 0; i < set.measures.size(); ++i) {
    const std::vector<Column> own = columns_of(set.measures[i], scale_with_amendments(set, i));
    columns_.insert(columns_.end(), own.begin(), own.end());
  }
  const std::vector<Column> of_gaze = gaze_columns(set.measures);
  columns_.insert(columns_.end(), of_gaze.begin(), of_gaze.end());
  columns_.push_back(record_column());
}

Row TrialColumns::row(std::size_t trial) const {
  const TrialRow& row = records_.trials[trial];
  const study::SessionRow& session = records_.sessions[row.session];
  const bool is_test = row.kind == study::TrialKind::test;
  const auto methods = static_cast<int>(records_.methods.size());
  const auto if_test = [&](int value) { return is_test ? field(value) : Field(); };
  const auto named = [&](std::uint32_t word) {
    return word == 0 ? Field() : field(records_.words[word]);
  };
  Row fields = {session.participant,
                session.kind,
                session.state,
                status_of(row, session, participants_[row.session].has_value()),
                reason_in_field(session, set_),
                records_.scenes[row.scene],
                records_.methods[row.method],
                field(static_cast<int>(row.trial)),
                std::string(name_of(row.kind)),
                if_test(row.scene_position * methods + row.method_position),
                if_test(row.method_position),
                field(static_cast<int>(row.attempt)),
                named(row.object),
                named(row.outcome)};
  for (std::size_t i = 0; i < set_.measures.size(); ++i) {
    append_value(records_, set_.measures[i], records_.value(trial, i), fields);
  }
  append_gaze(gaze_.of(trial), set_.measures, fields);
  fields.push_back(field(set_.record));
  return fields;
}

AnswerColumns::AnswerColumns(const StudyRecords& records, const Dataset& set)
    : records_(records), set_(set), participants_(analysed_sessions(records, set)) {
  for (const study::Questionnaire& questionnaire : records.protocol.questionnaires) {
    for (Measure& measure : study::measures_of(questionnaire)) {
      asked_[{questionnaire.id, measure.id()}] = std::move(measure);
    }
  }
  columns_ = {
      participant_column(),
      state_column(),
      {"status", text, "", session_status_meaning},
      reason_column(),
      {"questionnaire", text, "", "Id of the questionnaire"},
      {"step", whole, "", "Place in the session's plan: a questionnaire may be asked twice"},
      {"question", text, "", "Id of the question"},
      {"number", number, "", "The answer, if it is a number"},
      {"text", text, "", "The answer in words, or the protocol's label of the number"},
      {"question_text", text, "", "The question as the protocol asks it"},
      {"scale", text, "", "The scale of the answers"},
      {"response_s", number, "s",
       "How long the question was shown until it was answered; empty if that was not measured"},
      kind_column(),
      record_column()};
}

Row AnswerColumns::row(std::size_t answer) const {
  const study::AnswerRow& row = records_.answers[answer];
  const study::SessionRow& session = records_.sessions[row.session];
  const std::string& questionnaire = records_.questionnaire_of(row);
  const std::string& question = records_.question_of(row);
  const auto known = asked_.find({questionnaire, question});
  const Measure* asked = known == asked_.end() ? nullptr : &known->second;
  std::string words;
  if (!row.value.is_measured()) {
    words = records_.words[row.value.words];
  } else if (asked != nullptr) {
    words = asked->label_of(row.value.number);
  }
  return {session.participant,
          session.state,
          status_of(session, participants_[row.session].has_value()),
          reason_in_field(session, set_),
          questionnaire,
          field(row.step),
          question,
          row.value.is_measured() ? field(row.value.number) : Field(),
          words.empty() ? Field() : field(words),
          asked != nullptr ? field(asked->question.text) : Field(),
          asked != nullptr ? field(study::scale_in_words(*asked)) : Field(),
          field(row.response_s),
          session.kind,
          field(set_.record)};
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
      {{"questionnaire", text, "", "Id of the questionnaire"},
       [](const Q& row) { return field(row.question.questionnaire); }},
      {{"question", text, "", "Id of the question"},
       [](const Q& row) { return field(row.question.question); }},
      {{"scale", text, "", "The scale of the answers"},
       [](const Q& row) { return field(row.question.scale); }},
      {{"n", whole, "", "Analysed participants with a number"},
       [](const Q& row) { return field(row.answers.n); }},
      {{"mean", number, "", "Mean of the answers"},
       [](const Q& row) { return field(row.answers.mean); }},
      {{"sd", number, "", "Their standard deviation"},
       [](const Q& row) { return field(row.answers.standard_deviation); }},
      {{"median", number, "", "Their median"},
       [](const Q& row) { return field(row.answers.median); }},
      {{"missing", whole, "", "Analysed participants without a number"},
       [](const Q& row) { return field(row.missing); }},
      {kind_column(), [&](const Q& /*row*/) { return field(set.kind); }}};
  return tabulate("answers_by_question", "question with answers in numbers", columns, rows);
}

Table questionnaire_scores(const StudyRecords& records, const Dataset& set) {
  using S = ScoreRow;
  const std::vector<std::optional<std::size_t>> analysed = analysed_sessions(records, set);
  const ColumnsOf<S> columns = {
      {{"participant", text, "", "Code of the participant"},
       [](const S& row) { return field(row.participant); }},
      {{"status", text, "", session_status_meaning},
       [&](const S& row) {
         return field(status_of(records.sessions[row.session], analysed[row.session].has_value()));
       }},
      {{"questionnaire", text, "", "Id of the questionnaire"},
       [](const S& row) { return field(row.questionnaire); }},
      {{"step", whole, "", "Place in the session's plan: a questionnaire may be asked twice"},
       [](const S& row) { return field(row.step); }},
      {{"instrument", text, "",
        "SSQ (Kennedy et al. 1993), NASA-TLX (Hart 2006) or SUS (Brooke "
        "1996)"},
       [](const S& row) { return field(row.instrument); }},
      {{"score", text, "", "Which score"}, [](const S& row) { return field(row.score); }},
      {{"value", number, "", "The score by its published key; empty if an item has no answer"},
       [](const S& row) { return field(row.value); }},
      {kind_column(), [&](const S& row) { return field(records.sessions[row.session].kind); }}};
  return tabulate("questionnaire_scores", "score of a filled-in questionnaire", columns,
                  score_questionnaires(records));
}

ParticipantColumns::ParticipantColumns(const StudyRecords& records, const Dataset& set)
    : records_(records),
      set_(set),
      columns_({participant_column(), kind_column(), record_column()}) {
  for (const std::string& scene : set.scenes) {
    for (const std::string& method : set.methods) {
      for (std::size_t i = 0; i < set.measures.size(); ++i) {
        for (Column column : columns_of(set.measures[i], scale_with_amendments(set, i))) {
          column.name = fmt::format("{}.{}.{}", column.name, scene, method);
          column.description += fmt::format("; scene {}, method {}", scene, method);
          columns_.push_back(std::move(column));
        }
      }
    }
  }
  const std::vector<NumericQuestion> questions = numeric_questions(records);
  answers_ = numeric_answers(records, set, questions);
  for (const NumericQuestion& question : questions) {
    columns_.push_back({fmt::format("{}.{}", question.questionnaire, question.question), number, "",
                        question.scale.empty()
                            ? question.text
                            : fmt::format("{} Answers: {}", question.text, question.scale)});
  }
}

Row ParticipantColumns::row(std::size_t participant) const {
  Row row = {set_.participants[participant], set_.kind, set_.record};
  for (std::size_t scene = 0; scene < set_.scenes.size(); ++scene) {
    for (std::size_t method = 0; method < set_.methods.size(); ++method) {
      for (std::size_t i = 0; i < set_.measures.size(); ++i) {
        append_value(records_, set_.measures[i], set_.value(participant, scene, method, i), row);
      }
    }
  }
  for (const std::vector<std::optional<double>>& given : answers_) {
    row.push_back(field(given[participant]));
  }
  return row;
}

}  // namespace foveola::analysis
