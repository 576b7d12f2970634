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
  if (!has(set, "outline", MeasureKind::time) || !has(set, "material", MeasureKind::time) ||
      !has(set, "artifacts", MeasureKind::rating)) {
    return false;
  }
  const study::Question& rating = set.measures[*set.measure_named("artifacts")].question;
  return rating.kind == study::QuestionKind::likert && rating.minimum == 1.0 &&
         rating.maximum == 5.0;
}

bool is_relative_to_od(const Dataset& set) { return set.methods[baseline] == "od"; }

std::string meaning_of_mark(const std::string& mark) {
  if (mark == "outline") {
    return "The outline mark says when a participant could tell whether moving or turning the "
           "chosen object had succeeded.";
  }
  return mark == "material" ? "The material mark says when they could tell whether changing its "
                              "material had succeeded."
                            : "";
}

std::string reason_for_mark(const Measure& mark) {
  if (mark.id() == "outline") {
    return "the outline of a chosen object could be judged";
  }
  return mark.id() == "material" ? "its material could be judged"
                                 : fmt::format("“{}” ({})", mark.question.text, mark.id());
}

std::string moment_of(const Measure& mark) {
  return meaning_of_mark(mark.id()).empty() ? "the mark " + mark.id()
                                            : "the " + mark.id() + " was visible";
}

}  // namespace foveola::analysis
