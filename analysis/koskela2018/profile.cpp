#include "analysis/koskela2018/profile.h"

#include <fmt/format.h>

namespace foveola::analysis {
namespace {

bool has(const Dataset& set, const std::string& id, MeasureKind kind) {
  const auto found = set.measure_named(id);
  return found && set.measures[*found].kind == kind;
}

}  // namespace

bool measures_what_was_published(const Dataset& set) {
  if (!set.study.starts_with("koskela2018") || !has(set, "outline", MeasureKind::time) ||
      !has(set, "material", MeasureKind::time) || !has(set, "artifacts", MeasureKind::rating)) {
    return false;
  }
  const study::Question& rating = set.measures[*set.measure_named("artifacts")].question;
  return rating.kind == study::QuestionKind::likert && rating.minimum == 1.0 &&
         rating.maximum == 5.0;
}

bool is_relative_to_od(const Dataset& set) { return set.methods[baseline] == "od"; }

std::string meaning_of_mark(const Dataset& set, const std::string& mark) {
  if (!measures_what_was_published(set)) {
    return "";
  }
  if (mark == "outline") {
    return "The outline mark says when a participant could tell whether moving or turning the "
           "chosen object had succeeded.";
  }
  return mark == "material" ? "The material mark says when they could tell whether changing its "
                              "material had succeeded."
                            : "";
}

std::string reason_for_mark(const Dataset& set, const Measure& mark) {
  if (meaning_of_mark(set, mark.id()).empty()) {
    return fmt::format("“{}” ({})", mark.question.text, mark.id());
  }
  return mark.id() == "outline" ? "the outline of a chosen object could be judged"
                                : "its material could be judged";
}

std::string moment_of(const Dataset& set, const Measure& mark) {
  return meaning_of_mark(set, mark.id()).empty() ? "the mark " + mark.id()
                                                 : "the " + mark.id() + " was visible";
}

}  // namespace foveola::analysis
