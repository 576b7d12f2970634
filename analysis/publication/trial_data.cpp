#include "analysis/publication/trial_data.h"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>

#include "analysis/dataset/amended_labels.h"
#include "analysis/publication/result_tables.h"

namespace foveola::analysis {
namespace {

using study::StudyRecords;
using study::TrialRow;
using enum ColumnType;

std::vector<bool> analysed_sessions(const StudyRecords& records, const Dataset& set) {
  std::vector<bool> analysed;
  for (const study::SessionRow& session : records.sessions) {
    analysed.push_back(
        std::binary_search(set.participants.begin(), set.participants.end(), session.participant));
  }
  return analysed;
}

void append_value(const StudyRecords& records, const Measure& measure, const Value& value,
                  Row& row) {
  if (measure.kind == MeasureKind::time) {
    const bool is_known = value.state != Value::State::missing;
    row.push_back(is_known ? field(value.number) : Field());
    row.push_back(is_known ? field(value.state == Value::State::right_censored) : Field());
  } else if (value.state == Value::State::in_words) {
    row.push_back(field(records.words[value.words]));
  } else {
    row.push_back(value.is_measured() ? field(value.number) : Field());
  }
}

/// Why a trial is not among those that are analysed, or "analysed".
std::string status_of(const StudyRecords& records, const TrialRow& row, bool is_analysed) {
  if (row.kind != study::TrialKind::test) {
    return name_of(row.kind);
  }
  const study::SessionRow& session = records.sessions[row.session];
  if (is_analysed) {
    return row.counts ? "analysed" : "timed again";
  }
  return session.state == "completed" ? session.kind : session.state;
}

/// A question of a questionnaire that has answers in numbers, in the protocol's order.
struct NumericQuestion {
  std::string questionnaire;
  std::string question;
  std::string text;
  std::string scale;
};

std::vector<NumericQuestion> numeric_questions(const StudyRecords& records) {
  std::set<std::pair<std::string, std::string>> answered;
  for (const study::AnswerRow& row : records.answers) {
    if (std::holds_alternative<double>(row.value)) {
      answered.emplace(row.questionnaire, row.question);
    }
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

/// [questionnaire, question][participant]: the last answer that is a number.
using NumericAnswers = std::map<std::pair<std::string, std::string>, std::map<std::string, double>>;

NumericAnswers numeric_answers(const StudyRecords& records) {
  NumericAnswers answers;
  for (const study::AnswerRow& row : records.answers) {
    if (const auto* number = std::get_if<double>(&row.value)) {
      answers[{row.questionnaire, row.question}][records.sessions[row.session].participant] =
          *number;
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
  if (measure.kind == MeasureKind::time) {
    return {
        {id + "_s", number, "s", fmt::format("From the first presented frame to the mark {}", id)},
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

TrialColumns::TrialColumns(const StudyRecords& records, const Dataset& set)
    : records_(records), set_(set), is_analysed_(analysed_sessions(records, set)) {
  columns_ = {
      {"participant", text, "", "Code of the participant"},
      {"participant_kind", text, "", "Who took part: human, pilot or simulated"},
      {"session_state", text, "", "How the session ended, as completed or excluded"},
      {"status", text, "",
       "analysed; or why not: practice, catch, timed again, the kind of a session that is not "
       "analysed, or its state"},
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
                status_of(records_, row, is_analysed_[row.session]),
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
  fields.push_back(field(set_.record));
  return fields;
}

Table answers_long(const StudyRecords& records) {
  std::map<std::pair<std::string, std::string>, Measure> asked;
  for (const study::Questionnaire& questionnaire : records.protocol.questionnaires) {
    for (Measure& measure : study::measures_of(questionnaire)) {
      asked[{questionnaire.id, measure.id()}] = std::move(measure);
    }
  }
  using A = study::AnswerRow;
  const auto session = [&](const A& row) -> const study::SessionRow& {
    return records.sessions[row.session];
  };
  const auto measure = [&](const A& row) {
    const auto found = asked.find({row.questionnaire, row.question});
    return found == asked.end() ? nullptr : &found->second;
  };
  const ColumnsOf<A> columns = {
      {{"participant", text, "", "Code of the participant"},
       [=](const A& row) { return field(session(row).participant); }},
      {{"session_state", text, "", "How the session ended, as completed or excluded"},
       [=](const A& row) { return field(session(row).state); }},
      {{"questionnaire", text, "", "Id of the questionnaire"},
       [](const A& row) { return field(row.questionnaire); }},
      {{"step", whole, "", "Place in the session's plan: a questionnaire may be asked twice"},
       [](const A& row) { return field(row.step); }},
      {{"question", text, "", "Id of the question"},
       [](const A& row) { return field(row.question); }},
      {{"number", number, "", "The answer, if it is a number"},
       [](const A& row) {
         const auto* value = std::get_if<double>(&row.value);
         return value != nullptr ? field(*value) : Field();
       }},
      {{"text", text, "", "The answer in words, or the protocol's label of the number"},
       [=](const A& row) {
         if (const auto* words = std::get_if<std::string>(&row.value)) {
           return field(*words);
         }
         const Measure* asked_one = measure(row);
         const std::string label =
             asked_one != nullptr ? asked_one->label_of(std::get<double>(row.value)) : "";
         return label.empty() ? Field() : field(label);
       }},
      {{"question_text", text, "", "The question as the protocol asks it"},
       [=](const A& row) {
         const Measure* asked_one = measure(row);
         return asked_one != nullptr ? field(asked_one->question.text) : Field();
       }},
      {{"scale", text, "", "The scale of the answers"},
       [=](const A& row) {
         const Measure* asked_one = measure(row);
         return asked_one != nullptr ? field(study::scale_in_words(*asked_one)) : Field();
       }},
      {kind_column(), [=](const A& row) { return field(session(row).kind); }}};
  return tabulate("answers_long", "answer of a questionnaire", columns, records.answers);
}

Table answers_by_question(const StudyRecords& records, const Dataset& set) {
  const NumericAnswers answers = numeric_answers(records);
  std::vector<DescribedQuestion> rows;
  for (const NumericQuestion& question : numeric_questions(records)) {
    std::vector<double> values;
    const auto& given = answers.at({question.questionnaire, question.question});
    for (const std::string& participant : set.participants) {
      if (const auto own = given.find(participant); own != given.end()) {
        values.push_back(own->second);
      }
    }
    rows.push_back({question, describe(values), set.participants.size() - values.size()});
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
  return tabulate("answers_by_question",
                  "question with answers in numbers (Table 1 of the published study)", columns,
                  rows);
}

Table questionnaire_scores(const StudyRecords& records, const std::string& kind) {
  using S = ScoreRow;
  const ColumnsOf<S> columns = {
      {{"participant", text, "", "Code of the participant"},
       [](const S& row) { return field(row.participant); }},
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
      {kind_column(), [&](const S& /*row*/) { return field(kind); }}};
  return tabulate("questionnaire_scores", "score of a filled-in questionnaire", columns,
                  score_questionnaires(records));
}

ParticipantColumns::ParticipantColumns(const StudyRecords& records, const Dataset& set)
    : records_(records),
      set_(set),
      columns_(
          {{"participant", text, "", "Code of the participant"}, kind_column(), record_column()}) {
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
  NumericAnswers answers = numeric_answers(records);
  for (const NumericQuestion& question : numeric_questions(records)) {
    columns_.push_back({fmt::format("{}.{}", question.questionnaire, question.question), number, "",
                        question.scale.empty()
                            ? question.text
                            : fmt::format("{} Answers: {}", question.text, question.scale)});
    answers_.push_back(std::move(answers[{question.questionnaire, question.question}]));
  }
}

Row ParticipantColumns::row(std::size_t participant) const {
  const std::string& code = set_.participants[participant];
  Row row = {code, set_.kind, set_.record};
  for (std::size_t scene = 0; scene < set_.scenes.size(); ++scene) {
    for (std::size_t method = 0; method < set_.methods.size(); ++method) {
      for (std::size_t i = 0; i < set_.measures.size(); ++i) {
        append_value(records_, set_.measures[i], set_.value(participant, scene, method, i), row);
      }
    }
  }
  for (const std::map<std::string, double>& given : answers_) {
    const auto own = given.find(code);
    row.push_back(own != given.end() ? field(own->second) : Field());
  }
  return row;
}

}  // namespace foveola::analysis
