#include "analysis/koskela2018/published_comparison.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "analysis/koskela2018/background.h"
#include "analysis/koskela2018/own_cells.h"
#include "analysis/koskela2018/profile.h"
#include "analysis/statistics/logarithms.h"

namespace foveola::analysis {
namespace {

constexpr std::array marks = {"outline", "material"};
constexpr const char* all_scenes = "all scenes";
constexpr const char* over_scenes = "Table 2, all scenes";

Description answers_to(const std::vector<QuestionAnswers>& own, const std::string& question) {
  const auto found = std::ranges::find(own, question, &QuestionAnswers::question);
  return found == own.end() ? Description{} : found->answers;
}

std::vector<double> answers_to(const StudyTables& tables,
                               const std::vector<BackgroundAnswer>& answers,
                               const std::string& question) {
  const std::set<std::string> analysed(tables.set.participants.begin(),
                                       tables.set.participants.end());
  std::vector<double> values;
  for (const BackgroundAnswer& row : answers) {
    if (row.question == question && analysed.contains(row.participant)) {
      values.push_back(row.value);
    }
  }
  return values;
}

void compare_background(const StudyTables& tables, const std::vector<BackgroundAnswer>& answers,
                        const PublishedStudy& published, std::vector<ComparedNumber>& numbers) {
  const std::vector<QuestionAnswers> own = describe_background(tables.set, answers);
  for (const PublishedAnswers& row : published.background) {
    const Description given = answers_to(own, row.question);
    numbers.push_back({.source = "Table 1",
                       .section = "5.1",
                       .row = row.question,
                       .own_row = given.n == 0 ? "" : row.question,
                       .unit = row.question == "age" ? "years" : "points",
                       .published = published_mean(published, row.mean, row.standard_deviation),
                       .published_deviation = row.standard_deviation,
                       .study = mean_estimate(given),
                       .study_deviation = given.standard_deviation});
  }
}

void compare_times(const StudyTables& tables, const PublishedStudy& published,
                   std::vector<ComparedNumber>& numbers) {
  for (const PublishedTime& row : published.times) {
    const auto scene = scene_of(tables.set, row);
    const auto cell = cell_of(tables.set, row);
    for (const Reading reading : readings_of(row.method)) {
      const MeanAndDeviation own = cell ? mean_of_cell(tables, *cell, reading) : MeanAndDeviation{};
      numbers.push_back({.source = "Table 2",
                         .section = "5.2",
                         .row = row.scene,
                         .own_row = scene ? tables.set.scenes[*scene] : "",
                         .mark = row.mark,
                         .method = row.method,
                         .reading = name_of(reading),
                         .unit = row.method == "od" ? "s" : "%",
                         .published = published_mean(published, row.mean, row.standard_deviation),
                         .published_deviation = row.standard_deviation,
                         .study = own.mean,
                         .study_deviation = own.deviation});
    }
  }
}

/// Returns the study's own value, formed as the published one from Table 2: the geometric mean over
/// the same scenes of the means over participants. Empty unless the study has every scene.
std::optional<Estimate> over_published_scenes(const Dataset& set, const PublishedStudy& published,
                                              const std::string& mark, const std::string& method,
                                              Reading reading) {
  std::vector<LogOfMeans> means;
  for (const PublishedTime& row : published.times) {
    if (row.mark != mark || row.method != method) {
      continue;
    }
    const auto cell = cell_of(set, row);
    const auto mean = cell ? log_mean_of_cell(set, *cell, reading) : std::nullopt;
    if (!mean) {
      return std::nullopt;
    }
    means.push_back(*mean);
  }
  return means.empty() ? std::nullopt : std::optional(estimate_of(log_of_geometric_mean(means)));
}

/// Returns the geometric mean over participants and all the study's scenes: seconds of OD, else per
/// cent.
std::optional<Estimate> over_own_scenes(const StudyTables& tables, const std::string& mark,
                                        const std::string& method) {
  const auto time = mark_index(tables.set, mark);
  const auto position = position_of(tables.set.methods, method);
  if (!time || !position || !is_relative_to_od(tables.set)) {
    return std::nullopt;
  }
  const MethodTimes& times = tables.method_times_of(*time, *position);
  return *position == baseline ? times.seconds : times.percent_of_baseline;
}

void compare_over_scenes(const StudyTables& tables, const PublishedStudy& published,
                         std::vector<ComparedNumber>& numbers) {
  for (const std::string mark : marks) {
    for (const std::string method : {"od", "vp", "fv"}) {
      const auto mean = geometric_mean_of_table_2(published, mark, method);
      if (!mean) {
        continue;
      }
      ComparedNumber number{.source = over_scenes,
                            .section = "5.2",
                            .row = all_scenes,
                            .own_row = all_scenes,
                            .mark = mark,
                            .method = method,
                            .unit = method == "od" ? "s" : "%",
                            .published = {.value = *mean}};
      for (const Reading reading : readings_of(method)) {
        number.reading = name_of(reading);
        number.study = over_published_scenes(tables.set, published, mark, method, reading);
        numbers.push_back(number);
      }
      number.reading = "geometric mean";
      number.study = over_own_scenes(tables, mark, method);
      numbers.push_back(std::move(number));
    }
  }
}

ComparedNumber number_of_text(const PublishedStudy& published, const std::string& id,
                              const std::string& words) {
  const PublishedNumber& figure = published_number(published, id);
  return {.source = "text",
          .section = figure.section,
          .row = words,
          .unit = figure.unit,
          .published = {.value = figure.value}};
}

/// A ratio of times that section 5.2 states over all scenes.
struct Claim {
  const char* figure;
  const char* words;
  const char* method;     ///< Whose time is
  const char* reference;  ///< divided by this one's;
  double factor;          ///< times this.
};

constexpr std::array claims = {
    Claim{"fv_percent_of_od", "FV’s time, of OD’s", "fv", "od", 100.0},
    Claim{"speedup_fv_over_od", "FV faster than OD", "od", "fv", 1.0},
    Claim{"speedup_vp_over_od", "VP faster than OD", "od", "vp", 1.0},
    Claim{"speedup_fv_over_vp", "FV faster than VP", "vp", "fv", 1.0},
};

/// Returns the ratio over participants of their geometric means over scenes.
std::optional<Estimate> ratio_over_scenes(const StudyTables& tables, std::size_t mark,
                                          const Claim& claim) {
  const auto method = position_of(tables.set.methods, claim.method);
  const auto reference = position_of(tables.set.methods, claim.reference);
  if (!method || !reference) {
    return std::nullopt;
  }
  // Of the same participants: those with a scene in which every method's time was measured.
  std::vector<double> ratios = tables.method_times_of(mark, *method).participant_seconds;
  const std::vector<double>& divisors =
      tables.method_times_of(mark, *reference).participant_seconds;
  for (std::size_t i = 0; i < ratios.size(); ++i) {
    ratios[i] *= claim.factor / divisors.at(i);
  }
  return geometric_mean(ratios);
}

void compare_claims(const StudyTables& tables, const PublishedStudy& published,
                    std::vector<ComparedNumber>& numbers) {
  for (const Claim& claim : claims) {
    for (const std::string mark : marks) {
      ComparedNumber number = number_of_text(published, claim.figure, claim.words);
      const auto time = mark_index(tables.set, mark);
      number.own_row = all_scenes;
      number.mark = mark;
      number.reading = "geometric mean";
      number.study = time ? ratio_over_scenes(tables, *time, claim) : std::nullopt;
      numbers.push_back(std::move(number));
    }
  }
}

/// Returns the number of analysed participants who gave this answer; empty without answers.
std::optional<Estimate> number_who_answered(const std::vector<double>& answers, double wanted) {
  return answers.empty()
             ? std::nullopt
             : std::optional(Estimate{
                   answers.size(), static_cast<double>(std::ranges::count(answers, wanted)), {}});
}

void compare_participants(const StudyTables& tables, const std::vector<BackgroundAnswer>& answers,
                          const std::vector<BackgroundAnswer>& debrief,
                          const PublishedStudy& published, std::vector<ComparedNumber>& numbers) {
  const auto add = [&](const char* id, const char* words, const std::optional<Estimate>& own) {
    numbers.push_back(number_of_text(published, id, words));
    numbers.back().study = own;
  };
  const std::size_t n = tables.set.participants.size();
  add("participants", "participants", Estimate{n, static_cast<double>(n), {}});
  // The code of Table 1's second question.
  constexpr double male = 1.0;
  constexpr double female = 5.0;
  const std::vector<double> genders = answers_to(tables, answers, "gender");
  add("male", "male", number_who_answered(genders, male));
  add("female", "female", number_who_answered(genders, female));
  const std::vector<double> ages = answers_to(tables, answers, "age");
  const auto extreme = [&](auto which) {
    return ages.empty()
               ? std::nullopt
               : std::optional(Estimate{ages.size(), *which(ages.begin(), ages.end()), {}});
  };
  add("youngest_years", "youngest",
      extreme([](auto first, auto last) { return std::min_element(first, last); }));
  add("oldest_years", "oldest",
      extreme([](auto first, auto last) { return std::max_element(first, last); }));
  add("knew_setup", "knew the set-up",
      number_who_answered(answers_to(tables, debrief, "knew_setup"), 1.0));
}

/// Correlates the published questions with the difference between OD and FV, for each mark: section
/// 5.1 names neither the mark, nor the average of times, nor the correlation of P.
void compare_background_p(const StudyTables& tables, const std::vector<BackgroundAnswer>& answers,
                          const PublishedStudy& published, std::vector<ComparedNumber>& numbers) {
  const std::vector<std::string> questions = {"graphics_3d", "offline_rendering"};
  const auto fv = position_of(tables.set.methods, "fv");
  for (const std::string mark : marks) {
    ComparedNumber number = number_of_text(published, "background_p",
                                           "P of experience (questions 3 and 4) against OD − FV");
    number.mark = mark;
    number.reading = "Pearson’s r";
    if (fv && is_relative_to_od(tables.set)) {
      const BackgroundCorrelation found =
          correlate_background(tables.set, answers, questions, TimeSaved::seconds_saved,
                               *tables.set.measure_named(mark), *fv);
      if (found.pearson) {
        number.study = Estimate{found.pearson->n, found.pearson->p, {}};
      }
    }
    numbers.push_back(std::move(number));
  }
}

std::optional<bool> is_within(double value, const std::optional<Interval>& interval) {
  return interval ? std::optional(interval->low <= value && value <= interval->high) : std::nullopt;
}

}  // namespace

std::vector<ComparedNumber> compare_with_published(const study::StudyRecords& records,
                                                   const StudyTables& tables,
                                                   const PublishedStudy& published) {
  const std::vector<BackgroundAnswer> answers = background_answers(records);
  std::vector<ComparedNumber> numbers;
  compare_background(tables, answers, published, numbers);
  compare_times(tables, published, numbers);
  compare_over_scenes(tables, published, numbers);
  compare_claims(tables, published, numbers);
  compare_background_p(tables, answers, published, numbers);
  compare_participants(tables, answers, answers_in_numbers(records, "debrief"), published, numbers);
  return numbers;
}

std::optional<double> difference_of(const ComparedNumber& number) {
  return number.study ? std::optional(number.study->value - number.published.value) : std::nullopt;
}

std::optional<double> difference_of_deviations(const ComparedNumber& number) {
  return number.study_deviation && number.published_deviation
             ? std::optional(*number.study_deviation - *number.published_deviation)
             : std::nullopt;
}

std::optional<double> times_published(const ComparedNumber& number) {
  const bool is_time = number.unit == "s" || number.unit == "%" || number.unit == "times";
  return number.study && is_time ? std::optional(number.study->value / number.published.value)
                                 : std::nullopt;
}

std::optional<bool> is_study_in_published_interval(const ComparedNumber& number) {
  return number.study ? is_within(number.study->value, number.published.interval) : std::nullopt;
}

std::optional<bool> is_published_in_study_interval(const ComparedNumber& number) {
  return number.study ? is_within(number.published.value, number.study->interval) : std::nullopt;
}

}  // namespace foveola::analysis
