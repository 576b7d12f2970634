// The numbers of the paper (Koskela et al. 2018): its Tables 1 and 2, and those in its text.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/dataset/dataset.h"
#include "analysis/statistics/descriptive.h"

namespace foveola::analysis {

/// A row of Table 1: answers to a question, age in years and the others in points of their scales.
struct PublishedAnswers {
  std::string question;  ///< The question's id in protocols/koskela2018.toml.
  double mean = 0.0;
  double standard_deviation = 0.0;
};

/// A cell of Table 2: the baseline "od" in seconds, the others in per cent of it and percentage
/// points.
struct PublishedTime {
  std::string scene;        ///< The published study's scene.
  std::string counterpart;  ///< Foveola's own scene in its place.
  std::string mark;         ///< "outline" or "material".
  std::string method;
  double mean = 0.0;
  double standard_deviation = 0.0;
};

/// A number in the text.
struct PublishedNumber {
  std::string id;
  double value = 0.0;
  std::string unit;     ///< Empty for counts and P.
  std::string section;  ///< As "5.2".
};

struct PublishedStudy {
  std::filesystem::path folder;  ///< that it was read from
  std::vector<PublishedAnswers> background;
  std::vector<PublishedTime> times;
  std::vector<PublishedNumber> text;
};

/// Reads table1.csv, table2.csv and text.csv of `folder`. Throws Error if one is missing or
/// malformed.
PublishedStudy read_published_study(const std::filesystem::path& folder);

/// Returns the published study, read from Foveola's data, if the set has its measures; else empty.
/// Throws Error as read_published_study.
std::optional<PublishedStudy> published_study_for(const Dataset& set);

/// Returns a number of the text. Throws Error if there is none of this id.
const PublishedNumber& published_number(const PublishedStudy& published, const std::string& id);

/// Returns the row of Table 1; null if there is none.
const PublishedAnswers* published_answers(const PublishedStudy& published,
                                          const std::string& question);

/// Returns the cell of Table 2; null if there is none. `scene` is a published one.
const PublishedTime* published_time(const PublishedStudy& published, const std::string& scene,
                                    const std::string& mark, const std::string& method);

/// Returns a published mean with its own 95 % confidence interval, mean -+ t s / sqrt(n), for the n
/// participants of section 5, under the assumption of a normal distribution, which the paper does
/// not state. It may reach below zero.
Estimate published_mean(const PublishedStudy& published, double mean, double standard_deviation);

/// Returns the geometric mean over the scenes of Table 2's means, computed here, not stated in
/// the paper. In seconds for "od", else in per cent; empty for a mark or method that Table 2 lacks.
std::optional<double> geometric_mean_of_table_2(const PublishedStudy& published,
                                                const std::string& mark, const std::string& method);

struct PublishedScene {
  std::string name;
  bool is_counterpart = false;  ///< Whether the study's scene is Foveola's own counterpart.
};

/// Returns the published scene that the study's scene is, or replaces. Empty for one that is
/// neither published nor a counterpart.
std::optional<PublishedScene> published_scene_of(const PublishedStudy& published,
                                                 const std::string& scene);

}  // namespace foveola::analysis
