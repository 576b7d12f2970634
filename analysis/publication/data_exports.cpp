#include <algorithm>
#include <cctype>
#include <set>

#include <nlohmann/json.hpp>

#include "analysis/publication/trial_data.h"
#include "analysis/publication/wording.h"

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
std::vector<Variable> all_variables(const StudyTables& tables,
                                    const std::vector<study::BackgroundRow>& answers) {
  std::vector<Variable> variables = trial_variables(tables.set.rating_scale);
  std::set<std::string> described;
  for (const Variable& variable : variables) {
    described.insert(variable.name);
  }
  for (Variable& variable : participant_variables(tables.set, answers)) {
    if (described.insert(variable.name).second) {
      variables.push_back(std::move(variable));
    }
  }
  return variables;
}

std::string dataset_description(const StudyTables& tables,
                                const std::vector<study::BackgroundRow>& answers) {
  nlohmann::ordered_json variables = nlohmann::ordered_json::array();
  for (const Variable& variable : all_variables(tables, answers)) {
    nlohmann::ordered_json entry = {
        {"@type", "PropertyValue"}, {"name", variable.name}, {"description", variable.description}};
    if (!variable.unit.empty()) {
      entry["unitText"] = variable.unit;
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

trials <- read.csv("trials_long.csv", stringsAsFactors = TRUE)
if (any(trials$participant_kind != "human")) {
  message("Not people's data: ", paste(unique(trials$participant_kind), collapse = ", "))
}
trials$method <- relevel(trials$method, ref = as.character(trials$method[1]))

for (mark in c("outline", "material")) {
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
    R"r(# Ordinal models of artifact ratings: steps of the scale need not be equal.
# Rscript models_ratings.R, in the folder of this file; needs ordinal.
#
# The random effects are those of models_times.R, for the same reason.
library(ordinal)

trials <- read.csv("trials_long.csv", stringsAsFactors = TRUE)
if (any(trials$participant_kind != "human")) {
  message("Not people's data: ", paste(unique(trials$participant_kind), collapse = ", "))
}
trials$method <- relevel(trials$method, ref = as.character(trials$method[1]))
trials <- trials[!is.na(trials$artifacts_rating), ]
trials$rating <- ordered(trials$artifacts_rating, levels = 1:5)
trials <- droplevels(trials)
if (nlevels(trials$participant) < 2 || nlevels(trials$method) < 2) {
  cat("No model: it needs two participants and two methods.\n")
} else if (nlevels(trials$scene) > 1) {
  print(summary(clmm(rating ~ method + (1 | participant) + (1 | participant:method) +
                       (1 | scene) + (1 | scene:method), data = trials)))
} else {
  # With one scene there is one rating for each participant and method: no interaction can be estimated.
  print(summary(clmm(rating ~ method + (1 | participant), data = trials)))
}
)r";

}  // namespace

PsychDs psych_ds(const StudyTables& tables, const std::vector<study::BackgroundRow>& answers) {
  const std::string data = "psych-ds/data/study-" + file_word(tables.protocol_name);
  return {{"psych-ds/dataset_description.json", dataset_description(tables, answers)},
          data + "_type-trials_data.csv",
          data + "_type-participants_data.csv"};
}

std::vector<TextFile> r_scripts() {
  return {{"models_times.R", times_script}, {"models_ratings.R", ratings_script}};
}

}  // namespace foveola::analysis
