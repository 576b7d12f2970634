#include "tests/analysis/made_up_study.h"

#include <algorithm>
#include <numeric>
#include <random>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>

#include "study/protocol/reading/read_procedure.h"
#include "tests/analysis/golden.h"

namespace foveola::analysis {
namespace {

using study::StudyRecords;
using study::TrialRow;
using study::Value;

StudyRecords empty_study(const std::string& name, const std::string& title, char digest) {
  StudyRecords records;
  records.protocol.name = name;
  records.protocol.title = title;
  records.protocol.sha256 = std::string(64, digest);
  records.measures = study::trial_measures(study::published_marks(), study::published_ratings());
  records.words = {"", "the chair", "rated"};
  records.protocol.analysis.background = {"graphics_3d", "offline_rendering"};
  return records;
}

template <typename Names>
std::size_t position_of(const Names& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    throw std::out_of_range(name);
  }
  return static_cast<std::size_t>(found - names.begin());
}

std::uint32_t session_of(const StudyRecords& records, const std::string& participant) {
  const auto found =
      std::find_if(records.sessions.begin(), records.sessions.end(),
                   [&](const study::SessionRow& row) { return row.participant == participant; });
  if (found == records.sessions.end()) {
    throw std::out_of_range(participant);
  }
  return static_cast<std::uint32_t>(found - records.sessions.begin());
}

/// A rated trial.
TrialRow row_of(const StudyRecords& records, const std::string& participant,
                const std::string& scene, const std::string& method) {
  return {.session = session_of(records, participant),
          .scene = static_cast<std::uint16_t>(position_of(records.scenes, scene)),
          .method = static_cast<std::uint16_t>(position_of(records.methods, method)),
          .attempt = 1,
          .object = 1,
          .outcome = 2};
}

Value time_in(const std::string& seconds, const std::string& censored) {
  if (seconds.empty()) {
    return {};
  }
  return censored == "1" ? right_censored(std::stod(seconds)) : measured(std::stod(seconds));
}

/// The study with these rows of its trials only, in this order.
StudyRecords with_trials(const StudyRecords& records, const std::vector<std::size_t>& rows) {
  StudyRecords other = records;
  other.trials.clear();
  other.values.clear();
  for (const std::size_t row : rows) {
    std::vector<Value> values;
    for (std::size_t measure = 0; measure < records.measures.size(); ++measure) {
      values.push_back(records.value(row, measure));
    }
    other.add_trial(records.trials[row], values);
  }
  return other;
}

std::size_t index_of_measure(const StudyRecords& records, const std::string& measure) {
  std::vector<std::string> ids;
  for (const study::Measure& known : records.measures) {
    ids.push_back(known.id());
  }
  return position_of(ids, measure);
}

std::vector<std::size_t> shuffled(std::size_t count, std::mt19937& random) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::shuffle(order.begin(), order.end(), random);
  return order;
}

std::size_t index_of(const StudyRecords& records, const std::string& participant,
                     const std::string& scene, const std::string& method) {
  const TrialRow wanted = row_of(records, participant, scene, method);
  const auto found =
      std::find_if(records.trials.begin(), records.trials.end(), [&](const TrialRow& row) {
        return row.session == wanted.session && row.scene == wanted.scene &&
               row.method == wanted.method;
      });
  if (found == records.trials.end()) {
    throw std::out_of_range("no such trial");
  }
  return static_cast<std::size_t>(found - records.trials.begin());
}

void record_answer(StudyRecords& records, const std::string& participant,
                   const std::string& questionnaire, const std::string& question,
                   const Value& value, int step) {
  records.answers.push_back({.session = session_of(records, participant),
                             .step = step,
                             .questionnaire = word_in(records, questionnaire),
                             .question = word_in(records, question),
                             .value = value});
}

}  // namespace

std::uint32_t word_in(StudyRecords& records, const std::string& text) {
  const auto found = std::find(records.words.begin(), records.words.end(), text);
  const auto index = static_cast<std::uint32_t>(found - records.words.begin());
  if (found == records.words.end()) {
    records.words.push_back(text);
  }
  return index;
}

Value measured(double number) { return {.state = Value::State::measured, .number = number}; }

Value right_censored(double seconds) {
  return {.state = Value::State::right_censored, .number = seconds};
}

StudyRecords golden_study_records() {
  StudyRecords records = empty_study("koskela2018-golden", "A made-up study", 'a');
  records.scenes = {"aula", "barn", "cave"};
  records.methods = {"od", "vp", "fv"};
  for (int i = 1; i <= 9; ++i) {
    records.sessions.push_back(
        {fmt::format("P0{}", i), "human", i == 9 ? "interrupted" : "completed", {}, {}});
  }
  for (const CsvRow& row : golden_rows("study_trials.csv")) {
    records.add_trial(row_of(records, row.at(0), row.at(1), row.at(2)),
                      {time_in(row.at(3), row.at(5)), time_in(row.at(4), row.at(6)),
                       row.at(7).empty() ? Value{} : measured(std::stod(row.at(7)))});
  }
  for (const CsvRow& row : golden_rows("study_background.csv")) {
    add_answer(records, row.at(0), "background", row.at(1), std::stod(row.at(2)));
  }
  return records;
}

StudyRecords complete_study(int participants) {
  StudyRecords records = empty_study("koskela2018-complete", "A complete study", 'c');
  records.scenes = {"aula", "barn"};
  records.methods = {"od", "vp", "fv"};
  for (int p = 1; p <= participants; ++p) {
    const std::string code = fmt::format("P{}", p);
    records.sessions.push_back({code, "human", "completed", {}, {}});
    add_answer(records, code, "background", "offline_rendering", 1.0 + p % 5);
    add_answer(records, code, "background", "graphics_3d", 1.0 + p * p % 3);
    for (std::size_t scene = 0; scene < records.scenes.size(); ++scene) {
      for (std::size_t method = 0; method < records.methods.size(); ++method) {
        const double outline = (10.0 + 0.5 * p + 4.0 * static_cast<double>(scene)) /
                               (1.0 + 2.0 * static_cast<double>(method) + 0.1 * p);
        records.add_trial(row_of(records, code, records.scenes[scene], records.methods[method]),
                          {measured(outline), measured(1.5 * outline),
                           measured(1.0 + (p + static_cast<int>(method)) % 3)});
      }
    }
  }
  return records;
}

TrialRow& trial_of(StudyRecords& records, const std::string& participant, const std::string& scene,
                   const std::string& method) {
  return records.trials[index_of(records, participant, scene, method)];
}

Value& value_of(StudyRecords& records, const std::string& participant, const std::string& scene,
                const std::string& method, const std::string& measure) {
  return records.values[index_of(records, participant, scene, method) * records.measures.size() +
                        index_of_measure(records, measure)];
}

void change_values(StudyRecords& records, const std::string& measure,
                   const std::function<void(Value&)>& change) {
  for (std::size_t i = index_of_measure(records, measure); i < records.values.size();
       i += records.measures.size()) {
    change(records.values[i]);
  }
}

void keep_trials(StudyRecords& records, const std::function<bool(const TrialRow&)>& is_kept) {
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < records.trials.size(); ++row) {
    if (is_kept(records.trials[row])) {
      rows.push_back(row);
    }
  }
  records = with_trials(records, rows);
}

StudyRecords of_kind(StudyRecords records, const std::string& kind) {
  for (study::SessionRow& session : records.sessions) {
    session.kind = kind;
  }
  return records;
}

StudyRecords with_od_alone(StudyRecords records) {
  records.methods = {"od"};
  keep_trials(records, [](const TrialRow& row) { return row.method == 0; });
  return records;
}

StudyRecords reordered(const StudyRecords& records, unsigned seed) {
  std::mt19937 random(seed);
  StudyRecords other = with_trials(records, shuffled(records.trials.size(), random));
  std::vector<std::uint32_t> places(records.sessions.size());
  const std::vector<std::size_t> order = shuffled(records.sessions.size(), random);
  for (std::size_t place = 0; place < order.size(); ++place) {
    other.sessions[place] = records.sessions[order[place]];
    places[order[place]] = static_cast<std::uint32_t>(place);
  }
  for (TrialRow& row : other.trials) {
    row.session = places[row.session];
  }
  std::shuffle(other.answers.begin(), other.answers.end(), random);
  for (study::AnswerRow& row : other.answers) {
    row.session = places[row.session];
  }
  return other;
}

void add_answer(StudyRecords& records, const std::string& participant,
                const std::string& questionnaire, const std::string& question, double number,
                int step) {
  record_answer(records, participant, questionnaire, question, measured(number), step);
}

void add_answer_in_words(StudyRecords& records, const std::string& participant,
                         const std::string& questionnaire, const std::string& question,
                         const std::string& words, int step) {
  record_answer(records, participant, questionnaire, question,
                {.state = Value::State::in_words, .words = word_in(records, words)}, step);
}

}  // namespace foveola::analysis
