#include "analysis/dataset/scoring.h"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <tuple>
#include <utility>

namespace foveola::analysis {
namespace {

/// An item of an instrument, with the sums that include it.
struct Item {
  std::string_view id;
  std::string_view scales;
};

constexpr std::array ssq_items = {Item{"general_discomfort", "NO"},
                                  Item{"fatigue", "O"},
                                  Item{"headache", "O"},
                                  Item{"eyestrain", "O"},
                                  Item{"difficulty_focusing", "OD"},
                                  Item{"increased_salivation", "N"},
                                  Item{"sweating", "N"},
                                  Item{"nausea", "ND"},
                                  Item{"difficulty_concentrating", "NO"},
                                  Item{"fullness_of_head", "D"},
                                  Item{"blurred_vision", "OD"},
                                  Item{"dizzy_eyes_open", "D"},
                                  Item{"dizzy_eyes_closed", "D"},
                                  Item{"vertigo", "D"},
                                  Item{"stomach_awareness", "N"},
                                  Item{"burping", "N"}};

constexpr std::array tlx_items = {Item{"mental_demand", "L"},   Item{"physical_demand", "L"},
                                  Item{"temporal_demand", "L"}, Item{"performance", "L"},
                                  Item{"effort", "L"},          Item{"frustration", "L"}};

// Odd items are positive about the system, even ones negative.
constexpr std::array sus_items = {Item{"sus_1", "+"}, Item{"sus_2", "-"}, Item{"sus_3", "+"},
                                  Item{"sus_4", "-"}, Item{"sus_5", "+"}, Item{"sus_6", "-"},
                                  Item{"sus_7", "+"}, Item{"sus_8", "-"}, Item{"sus_9", "+"},
                                  Item{"sus_10", "-"}};

struct Instrument {
  std::string_view name;
  const Item* items;
  std::size_t count;
  double minimum;
  double maximum;
};

constexpr std::array instruments = {
    Instrument{"SSQ", ssq_items.data(), ssq_items.size(), 0.0, 3.0},
    Instrument{"NASA-TLX", tlx_items.data(), tlx_items.size(), 0.0, 20.0},
    Instrument{"SUS", sus_items.data(), sus_items.size(), 1.0, 5.0}};

bool has_item(const study::Questionnaire& questionnaire, const Instrument& instrument,
              std::string_view id) {
  return std::ranges::any_of(questionnaire.questions, [&](const study::Question& question) {
    return question.id == id && question.minimum == instrument.minimum &&
           question.maximum == instrument.maximum &&
           (question.kind == study::QuestionKind::likert ||
            question.kind == study::QuestionKind::number);
  });
}

const Instrument* find_instrument(const study::Questionnaire& questionnaire) {
  for (const Instrument& instrument : instruments) {
    if (std::all_of(instrument.items, instrument.items + instrument.count, [&](const Item& item) {
          return has_item(questionnaire, instrument, item.id);
        })) {
      return &instrument;
    }
  }
  return nullptr;
}

/// The answers of one completed questionnaire.
using Answers = std::map<std::string, double, std::less<>>;

/// Returns the sum over the items of a scale, each answer times `factor` plus `offset`; empty if
/// one is missing.
std::optional<double> sum_of(const Instrument& instrument, const Answers& answers, char scale,
                             double factor = 1.0, double offset = 0.0) {
  double sum = 0.0;
  for (std::size_t i = 0; i < instrument.count; ++i) {
    const Item& item = instrument.items[i];
    if (item.scales.find(scale) == std::string_view::npos) {
      continue;
    }
    const auto answer = answers.find(item.id);
    if (answer == answers.end()) {
      return std::nullopt;
    }
    sum += factor * answer->second + offset;
  }
  return sum;
}

std::optional<double> scaled(std::optional<double> sum, double factor) {
  return sum ? std::optional(factor * *sum) : std::nullopt;
}

std::optional<double> added(std::optional<double> a, std::optional<double> b) {
  return a && b ? std::optional(*a + *b) : std::nullopt;
}

using Scores = std::vector<std::pair<std::string, std::optional<double>>>;

Scores scores_of(const Instrument& instrument, const Answers& answers) {
  const auto sum = [&](char scale, double factor = 1.0, double offset = 0.0) {
    return sum_of(instrument, answers, scale, factor, offset);
  };
  if (instrument.name == "SSQ") {
    return {{"nausea", scaled(sum('N'), 9.54)},
            {"oculomotor", scaled(sum('O'), 7.58)},
            {"disorientation", scaled(sum('D'), 13.92)},
            {"total", scaled(added(added(sum('N'), sum('O')), sum('D')), 3.74)}};
  }
  if (instrument.name == "NASA-TLX") {
    return {{"raw_load", scaled(sum('L'), 5.0 / static_cast<double>(instrument.count))}};
  }
  return {{"usability", scaled(added(sum('+', 1.0, -1.0), sum('-', -1.0, 5.0)), 2.5)}};
}

}  // namespace

std::vector<ScoreRow> score_questionnaires(const study::StudyRecords& records) {
  std::map<std::string, const Instrument*> known;
  for (const study::Questionnaire& questionnaire : records.protocol.questionnaires) {
    if (const Instrument* instrument = find_instrument(questionnaire)) {
      known[questionnaire.id] = instrument;
    }
  }
  // Session, step and questionnaire.
  std::map<std::tuple<std::uint32_t, int, std::string>, Answers> filled_in;
  for (const study::AnswerRow& row : records.answers) {
    const std::string& questionnaire = records.questionnaire_of(row);
    if (known.contains(questionnaire)) {
      Answers& answers = filled_in[{row.session, row.step, questionnaire}];
      if (row.value.is_measured()) {
        answers[records.question_of(row)] = row.value.number;
      }
    }
  }
  std::vector<ScoreRow> rows;
  for (const auto& [key, answers] : filled_in) {
    const auto& [session, step, questionnaire] = key;
    const Instrument& instrument = *known.at(questionnaire);
    for (const auto& [score, value] : scores_of(instrument, answers)) {
      rows.push_back({records.sessions[session].participant, session, questionnaire, step,
                      std::string(instrument.name), score, value});
    }
  }
  return rows;
}

}  // namespace foveola::analysis
