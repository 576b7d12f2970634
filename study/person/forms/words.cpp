#include "study/person/forms/words.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

namespace foveola::study {
namespace {

constexpr const char* consent_question = "consent";
constexpr double agrees = 1.0;

/// Paragraphs are separated by empty lines; a line break within one is a space.
std::vector<std::string> paragraphs_of(std::string_view text) {
  std::vector<std::string> paragraphs;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find("\n\n"), text.size());
    std::string paragraph(text.substr(0, end));
    std::replace(paragraph.begin(), paragraph.end(), '\n', ' ');
    if (paragraph.find_first_not_of(' ') != std::string::npos) {
      paragraphs.push_back(std::move(paragraph));
    }
    text.remove_prefix(std::min(end + 2, text.size()));
  }
  return paragraphs;
}

/// Returns the page of text `id` and its title, with these keys.
ScreenPage page_of(const std::string& id, const std::string& keys, const Texts& texts) {
  return {.title = text_of(texts, id + "_title"),
          .paragraphs = paragraphs_of(text_of(texts, id)),
          .keys = text_of(texts, keys)};
}

ScreenPage page_of(const std::string& id, const Texts& texts) {
  return page_of(id, id + "_keys", texts);
}

ScreenPage in_band(ScreenPage page) {
  page.covers_picture = false;
  return page;
}

ScreenPage band_of(const std::string& id, const Texts& texts) {
  return in_band(page_of(id, texts));
}

const char* id_of(Notice notice) {
  switch (notice) {
    case Notice::welcome:
      return "welcome";
    case Notice::loading:
      return "loading";
    case Notice::validation:
      return "validation";
    case Notice::validation_again:
      return "validation_again";
    case Notice::refused:
      return "refused";
    case Notice::practice:
      return "practice";
    case Notice::first_trial:
      return "first_trial";
    case Notice::next_scene:
      return "next_scene";
    case Notice::pause:
      return "pause";
    case Notice::withdrawn:
      return "withdrawn";
    case Notice::interrupted:
      return "interrupted";
    case Notice::goodbye:
      break;
  }
  return "goodbye";
}

/// Returns the text's id; empty if nothing is to be said.
std::optional<std::string> id_of(TimedAgain again) {
  switch (again) {
    case TimedAgain::asked_for:
      return "ready_again";
    case TimedAgain::object_out_of_view:
      return "ready_again_out_of_view";
    case TimedAgain::gaze_elsewhere:
      return "ready_again_elsewhere";
    case TimedAgain::no:
      break;
  }
  return std::nullopt;
}

}  // namespace

Form consent_form(const Texts& texts) {
  return Form({.title = text_of(texts, "consent_title"),
               .intro = paragraphs_of(text_of(texts, "consent")),
               .questions = {{.id = consent_question,
                              .text = text_of(texts, "consent_confirm"),
                              .kind = QuestionKind::choice,
                              .options = {{text_of(texts, "consent_yes"), agrees},
                                          {text_of(texts, "consent_no"), 0.0}}}}},
              texts);
}

std::vector<Answer> consent_answers() { return {{consent_question, agrees}}; }

Form questionnaire_form(const Questionnaire& questionnaire, const Texts& texts) {
  return Form({.title = questionnaire.title,
               .intro = paragraphs_of(questionnaire.intro),
               .questions = questionnaire.questions,
               .confirmation = text_of(texts, "form_confirm"),
               .confirm_keys = text_of(texts, "form_confirm_keys")},
              texts);
}

Form rating_form(const std::vector<Question>& ratings, const Texts& texts) {
  return Form({.questions = ratings,
               .confirmation = text_of(texts, "rating_confirm"),
               .confirm_keys = text_of(texts, "rating_keys"),
               .covers_picture = false},
              texts);
}

ScreenPage notice_screen(Notice notice, const Texts& texts) {
  return page_of(id_of(notice), texts);
}

ScreenPage reaction_screen(int presses, const Texts& texts) {
  ScreenPage screen = page_of("reaction", texts);
  for (std::string& paragraph : screen.paragraphs) {
    paragraph = filled(paragraph, {{"presses", fmt::format("{}", presses)}});
  }
  return screen;
}

ScreenPage reaction_wait_screen(const Texts& texts) {
  return {.title = text_of(texts, "reaction_wait")};
}

ScreenPage reaction_now_screen(const Texts& texts) {
  return {.title = text_of(texts, "reaction_now"),
          .keys = text_of(texts, "reaction_now_keys"),
          .is_signal = true};
}

ScreenPage reaction_early_screen(const Texts& texts) {
  return {.title = text_of(texts, "reaction_early")};
}

ScreenPage choosing_screen(const NamedObject& object, const Texts& texts) {
  ScreenPage screen = band_of("choosing", texts);
  screen.paragraphs.push_back(filled(text_of(texts, "choosing_object"), {{"object", object.name}}));
  return screen;
}

ScreenPage ready_screen(const std::vector<MarkEntry>& marks, const ReadyPage& page,
                        const Texts& texts) {
  ScreenPage screen = band_of("ready", texts);
  screen.title = filled(screen.title, {{"trial", fmt::format("{}", page.count.trial)},
                                       {"trials", fmt::format("{}", page.count.trials)}});
  std::vector<std::string> first;
  if (const std::optional<std::string> reason = id_of(page.again)) {
    first.push_back(text_of(texts, *reason));
  }
  first.push_back(filled(text_of(texts, page.object.is_in_view ? "ready_object" : "ready_unseen"),
                         {{"object", page.object.name}}));
  screen.paragraphs.insert(screen.paragraphs.begin(), first.begin(), first.end());
  for (std::size_t i = 0; i < marks.size(); ++i) {
    screen.paragraphs.push_back(
        filled(text_of(texts, "ready_mark"),
               {{"mark", fmt::format("{}", i + 1)}, {"instruction", marks[i].instruction}}));
  }
  return screen;
}

ScreenPage no_gaze_screen(const Texts& texts) { return band_of("no_gaze", texts); }

ScreenPage mark_taken_screen(std::size_t taken, std::size_t marks, const Texts& texts) {
  return {.title = filled(text_of(texts, "mark_taken"), {{"mark", fmt::format("{}", taken)},
                                                         {"marks", fmt::format("{}", marks)}}),
          .covers_picture = false};
}

ScreenPage look_around_screen(const Texts& texts) { return band_of("look_around", texts); }

ScreenPage retiming_screen(const Texts& texts) {
  return in_band(page_of("retiming", "form_choice_keys", texts));
}

ScreenPage stopping_screen(const Texts& texts) {
  return page_of("stopping", "form_choice_keys", texts);
}

}  // namespace foveola::study
