#include "study/protocol/analysed_measures.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "study/protocol/protocol_places.h"

namespace foveola::study {
namespace {

constexpr double lowest_point = 1.0;
constexpr double highest_point = 5.0;

std::string scale_in_words(const Question& rating) {
  switch (rating.kind) {
    case QuestionKind::likert:
      return fmt::format("is a scale from {} to {}", rating.minimum, rating.maximum);
    case QuestionKind::number:
      return fmt::format("is a number from {} to {}", rating.minimum, rating.maximum);
    case QuestionKind::choice:
      return fmt::format("is a choice of {} options", rating.options.size());
    case QuestionKind::text:
      break;
  }
  return "is answered in words";
}

/// The key that makes the rating another one than a scale from 1 to 5.
std::string wrong_key(const Question& rating) {
  if (rating.kind != QuestionKind::likert) {
    return "kind";
  }
  return rating.maximum != highest_point ? "maximum" : "minimum";
}

void add_unanalysable_ratings(const Protocol& protocol, const ProtocolPlaces& places,
                              std::vector<Error>& faults) {
  for (std::size_t i = 0; i < protocol.ratings.size(); ++i) {
    const Question& rating = protocol.ratings[i];
    if (rating.id == analysed_rating && !is_analysed(rating)) {
      faults.emplace_back(
          places.of(fmt::format("rating[{}].{}", i, wrong_key(rating))),
          fmt::format("the rating {} {}, and the analysis reads whole points from 1 to 5",
                      rating.id, scale_in_words(rating)),
          "make it a scale from 1 to 5, whose labels are up to you, or give it another id: it then "
          "comes out in the record only");
    }
  }
}

/// The remedy for a plan that names a measure without tables.
std::string remedy_for_plan(const std::vector<std::string>& analysed) {
  return analysed.empty() ? "leave it out, and compare it yourself in the record"
                          : fmt::format(
                                "plan only for {}, and compare this one yourself in the "
                                "record",
                                fmt::join(analysed, ", "));
}

void add_unanalysable_plans(const Protocol& protocol, const ProtocolPlaces& places,
                            std::vector<Error>& faults) {
  const std::vector<std::string> analysed = analysed_measures(protocol);
  const auto is_carried = [&](const std::string& measure) {
    return std::find(analysed.begin(), analysed.end(), measure) != analysed.end();
  };
  const AnalysisPlan& plan = protocol.analysis;
  for (std::size_t i = 0; i < plan.primary.size(); ++i) {
    if (const std::string& measure = plan.primary[i].measure; !is_carried(measure)) {
      faults.emplace_back(
          places.of(fmt::format("analysis.primary[{}].measure", i)),
          fmt::format("a comparison of {} is planned, of which the analysis has no tables",
                      measure),
          remedy_for_plan(analysed));
    }
  }
  for (const auto& [measure, margin] : plan.equivalence_margins) {
    if (!is_carried(measure)) {
      faults.emplace_back(
          places.of("analysis.equivalence_margins." + measure),
          fmt::format("an equivalence of {} is planned, of which the analysis has no tables",
                      measure),
          remedy_for_plan(analysed));
    }
  }
}

/// Whether none of the question's answers is a number.
bool is_answered_in_words(const Question& question) {
  return question.kind == QuestionKind::text ||
         (question.kind == QuestionKind::choice &&
          std::none_of(question.options.begin(), question.options.end(),
                       [](const Option& option) { return option.value.has_value(); }));
}

/// Collects what comes out in the record only.
class RecordedOnly {
 public:
  explicit RecordedOnly(const Protocol& protocol) : places_(protocol) {}

  void add(const std::string& toml_path, const std::string& what) {
    found_.push_back(
        fmt::format("{}: the analysis has no tables of {}, which comes out in the record only",
                    places_.of(toml_path), what));
  }

  /// Marks or ratings.
  template <typename Measures>
  void add_unanalysed(const Measures& measures, const std::string& kind) {
    for (std::size_t i = 0; i < measures.size(); ++i) {
      if (!is_analysed(measures[i])) {
        add(fmt::format("{}[{}].id", kind, i), fmt::format("the {} {}", kind, measures[i].id));
      }
    }
  }

  void add_words_of(const Questionnaire& questionnaire, const std::string& toml_path) {
    for (std::size_t i = 0; i < questionnaire.questions.size(); ++i) {
      const Question& question = questionnaire.questions[i];
      if (is_answered_in_words(question)) {
        const bool is_of_a_file = !questionnaire.file.empty();
        add(is_of_a_file ? toml_path + ".file" : fmt::format("{}.question[{}].id", toml_path, i),
            fmt::format("what is answered in words to {}.{}", questionnaire.id, question.id));
      }
    }
  }

  const std::vector<std::string>& found() const { return found_; }

 private:
  ProtocolPlaces places_;
  std::vector<std::string> found_;
};

}  // namespace

bool is_analysed(const MarkEntry& mark) {
  return std::find(analysed_marks.begin(), analysed_marks.end(), mark.id) != analysed_marks.end();
}

bool is_analysed(const Question& rating) {
  return rating.id == analysed_rating && rating.kind == QuestionKind::likert &&
         rating.minimum == lowest_point && rating.maximum == highest_point;
}

std::vector<std::string> analysed_measures(const Protocol& protocol) {
  std::vector<std::string> measures;
  for (const MarkEntry& mark : protocol.marks) {
    if (is_analysed(mark)) {
      measures.push_back(mark.id);
    }
  }
  for (const Question& rating : protocol.ratings) {
    if (is_analysed(rating)) {
      measures.push_back(rating.id);
    }
  }
  return measures;
}

std::vector<Error> unanalysable(const Protocol& protocol) {
  const ProtocolPlaces places(protocol);
  std::vector<Error> faults;
  add_unanalysable_ratings(protocol, places, faults);
  add_unanalysable_plans(protocol, places, faults);
  return faults;
}

std::vector<std::string> recorded_only(const Protocol& protocol) {
  RecordedOnly only(protocol);
  only.add_unanalysed(protocol.marks, "mark");
  only.add_unanalysed(protocol.ratings, "rating");
  for (std::size_t i = 0; i < protocol.questionnaires.size(); ++i) {
    const Questionnaire& questionnaire = protocol.questionnaires[i];
    const std::string toml_path = fmt::format("questionnaire[{}]", i);
    if (questionnaire.id == analysed_questionnaire) {
      only.add_words_of(questionnaire, toml_path);
    } else {
      only.add(toml_path + ".id", "the questionnaire " + questionnaire.id);
    }
  }
  if (protocol.catch_trials.count > 0) {
    only.add("catch_trials.count", "what is marked in catch trials");
  }
  return only.found();
}

}  // namespace foveola::study
