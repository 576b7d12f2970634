#include "study/protocol/reading/read_questions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/base/error.h"
#include "renderer/base/files/file_access.h"
#include "renderer/base/files/files.h"
#include "renderer/base/text/similar_word.h"
#include "renderer/base/toml/toml_file.h"
#include "renderer/gaze/profiles.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

constexpr double largest_number = 1e6;
constexpr int max_points = 101;  // A scale from 0 to 100.

bool is_id_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '-';
}

/// Throws Error for a key that the question's kind does not use.
void forbid(const TomlReader& reader, std::initializer_list<std::string_view> keys,
            std::string_view kind) {
  for (const std::string_view key : keys) {
    if (reader.has(key)) {
      reader.fail(reader.source(key), fmt::format("a {} has no {}", kind, key),
                  "remove it, or choose another kind");
    }
  }
}

void read_range(TomlReader& reader, Question& question) {
  reader.read("minimum", question.minimum, -largest_number, largest_number,
              "The first point of a scale (default 1), or the minimum of a number (required).");
  reader.read(
      "maximum", question.maximum, -largest_number, largest_number,
      "The last point of a scale (default 5; at most 101 points), or the maximum of a number "
      "(required).");
  if (question.maximum <= question.minimum) {
    reader.fail(reader.source(reader.has("maximum") ? "maximum" : "minimum"),
                fmt::format("the range from {} to {} is empty", question.minimum, question.maximum),
                "make the maximum larger than the minimum");
  }
}

void require_points(const TomlReader& reader, const Question& question) {
  const double points = question.maximum - question.minimum + 1.0;
  if (question.minimum != std::round(question.minimum) || points != std::round(points) ||
      points > max_points) {
    reader.fail(reader.source(reader.has("maximum") ? "maximum" : "minimum"),
                fmt::format("a scale has whole points, at most {}", max_points),
                "use whole ends, or kind = \"number\"");
  }
  const std::size_t labels = question.labels.size();
  if (labels != 0 && labels != 2 && static_cast<double>(labels) != points) {
    reader.fail(reader.source("labels"),
                fmt::format("{} labels for {} points", labels, static_cast<int>(points)),
                "write one per point, or two for the ends");
  }
}

void read_scale(TomlReader& reader, Question& question) {
  forbid(reader, {"options"}, "scale");
  read_range(reader, question);
  for (const TomlReader::Text& label : reader.texts("labels",
                                                    "The labels of a scale: two for its ends, or "
                                                    "one for each point, without duplicates.")) {
    question.labels.push_back(label.value);
  }
  require_points(reader, question);
}

void read_number(TomlReader& reader, Question& question) {
  forbid(reader, {"labels", "options"}, "number");
  reader.require("minimum");
  reader.require("maximum");
  read_range(reader, question);
}

Option read_option(TomlReader reader) {
  Option option{.label =
                    reader.require_text("label", "The option's text, unique in the question.")};
  reader.read("value", option.value, -largest_number, largest_number,
              "The number that is recorded; without it, the label is recorded as text.");
  reader.reject_unknown_keys();
  return option;
}

void read_options(TomlReader& reader, Question& question) {
  forbid(reader, {"minimum", "maximum", "labels"}, "choice");
  for (const TomlReader& entry :
       reader.tables("options", "The options of a choice, at least two.")) {
    const Option option = read_option(entry);
    if (std::ranges::any_of(question.options, [&](const Option& other) {
          return other.label == option.label || (option.value && other.value == option.value);
        })) {
      entry.fail(entry.source(), fmt::format("the option '{}' is not unique", option.label),
                 "give each a label and value of its own");
    }
    question.options.push_back(option);
  }
  if (question.options.size() < 2) {
    reader.fail(reader.source(), "a choice needs two options",
                R"(write options = [{ label = "yes" }, { label = "no" }])");
  }
}

void read_kind(TomlReader& reader, Question& question) {
  constexpr std::array kinds{
      Word<QuestionKind>{"likert", QuestionKind::likert},
      Word<QuestionKind>{"number", QuestionKind::number},
      Word<QuestionKind>{"choice", QuestionKind::choice},
      Word<QuestionKind>{"text", QuestionKind::text},
  };
  reader.read("kind", question.kind, kinds,
              "likert: a scale of whole points; number: a number in a range; choice: one of "
              "several options; text: free text.");
  switch (question.kind) {
    case QuestionKind::likert:
      read_scale(reader, question);
      return;
    case QuestionKind::number:
      read_number(reader, question);
      return;
    case QuestionKind::choice:
      read_options(reader, question);
      return;
    case QuestionKind::text:
      forbid(reader, {"minimum", "maximum", "labels", "options"}, "text");
      return;
  }
}

/// A rating with the id of the published one is judged likewise, unless it says otherwise.
void read_judgement(TomlReader& reader, Question& rating) {
  constexpr std::array judgements{Word<std::string_view>{"artifacts", "artifacts"},
                                  Word<std::string_view>{"quality", "quality"}};
  std::string_view simulated = rating.id == "artifacts" ? "artifacts" : "";
  reader.read("simulated", simulated, judgements,
              "Scales only: the judgement by which simulated participants answer it. "
              "artifacts: the lowest point means none; quality: the reverse. "
              "Default: artifacts for a rating of this id; without one they refuse the protocol.");
  rating.simulated = simulated;
  if (reader.has("simulated") && rating.kind != QuestionKind::likert) {
    reader.fail(reader.source("simulated"), "simulated is for kind = \"likert\" only",
                "set kind = \"likert\", or remove simulated");
  }
}

/// `is_rating`: false for a question of a questionnaire.
Question read_question(TomlReader reader, const std::vector<std::string>& taken, bool is_rating) {
  Question question{.id = read_new_id(reader,
                                      "The question's name in records and tables, unique in a "
                                      "form; for a rating also in files, as for a mark.",
                                      taken),
                    .text = reader.require_text("text", "The question's text.")};
  read_kind(reader, question);
  reader.read("required", question.required, "Whether the question must be answered.");
  if (is_rating) {
    read_judgement(reader, question);
  }
  reader.reject_unknown_keys();
  return question;
}

/// Reads a questionnaire without its id over `questionnaire`, with its questions, if it has any.
void read_content(TomlReader& reader, Questionnaire& questionnaire) {
  reader.read("title", questionnaire.title,
              "The heading of the form. A protocol may leave it to the file.");
  reader.read("intro", questionnaire.intro, "Text above the questions.");
  reader.read("source", questionnaire.source, "The publication of the questionnaire.");
  if (std::vector<Question> questions = read_questions(
          reader, "question", {}, "The questions. A protocol may leave them to the file.");
      !questions.empty()) {
    questionnaire.questions = std::move(questions);
  }
}

void require_content(const TomlReader& reader, const Questionnaire& questionnaire) {
  if (questionnaire.title.empty()) {
    reader.fail(reader.source(), "the questionnaire has no title", "give it a title");
  }
  if (questionnaire.questions.empty()) {
    reader.fail(reader.source(), "the questionnaire has no questions",
                "give it questions, or the file of a ready-made one");
  }
}

fs::path ready_questionnaires() { return resource_folder() / "protocols" / "questionnaires"; }

fs::path users_questionnaires() { return data_folder() / "questionnaires"; }

bool is_programs_own(const fs::path& folder) {
  std::error_code ignored;
  return fs::equivalent(folder, resource_folder() / "protocols", ignored);
}

/// Returns whether it is a questionnaire, rather than a protocol or a scene's descriptor of the
/// same name.
bool is_questionnaire(const fs::path& file) {
  return parse_toml(file.string(), read_toml_file(file), "correct it, or move it elsewhere")
      .contains("question");
}

/// Returns NAME.toml in the folder of a protocol, which may hold any files.
std::optional<fs::path> questionnaire_beside(const std::string& name, const fs::path& folder) {
  std::error_code ignored;
  if (!fs::exists(folder / (name + ".toml"), ignored)) {
    return std::nullopt;
  }
  fs::path file = confined_path(folder, name + ".toml");
  return is_questionnaire(file) ? std::optional(std::move(file)) : std::nullopt;
}

/// Returns the folders of questionnaires, in the order of the search. Foveola's own protocols use
/// its own questionnaires only.
std::vector<fs::path> questionnaire_folders(const fs::path& protocols) {
  std::vector<fs::path> folders{users_questionnaires(), ready_questionnaires()};
  if (is_programs_own(protocols)) {
    std::swap(folders.front(), folders.back());
  }
  return folders;
}

fs::path questionnaire_file(const std::string& name_or_path, const fs::path& folder) {
  if (is_profile_path(name_or_path)) {
    return confined_path(folder, name_or_path);
  }
  if (const std::optional<fs::path> beside = questionnaire_beside(name_or_path, folder)) {
    return *beside;
  }
  std::vector<std::string> names;
  for (const fs::path& ready : questionnaire_folders(folder)) {
    const std::vector<std::string> there = toml_names_or_none(ready);
    if (std::ranges::find(there, name_or_path) != there.end()) {
      return ready / (name_or_path + ".toml");
    }
    names.insert(names.end(), there.begin(), there.end());
  }
  throw Error(
      "questionnaire", "is not one of the ready-made ones",
      did_you_mean(name_or_path, names,
                   fmt::format("choose one of {}, or give a path", fmt::join(names, ", "))));
}

/// Reads the questionnaire of the file that the table names; an empty one if it names none.
Questionnaire read_ready_one(TomlReader& reader, const QuestionnaireFiles& files) {
  std::string name;
  reader.read("file", name,
              "A ready-made questionnaire, with the keys title, intro, source and question: the "
              "name, without .toml, of one in the protocol's folder, in "
              "~/.local/share/foveola/questionnaires or among those that come with Foveola (ssq, "
              "nasa-tlx, sus), or the path of a file in the protocol's folder or below.");
  if (!reader.has("file")) {
    return {};
  }
  if (reader.has("question")) {
    reader.fail(reader.source("question"), "the questionnaire has both a file and questions",
                "remove one of them");
  }
  try {
    return read_questionnaire_file(name, files(name));
  } catch (const std::runtime_error& reason) {
    reader.fail(reader.source("file"), fmt::format("'{}': {}", name, reason.what()),
                "name one that comes with Foveola, or a file in the folder of the protocol");
  }
}

}  // namespace

std::string read_new_id(TomlReader& reader, std::string_view meaning,
                        const std::vector<std::string>& taken) {
  const std::string id = reader.require_text("id", meaning, "^[A-Za-z0-9_-]+$");
  if (!std::ranges::all_of(id, is_id_character)) {
    reader.fail(reader.source("id"), fmt::format("'{}' is not an id", id),
                "use letters, digits, - and _ only");
  }
  if (std::ranges::find(taken, id) != taken.end()) {
    reader.fail(reader.source("id"), fmt::format("the id '{}' is used twice", id),
                "give each an id of its own");
  }
  return id;
}

std::vector<Question> read_questions(TomlReader& reader, std::string_view key,
                                     const std::vector<std::string>& taken,
                                     std::string_view meaning) {
  std::vector<Question> questions;
  std::vector<std::string> ids = taken;
  for (const TomlReader& entry : reader.tables(key, meaning)) {
    questions.push_back(read_question(entry, ids, key == "rating"));
    ids.push_back(questions.back().id);
  }
  return questions;
}

Questionnaire read_questionnaire_file(const std::string& name, const std::string& toml,
                                      TomlKeys* keys) {
  Questionnaire questionnaire{.file = name, .toml = toml};
  const toml::table content =
      parse_toml(name, toml, fmt::format("see those in {}", ready_questionnaires().string()));
  TomlReader reader(name, content, "", keys);
  reader.require("title");
  reader.require("question");
  read_content(reader, questionnaire);
  reader.reject_unknown_keys();
  require_content(reader, questionnaire);
  return questionnaire;
}

QuestionnaireFiles questionnaire_files_in(const fs::path& folder) {
  return [folder](const std::string& name) {
    return read_toml_file(questionnaire_file(name, folder));
  };
}

std::vector<Questionnaire> read_questionnaires(TomlReader& reader,
                                               const QuestionnaireFiles& files) {
  std::vector<Questionnaire> questionnaires;
  constexpr std::size_t max_questionnaires = 100;  // Each may be a large file.
  std::vector<std::string> ids{"consent", "validation", "reaction", "trials"};
  std::vector<TomlReader> entries =
      reader.tables("questionnaire", "Forms that participants fill in.");
  if (entries.size() > max_questionnaires) {
    reader.fail(reader.source("questionnaire"),
                fmt::format("the protocol has {} questionnaires; the maximum is {}", entries.size(),
                            max_questionnaires),
                "remove some");
  }
  for (TomlReader& entry : entries) {
    ids.push_back(read_new_id(entry,
                              "The questionnaire's name in records and in phases; not consent, "
                              "validation, reaction or trials.",
                              ids));
    Questionnaire questionnaire = read_ready_one(entry, files);
    questionnaire.id = ids.back();
    read_content(entry, questionnaire);
    entry.reject_unknown_keys();
    require_content(entry, questionnaire);
    questionnaires.push_back(std::move(questionnaire));
  }
  return questionnaires;
}

}  // namespace foveola::study
