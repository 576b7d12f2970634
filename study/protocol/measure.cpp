#include "study/protocol/measure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/base/text/words.h"
#include "renderer/base/transformed.h"

namespace foveola::study {
namespace {

constexpr std::size_t max_counted_points = 20;

constexpr std::array measure_kinds{Word<MeasureKind>{"time", MeasureKind::time},
                                   Word<MeasureKind>{"response", MeasureKind::response},
                                   Word<MeasureKind>{"rating", MeasureKind::rating},
                                   Word<MeasureKind>{"answer", MeasureKind::answer}};

/// Returns a label for each point, or for the two ends.
std::string labelled_points(const Measure& measure) {
  const std::vector<double> points = measure.points();
  const std::vector<std::string>& labels = measure.question.labels;
  // A scale with too many points to list has labels at its ends.
  if (labels.size() == 2 || (points.empty() && !labels.empty())) {
    return fmt::format("{:g} {} to {:g} {}", measure.question.minimum, labels.front(),
                       measure.question.maximum, labels.back());
  }
  const std::vector<std::string> named = transformed(points, [&](const double point) {
    return fmt::format("{:g} ({})", point, measure.label_of(point));
  });
  return fmt::format("{}", fmt::join(named, ", "));
}

}  // namespace

const char* name_of(MeasureKind kind) { return word_for(measure_kinds, kind); }

std::string Measure::unit() const {
  if (is_time()) {
    return "s";
  }
  return question.kind == QuestionKind::likert ? "points" : "";
}

bool Measure::is_numeric() const {
  if (is_time()) {
    return true;
  }
  switch (question.kind) {
    case QuestionKind::likert:
    case QuestionKind::number:
      return true;
    case QuestionKind::choice:
      return std::ranges::all_of(question.options,
                                 [](const Option& option) { return option.value.has_value(); });
    case QuestionKind::text:
      break;
  }
  return false;
}

std::vector<double> Measure::points() const {
  std::vector<double> points;
  if (question.kind == QuestionKind::likert) {
    if (question.maximum - question.minimum < static_cast<double>(max_counted_points)) {
      for (double point = question.minimum; point <= question.maximum; point += 1.0) {
        points.push_back(point);
      }
    }
  } else if (question.kind == QuestionKind::choice && is_numeric()) {
    for (const Option& option : question.options) {
      points.push_back(*option.value);
    }
  }
  return points.size() <= max_counted_points ? points : std::vector<double>();
}

std::string Measure::label_of(double point) const {
  if (question.kind == QuestionKind::choice) {
    for (const Option& option : question.options) {
      if (option.value == point) {
        return option.label;
      }
    }
    return "";
  }
  const std::vector<std::string>& labels = question.labels;
  if (question.kind != QuestionKind::likert || labels.empty()) {
    return "";
  }
  if (labels.size() == 2) {
    return point == question.minimum ? labels[0] : point == question.maximum ? labels[1] : "";
  }
  const auto index = static_cast<std::size_t>(std::lround(point - question.minimum));
  return index < labels.size() ? labels[index] : "";
}

std::vector<Measure> trial_measures(const std::vector<MarkEntry>& marks,
                                    const std::vector<Question>& ratings) {
  std::vector<Measure> measures = transformed(marks, [&](const MarkEntry& mark) {
    return Measure{
        .kind = MeasureKind::time,
        .questionnaire = {},
        .question = {
            .id = mark.id, .text = mark.instruction, .kind = QuestionKind::number, .minimum = 0.0}};
  });
  for (const Question& rating : ratings) {
    measures.push_back({.kind = MeasureKind::rating, .questionnaire = {}, .question = rating});
  }
  return measures;
}

void add_response_measures(const std::vector<std::string>& rated, std::vector<Measure>& measures) {
  std::vector<Measure> times;
  const auto add = [&](const std::string& id, std::string text, bool is_required) {
    if (std::ranges::find(measures, id, &Measure::id) == measures.end()) {
      times.push_back({.kind = MeasureKind::response,
                       .questionnaire = {},
                       .question = {.id = id,
                                    .text = std::move(text),
                                    .kind = QuestionKind::number,
                                    .minimum = 0.0,
                                    .required = is_required}});
    }
  };
  const auto is_rated = [&](const std::string& id) {
    return std::ranges::find(rated, id) != rated.end();
  };
  if (is_rated("")) {
    add(looking_around_id, "From the last mark, or its time-out, until the first question came",
        true);
  }
  const auto first_rating = std::ranges::find(measures, MeasureKind::rating, &Measure::kind);
  for (auto rating = first_rating; rating != measures.end(); ++rating) {
    if (is_rated(rating->id())) {
      add(rating->id() + response_suffix,
          fmt::format("How long the question {} was shown until it was answered", rating->id()),
          rating->question.required);
    }
  }
  measures.insert(first_rating, std::make_move_iterator(times.begin()),
                  std::make_move_iterator(times.end()));
}

std::vector<Measure> measures_of(const Questionnaire& questionnaire) {
  return transformed(questionnaire.questions, [&](const Question& question) {
    return Measure{
        .kind = MeasureKind::answer, .questionnaire = questionnaire.id, .question = question};
  });
}

std::string scale_in_words(const Measure& measure) {
  if (measure.is_time()) {
    return "in seconds";
  }
  const Question& question = measure.question;
  switch (question.kind) {
    case QuestionKind::likert:
      return question.labels.empty()
                 ? fmt::format("{:g} to {:g}", question.minimum, question.maximum)
                 : labelled_points(measure);
    case QuestionKind::number:
      return fmt::format("a number from {:g} to {:g}", question.minimum, question.maximum);
    case QuestionKind::choice:
      return measure.points().empty() ? "a choice" : labelled_points(measure);
    case QuestionKind::text:
      break;
  }
  return "in words";
}

}  // namespace foveola::study
