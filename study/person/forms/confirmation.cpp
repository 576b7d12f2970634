#include "study/person/forms/confirmation.h"

#include "study/person/forms/words.h"

namespace foveola::study {
namespace {

constexpr double continues = 0.0;
constexpr double confirms = 1.0;

Question question_of(Confirmed what, const Texts& texts) {
  const bool is_of_timing = what == Confirmed::timing_again;
  return {.kind = QuestionKind::choice,
          .options = {
              {text_of(texts, is_of_timing ? "retiming_continue" : "stopping_continue"), continues},
              {text_of(texts, is_of_timing ? "retiming_again" : "stopping_stop"), confirms}}};
}

}  // namespace

Confirmation::Confirmation(Confirmed what, const Texts& texts)
    : what_(what), entry_(question_of(what, texts)) {
  entry_.follow(FormKey::down);
}

bool Confirmation::follow(const FormInput& input) {
  return input != FormInput(FormKey::erase) && entry_.follow(input);
}

std::optional<Event> Confirmation::chosen() const {
  if (entry_.value() != std::variant<double, std::string>(confirms)) {
    return std::nullopt;
  }
  return what_ == Confirmed::timing_again ? Event(RetimeRequested{}) : Event(Withdrawn{});
}

ScreenPage Confirmation::screen(const Texts& texts) const {
  ScreenPage screen =
      what_ == Confirmed::timing_again ? retiming_screen(texts) : stopping_screen(texts);
  screen.fields.push_back(entry_.field());
  screen.fields.back().has_focus = true;
  return screen;
}

}  // namespace foveola::study
