#include "study/protocol/reading/read_methods.h"

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/base/error.h"
#include "renderer/base/files/digest.h"
#include "renderer/base/files/file_access.h"
#include "renderer/base/transformed.h"
#include "study/protocol/measure.h"
#include "study/protocol/reading/read_settings.h"

namespace fs = std::filesystem;
namespace foveola::study {
namespace {

constexpr std::array scene_effects{Word<SceneEffects>{"random", SceneEffects::random},
                                   Word<SceneEffects>{"fixed", SceneEffects::fixed}};
constexpr std::array rating_analyses{
    Word<RatingAnalysis>{"ordinal_model", RatingAnalysis::ordinal_model},
    Word<RatingAnalysis>{"signed_ranks", RatingAnalysis::signed_ranks}};

std::vector<Measure> comparable_measures(const Protocol& protocol) {
  std::vector<Measure> measures = trial_measures(protocol.marks, protocol.ratings);
  std::erase_if(measures, [](const Measure& measure) { return !measure.is_numeric(); });
  return measures;
}

/// Returns the maximum margin that is plausibly small: a factor of times, or a range of values.
double largest_margin(const Measure& measure) {
  if (measure.kind == MeasureKind::time) {
    return 100.0;
  }
  const std::vector<double> points = measure.points();
  if (measure.question.kind != QuestionKind::choice || points.empty()) {
    return measure.question.maximum - measure.question.minimum;
  }
  const auto [low, high] = std::minmax_element(points.begin(), points.end());
  return *high - *low;
}

std::string read_measure(TomlReader& reader, const std::vector<Measure>& measures) {
  const std::string id =
      reader.require_text("measure", "The id of a mark, or of a numeric rating.");
  std::vector<std::string> known =
      transformed(measures, [&](const Measure& measure) { return measure.id(); });
  if (std::ranges::find(known, id) == known.end()) {
    reader.fail(reader.source("measure"),
                fmt::format("'{}' is not the id of a mark or a numeric rating", id),
                fmt::format("choose one of {}", fmt::join(known, ", ")));
  }
  return id;
}

PlannedComparison read_comparison(TomlReader reader, const Protocol& protocol,
                                  const std::vector<Measure>& measures) {
  PlannedComparison comparison{.measure = read_measure(reader, measures)};
  comparison.method =
      read_method_name(reader, required("method"), protocol, "One of the protocol's methods.");
  comparison.baseline = read_method_name(reader, "baseline", protocol,
                                         "Another of the protocol's methods. Default: the first.");
  if (!reader.has("baseline")) {
    comparison.baseline = protocol.methods.front();
  }
  reader.reject_unknown_keys();
  if (comparison.method == comparison.baseline) {
    reader.fail(reader.source("method"),
                fmt::format("'{}' is compared with itself", comparison.method),
                "choose another method or baseline");
  }
  return comparison;
}

/// In either direction: both have the same P-value, which the family of planned tests would count
/// twice.
bool is_same(const PlannedComparison& a, const PlannedComparison& b) {
  return a.measure == b.measure &&
         std::minmax(a.method, a.baseline) == std::minmax(b.method, b.baseline);
}

PlannedComparison reversed(const PlannedComparison& comparison) {
  return {
      .measure = comparison.measure, .method = comparison.baseline, .baseline = comparison.method};
}

std::vector<PlannedComparison> read_comparisons(TomlReader& reader, const Protocol& protocol) {
  const std::vector<Measure> measures = comparable_measures(protocol);
  std::vector<PlannedComparison> comparisons;
  for (const TomlReader& entry :
       reader.tables("primary", "The primary comparisons of the study.")) {
    const PlannedComparison next = read_comparison(entry, protocol, measures);
    if (std::ranges::any_of(comparisons,
                            [&](const PlannedComparison& other) { return is_same(other, next); })) {
      entry.fail(entry.source(), "this comparison is planned twice", "remove one of them");
    }
    comparisons.push_back(next);
  }
  return comparisons;
}

std::map<std::string, double> read_margins(TomlReader reader, const Protocol& protocol) {
  std::map<std::string, double> margins;
  for (const Measure& measure : comparable_measures(protocol)) {
    const double smallest = measure.kind == MeasureKind::time ? 1.001 : 0.001;
    std::optional<double> margin;
    reader.read(measure.id(), margin, smallest, largest_margin(measure),
                "The margin of the mark or the rating of this id.");
    if (margin) {
      margins[measure.id()] = *margin;
    }
  }
  reader.reject_unknown_keys();
  return margins;
}

bool is_in_numbers(const Question& question) {
  return question.kind == QuestionKind::likert || question.kind == QuestionKind::number;
}

std::vector<std::string> read_background(TomlReader& reader, const Protocol& protocol) {
  std::vector<std::string> known;
  for (const Questionnaire& form : protocol.questionnaires) {
    if (form.id == "background") {
      for (const Question& question : form.questions) {
        if (is_in_numbers(question)) {
          known.push_back(question.id);
        }
      }
    }
  }
  std::vector<std::string> scale;
  for (const TomlReader::Text& id : reader.texts(
           "background",
           "Numeric questions of the questionnaire background. Their mean is a participant's "
           "background. Its correlation with the speed-up in the first primary comparison of "
           "times is tested. Default: none, and no correlation.")) {
    if (std::ranges::find(known, id.value) == known.end()) {
      reader.fail(
          id.source,
          fmt::format("the questionnaire background has no numeric question '{}'", id.value),
          known.empty() ? "remove the key" : fmt::format("choose from {}", fmt::join(known, ", ")));
    }
    scale.push_back(id.value);
  }
  return scale;
}

/// Throws Error for a file out of the folder, for one that is not an image of weights, and for one
/// that is being written.
MethodFile read_method_file(const std::string& method, const std::string& file,
                            const fs::path& folder) {
  fs::path path;
  try {
    path = confined_path(folder, file);
  } catch (const std::runtime_error& reason) {
    throw Error(fmt::format("method '{}'", method),
                fmt::format("its file '{}' is {}", file, reason.what()),
                "put a copy into the folder of the protocol");
  }
  const std::string digest = sha256_of_file(path);
  auto weights = std::make_shared<const WeightImage>(read_weights(path));
  if (sha256_of_file(path) != digest) {
    throw Error(path.string(), "changed while it was being read", "try again when it is finished");
  }
  return {.method = method, .file = file, .sha256 = digest, .weights = std::move(weights)};
}

/// Code may combine each method and trial of a protocol with each other.
void require_moderate_number(const TomlReader& reader, std::size_t scenes, std::size_t methods) {
  constexpr std::size_t max_methods = 100;
  constexpr std::size_t max_trials = 1000;
  if (methods > max_methods) {
    reader.fail(reader.source("methods"),
                fmt::format("the protocol has {} methods; the maximum is {}", methods, max_methods),
                "use fewer");
  }
  if (scenes * methods > max_trials) {
    reader.fail(
        reader.source("methods"),
        fmt::format("{} scenes with {} methods make {} trials; the maximum of a session is {}",
                    scenes, methods, scenes * methods, max_trials),
        "use fewer");
  }
}

void require_moderate_length(const TomlReader& reader, const TomlReader::Text& method) {
  constexpr std::size_t longest = 1000;
  if (method.value.size() > longest) {
    reader.fail(method.source,
                fmt::format("the method has {} characters; the maximum is {}", method.value.size(),
                            longest),
                "write it shorter, or paint it as the image of a mask");
  }
}

/// Throws Error for methods that no session can use.
void require_usable(const std::string& method, const fs::path& folder,
                    std::vector<MethodFile>& files) {
  if (follows_pointer(method)) {
    throw Error(fmt::format("method '{}'", method),
                "follows a pointer, which sessions do not support",
                "fix its place with azimuth= and elevation=, or choose another method");
  }
  make_view_sampler(method, [&](const std::string& file) {
    if (find_method_file(files, method, file) == nullptr) {
      files.push_back(read_method_file(method, file, folder));
    }
    return *find_method_file(files, method, file)->weights;
  });
}

}  // namespace

std::string name_of(SceneEffects scenes) { return word_for(scene_effects, scenes); }

std::string name_of(RatingAnalysis analysis) { return word_for(rating_analyses, analysis); }

std::vector<SceneEntry> read_scenes(TomlReader& reader) {
  return transformed(
      reader.require_texts(
          "scenes",
          "The scenes, without duplicates: by names of descriptors (NAME.toml) or scene files in "
          "the protocol's folder, by names that `foveola scene list` shows, or by paths that "
          "begin in the protocol's folder."),
      [&](const TomlReader::Text& scene) {
        return SceneEntry{.name = scene.value,
                          .line = static_cast<int>(scene.source.begin.line),
                          .column = static_cast<int>(scene.source.begin.column)};
      });
}

const MethodFile* find_method_file(const std::vector<MethodFile>& files, const std::string& method,
                                   const std::string& file) {
  const auto found = std::ranges::find_if(
      files, [&](const MethodFile& known) { return known.method == method && known.file == file; });
  return found != files.end() ? &*found : nullptr;
}

void read_methods(TomlReader& reader, Protocol& protocol) {
  const std::vector<TomlReader::Text> methods = reader.require_texts(
      "methods",
      "The methods, as `foveola render --method` takes them: od, vp, fv, fv-paper, "
      "fv:acuity=linear, mask:file=a.png, without duplicates. The first is the baseline.");
  require_moderate_number(reader, protocol.scenes.size(), methods.size());
  for (const TomlReader::Text& method : methods) {
    require_moderate_length(reader, method);
    try {
      require_usable(method.value, folder_of(protocol), protocol.method_files);
    } catch (const Error& error) {
      reader.fail(method.source, error.what(), "see foveola render --help");
    }
    protocol.methods.push_back(method.value);
  }
}

AnalysisPlan read_analysis(TomlReader reader, const Protocol& protocol) {
  AnalysisPlan plan;
  reader.read("alpha", plan.alpha, 1e-6, 0.5,
              "The significance level of the primary comparisons together.");
  reader.read("participants", plan.participants, 1, 100'000, "The planned number of participants.");
  reader.read(
      "scenes", plan.scenes, scene_effects,
      "Whether comparisons of times generalise to other scenes (random: a mixed model with "
      "participants "
      "and scenes crossed) or hold for these only (fixed: a paired t test over participants).");
  reader.read("ratings", plan.ratings, rating_analyses,
              "The primary analysis of ratings: a cumulative link mixed model, which needs R, or "
              "Wilcoxon's signed ranks of the participants' means.");
  plan.background = read_background(reader, protocol);
  plan.primary = read_comparisons(reader, protocol);
  plan.equivalence_margins = read_margins(
      reader.table_by_ids(
          "equivalence_margins",
          "Margins of equivalence tests, the largest differences that do not matter: by a "
          "mark's id, a ratio of times above 1; by a rating's id, points."),
      protocol);
  reader.reject_unknown_keys();
  return plan;
}

void require_computable(TomlReader reader, const AnalysisPlan& plan) {
  if (plan.participants == 1 && !plan.primary.empty()) {
    reader.fail(reader.source("participants"),
                "a single participant cannot be tested: a comparison needs two",
                "plan more participants, or remove the comparison");
  }
  const std::vector<TomlReader> entries = reader.tables("primary");
  for (std::size_t i = 0; i < plan.primary.size(); ++i) {
    for (std::size_t other = 0; other < i; ++other) {
      if (is_same(plan.primary[i], reversed(plan.primary[other]))) {
        entries[i].fail(entries[i].source(),
                        "this comparison is planned already, in the other direction",
                        "remove one of them: a test is the same in both directions");
      }
    }
  }
}

}  // namespace foveola::study
