#include "analysis/publication/trial_data.h"

#include <map>
#include <set>

#include <fmt/format.h>

#include "renderer/base/csv.h"

namespace foveola::analysis {
namespace {

/// A measured time, or the lower bound of a right-censored one, which another column marks.
std::string seconds_of(const MarkTime& time) {
  return time.state == MarkTime::State::missing || time.seconds <= 0.0 ? ""
                                                                       : csv_number(time.seconds);
}

std::string censored_of(const MarkTime& time) {
  return time.state == MarkTime::State::missing    ? ""
         : time.state == MarkTime::State::censored ? "true"
                                                   : "false";
}

std::string rating_of(const Cell& cell) { return cell.rating ? std::to_string(*cell.rating) : ""; }

std::string rating_in_words(const RatingScale& scale) {
  const std::string notes = notes_on(scale);
  return fmt::format("Artifacts in other areas, {}{}", points_in_words(scale),
                     notes.empty() ? "" : "." + notes);
}

struct WideAnswers {
  std::map<std::string, std::map<std::string, double>> by_participant;
  std::set<std::string> questions;
};

WideAnswers wide_answers(const std::vector<study::BackgroundRow>& answers) {
  WideAnswers wide;
  for (const study::BackgroundRow& row : answers) {
    wide.by_participant[row.participant][row.question] = row.value;
    wide.questions.insert(row.question);
  }
  return wide;
}

/// The columns of the long table that the wide one has for each scene and method.
bool is_of_one_trial(const Variable& variable) {
  return variable.name.starts_with("outline_") || variable.name.starts_with("material_") ||
         variable.name.starts_with("artifacts_");
}

CsvRow names_of(const std::vector<Variable>& variables) {
  CsvRow names;
  for (const Variable& variable : variables) {
    names.push_back(variable.name);
  }
  return names;
}

CsvRow wide_row(const AnalysisSet& set, const WideAnswers& answers, std::size_t participant) {
  CsvRow row = {set.participants[participant], set.kind};
  for (std::size_t scene = 0; scene < set.scenes.size(); ++scene) {
    for (std::size_t method = 0; method < set.methods.size(); ++method) {
      const Cell& cell = set.cell(participant, scene, method);
      for (const Mark mark : marks) {
        row.push_back(seconds_of(cell.time(mark)));
        row.push_back(censored_of(cell.time(mark)));
      }
      row.push_back(rating_of(cell));
    }
  }
  const auto given = answers.by_participant.find(set.participants[participant]);
  for (const std::string& question : answers.questions) {
    std::optional<double> value;
    if (given != answers.by_participant.end() && given->second.contains(question)) {
      value = given->second.at(question);
    }
    row.push_back(csv_number(value));
  }
  return row;
}

}  // namespace

std::vector<Variable> trial_variables(const RatingScale& scale) {
  return {
      {"participant", "", "string", "Code of the participant"},
      {"participant_kind", "", "string", "Who took part: human, pilot or simulated"},
      {"scene", "", "string", "Name of the scene"},
      {"method", "", "string", "How samples were placed: od, vp, fv or another sampler"},
      {"trial_position", "", "integer", "Place among the session's trials as planned, from 0"},
      {"method_position", "", "integer", "Place among the methods in the scene, from 0"},
      {"attempts", "", "integer", "How often it was timed; the last time counts; 0: never begun"},
      {"outline_s", "s", "number",
       "From the first presented frame to the mark that the outline was visible"},
      {"outline_censored", "", "boolean", "True: right-censored, outline_s is a lower bound"},
      {"material_s", "s", "number",
       "From the first presented frame to the mark that the material was visible"},
      {"material_censored", "", "boolean", "True: right-censored, material_s is a lower bound"},
      {"artifacts_rating", "points", "integer", rating_in_words(scale)}};
}

std::vector<Variable> participant_variables(const AnalysisSet& set,
                                            const std::vector<study::BackgroundRow>& answers) {
  const std::vector<Variable> of_trials = trial_variables(set.rating_scale);
  std::vector<Variable> variables(of_trials.begin(), of_trials.begin() + 2);
  for (const std::string& scene : set.scenes) {
    for (const std::string& method : set.methods) {
      for (Variable variable : of_trials) {
        if (is_of_one_trial(variable)) {
          variable.name = fmt::format("{}.{}.{}", variable.name, scene, method);
          variable.description += fmt::format("; scene {}, method {}", scene, method);
          variables.push_back(std::move(variable));
        }
      }
    }
  }
  for (const std::string& question : wide_answers(answers).questions) {
    variables.push_back({"background." + question, "", "number",
                         "Answer to the background question " + question + ", as a number"});
  }
  return variables;
}

std::vector<std::string> trial_row(const AnalysisSet& set, std::size_t participant,
                                   std::size_t scene, std::size_t method) {
  const Cell& cell = set.cell(participant, scene, method);
  const MarkTime& outline = cell.time(Mark::outline);
  const MarkTime& material = cell.time(Mark::material);
  return {set.participants[participant],
          set.kind,
          set.scenes[scene],
          set.methods[method],
          std::to_string(cell.trial_position),
          std::to_string(cell.method_position),
          std::to_string(cell.attempts),
          seconds_of(outline),
          censored_of(outline),
          seconds_of(material),
          censored_of(material),
          rating_of(cell)};
}

std::string trials_long_csv(const AnalysisSet& set) {
  std::string text = format_csv({names_of(trial_variables(set.rating_scale))});
  for (std::size_t participant = 0; participant < set.participants.size(); ++participant) {
    for (std::size_t scene = 0; scene < set.scenes.size(); ++scene) {
      for (std::size_t method = 0; method < set.methods.size(); ++method) {
        text += format_csv({trial_row(set, participant, scene, method)});
      }
    }
  }
  return text;
}

std::string participants_wide_csv(const AnalysisSet& set,
                                  const std::vector<study::BackgroundRow>& answers) {
  const WideAnswers wide = wide_answers(answers);
  std::string text = format_csv({names_of(participant_variables(set, answers))});
  for (std::size_t participant = 0; participant < set.participants.size(); ++participant) {
    text += format_csv({wide_row(set, wide, participant)});
  }
  return text;
}

std::string codebook_csv(const RatingScale& scale) {
  std::vector<CsvRow> rows = {{"variable", "type", "unit", "description"}};
  for (const Variable& variable : trial_variables(scale)) {
    rows.push_back({variable.name, variable.type, variable.unit, variable.description});
  }
  return format_csv(rows);
}

}  // namespace foveola::analysis
