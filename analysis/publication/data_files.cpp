#include "analysis/publication/data_files.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "analysis/dataset/wording.h"

namespace foveola::analysis {
namespace {

/// Psych-DS allows letters and digits in the values of a file's name.
std::string file_word(const std::string& name) {
  std::string word;
  std::copy_if(name.begin(), name.end(), std::back_inserter(word),
               [](unsigned char c) { return c < 0x80 && std::isalnum(c) != 0; });
  return word.empty() ? "study" : word;
}

/// Every column of the data files once: Psych-DS forbids columns that are not described.
std::vector<Column> all_columns(const TrialColumns& trials,
                                const ParticipantColumns& participants) {
  std::vector<Column> columns = trials.columns();
  std::set<std::string> described;
  for (const Column& column : columns) {
    described.insert(column.name);
  }
  for (const Column& column : participants.columns()) {
    if (described.insert(column.name).second) {
      columns.push_back(column);
    }
  }
  return columns;
}

std::string dataset_description(const StudyTables& tables, const TrialColumns& trials,
                                const ParticipantColumns& participants) {
  nlohmann::ordered_json variables = nlohmann::ordered_json::array();
  for (const Column& column : all_columns(trials, participants)) {
    nlohmann::ordered_json entry = {
        {"@type", "PropertyValue"}, {"name", column.name}, {"description", column.description}};
    if (!column.unit.empty()) {
      entry["unitText"] = column.unit;
    }
    variables.push_back(std::move(entry));
  }
  const std::string warning = data_warning(tables);
  const nlohmann::ordered_json json = {
      {"@context", "https://schema.org/"},
      {"@type", "Dataset"},
      {"name", tables.protocol_title.empty() ? tables.protocol_name : tables.protocol_title},
      {"description",
       (warning.empty() ? "" : warning + " ") +
           "Times and ratings of progressive previews, one row per trial and one per participant; "
           "protocol " +
           tables.protocol_name + ", SHA-256 " + tables.protocol_sha256},
      {"variableMeasured", variables}};
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

/// The ids as an R vector: c("outline", "material").
std::string r_vector(const Dataset& set, const std::vector<std::size_t>& measures) {
  std::vector<std::string> ids;
  for (const std::size_t measure : measures) {
    ids.push_back(fmt::format("\"{}\"", set.measures[measure].id()));
  }
  return fmt::format("c({})", fmt::join(ids, ", "));
}

/// What both scripts begin with: the trials that are analysed.
constexpr const char* reading_script =
    R"r(
trials <- read.csv("trials_long.csv", stringsAsFactors = TRUE)
trials <- trials[trials$status == "analysed", ]
if (any(trials$participant_kind != "human")) {
  message("Not people's data: ", paste(unique(trials$participant_kind), collapse = ", "))
}
)r";

constexpr const char* times_script =
    R"r(# Mixed models of log times: participants and scenes may have missing cells.
# Rscript models_times.R, in the folder of this file; needs lme4, lmerTest and emmeans.
#
# Participants differ in their ratios between methods, and so do scenes: a participant's times with
# a method, and a scene's, are not independent. Without these random effects (the interactions with
# the method) the model would count every trial as one more participant, and its intervals would be
# too short.
library(lmerTest)
library(emmeans)
)r";

constexpr const char* times_models =
    R"r(
for (mark in marks) {
  # Right-censored times are only lower bounds; they are left out here and counted.
  time <- trials[[paste0(mark, "_s")]]
  censored <- trials[[paste0(mark, "_censored")]] %in% c("true", TRUE)
  rows <- trials[!is.na(time) & !censored, ]
  rows$log_time <- log(time[!is.na(time) & !censored])
  rows <- droplevels(rows)
  cat("\n", mark, ": ", nrow(rows), " times; ", sum(censored), " right-censored\n",
      sep = "")
  if (nlevels(rows$participant) < 2 || nlevels(rows$method) < 2) {
    cat("No model: it needs two participants and two methods.\n")
    next
  }
  # With one scene there is one time for each participant and method: no interaction can be estimated.
  model <- if (nlevels(rows$scene) > 1) {
    lmer(log_time ~ method + trial_position + (1 | participant) + (1 | participant:method) +
           (1 | scene) + (1 | scene:method), data = rows)
  } else {
    lmer(log_time ~ method + trial_position + (1 | participant), data = rows)
  }
  print(VarCorr(model))
  print(anova(model))
  # Comparisons of methods, averaged over scenes: ratios of geometric mean times, with Holm's P.
  averages <- emmeans(model, ~ method, lmer.df = "satterthwaite", tran = "log")
  ratios <- pairs(averages, reverse = TRUE)
  print(confint(ratios, type = "response", adjust = "none"))
  print(test(ratios, adjust = "holm"))
}
)r";

constexpr const char* ratings_script =
    R"r(# Ordinal models of ratings: steps of the scale need not be equal.
# Rscript models_ratings.R, in the folder of this file; needs ordinal.
#
# The random effects are those of models_times.R, for the same reason.
library(ordinal)
)r";

constexpr const char* ratings_models =
    R"r(
for (rating in ratings) {
  answers <- trials[[paste0(rating, "_rating")]]
  rows <- trials[!is.na(answers), ]
  rows$rating <- ordered(answers[!is.na(answers)])
  rows <- droplevels(rows)
  cat("\n", rating, ": ", nrow(rows), " answers\n", sep = "")
  if (nlevels(rows$participant) < 2 || nlevels(rows$method) < 2 || nlevels(rows$rating) < 2) {
    cat("No model: it needs two participants, two methods and two different answers.\n")
  } else if (nlevels(rows$scene) > 1) {
    print(summary(clmm(rating ~ method + (1 | participant) + (1 | participant:method) +
                         (1 | scene) + (1 | scene:method), data = rows)))
  } else {
    # With one scene there is one rating for each participant and method: no interaction can be estimated.
    print(summary(clmm(rating ~ method + (1 | participant), data = rows)))
  }
}
)r";

}  // namespace

PsychDs psych_ds(const StudyTables& tables, const TrialColumns& trials,
                 const ParticipantColumns& participants) {
  const std::string data = "psych-ds/data/study-" + file_word(tables.protocol_name);
  return {{"psych-ds/dataset_description.json", dataset_description(tables, trials, participants)},
          data + "_type-trials_data.csv",
          data + "_type-participants_data.csv"};
}

std::vector<TextFile> r_scripts(const Dataset& set) {
  const std::string baseline_first =
      fmt::format("trials$method <- relevel(trials$method, ref = \"{}\")\n", set.methods[baseline]);
  return {{"models_times.R", std::string(times_script) + reading_script + baseline_first +
                                 fmt::format("marks <- {}\n", r_vector(set, set.times())) +
                                 times_models},
          {"models_ratings.R", std::string(ratings_script) + reading_script + baseline_first +
                                   fmt::format("ratings <- {}\n", r_vector(set, set.ratings())) +
                                   ratings_models}};
}

}  // namespace foveola::analysis
