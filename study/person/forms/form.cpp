#include "study/person/forms/form.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/base/text/utf8.h"

namespace foveola::study {
namespace {

std::size_t lines_of(std::string_view paragraph) {
  return count_characters(paragraph) / screen_line_characters + 1;
}

/// Returns the bytes of the paragraph's beginning that fill a page, up to a space.
std::size_t bytes_of_a_page(std::string_view paragraph) {
  const std::size_t most =
      bytes_of_first(paragraph, (max_screen_lines - 1) * screen_line_characters);
  const std::size_t space = paragraph.rfind(' ', most);
  return space != std::string_view::npos && space > 0 ? space : most;
}

/// Paragraphs of at most a page each.
std::vector<std::string> short_paragraphs(const std::vector<std::string>& paragraphs) {
  std::vector<std::string> result;
  for (std::string_view rest : paragraphs) {
    while (lines_of(rest) > max_screen_lines) {
      const std::size_t bytes = bytes_of_a_page(rest);
      result.emplace_back(rest.substr(0, bytes));
      rest.remove_prefix(std::min(rest.find_first_not_of(' ', bytes), rest.size()));
    }
    result.emplace_back(rest);
  }
  return result;
}

std::vector<QuestionEntry> entries_of(std::vector<Question> questions, const Texts& texts) {
  std::vector<QuestionEntry> entries;
  entries.reserve(questions.size());
  for (Question& question : questions) {
    if (!question.required) {
      question.text += ' ' + text_of(texts, "form_optional");
    }
    entries.emplace_back(std::move(question));
  }
  return entries;
}

}  // namespace

std::vector<std::vector<std::string>> split_into_pages(const std::vector<std::string>& paragraphs) {
  std::vector<std::vector<std::string>> pages;
  std::size_t lines = 0;
  for (std::string& paragraph : short_paragraphs(paragraphs)) {
    lines += lines_of(paragraph) + 1;  // plus an empty line
    if (pages.empty() || lines > max_screen_lines + 1) {
      pages.emplace_back();
      lines = lines_of(paragraph) + 1;
    }
    pages.back().push_back(std::move(paragraph));
  }
  return pages;
}

Form::Form(FormPages pages, Texts texts)
    : pages_(std::move(pages)),
      texts_(std::move(texts)),
      intro_pages_(split_into_pages(pages_.intro)),
      entries_(entries_of(pages_.questions, texts_)),
      shown_for_(entries_.size()) {}

void Form::was_shown(Nanoseconds time) {
  if (shown_ && question() != nullptr) {
    shown_for_[page_ - intro_pages_.size()] += time - *shown_;
  }
  shown_ = time;
}

bool Form::follow(const FormInput& input) {
  if (is_submitted_) {
    return false;
  }
  if (input == FormInput(back_key())) {
    return go_back();
  }
  if (is_confirming()) {
    is_submitted_ = input == FormInput(FormKey::enter);
    return is_submitted_;
  }
  if (input == FormInput(FormKey::enter) || input == FormInput(FormKey::tab)) {
    return go_forward();
  }
  if (is_reading() || !entry().follow(input)) {
    return false;
  }
  fault_.clear();
  return true;
}

bool Form::go_forward() {
  if (!is_reading()) {
    fault_ = entry().fault(texts_);
    if (!fault_.empty()) {
      return true;
    }
  }
  const bool is_last = page_ + 1 == intro_pages_.size() + entries_.size();
  if (is_last && pages_.confirmation.empty()) {
    is_submitted_ = true;
  } else {
    turn_to(page_ + 1);
  }
  return true;
}

bool Form::go_back() {
  if (page_ == 0) {
    return false;
  }
  fault_.clear();
  turn_to(page_ - 1);
  return true;
}

void Form::turn_to(std::size_t page) {
  page_ = page;
  shown_.reset();
}

const Question* Form::question() const {
  return is_reading() || is_confirming() ? nullptr : &entry().question();
}

/// Left goes back where up selects an option.
FormKey Form::back_key() const {
  const bool is_list =
      !is_reading() && !is_confirming() && entry().question().kind == QuestionKind::choice;
  return is_list ? FormKey::left : FormKey::up;
}

ScreenPage Form::screen() const {
  ScreenPage screen = is_reading()      ? reading_screen()
                      : is_confirming() ? confirming_screen()
                                        : question_screen();
  screen.covers_picture = pages_.covers_picture;
  return screen;
}

ScreenPage Form::reading_screen() const {
  return {.title = pages_.title,
          .paragraphs = intro_pages_[page_],
          .keys = keys_of(text_of(texts_, "form_reading_keys"))};
}

ScreenPage Form::question_screen() const {
  const std::size_t number = page_ - intro_pages_.size() + 1;
  const bool is_counted = !pages_.title.empty() && entries_.size() > 1;
  ScreenField field = entry().field();
  const char* const keys = field.kind == ScreenField::Kind::scale    ? "form_scale_keys"
                           : field.kind == ScreenField::Kind::choice ? "form_choice_keys"
                                                                     : "form_typing_keys";
  field.fault = fault_;
  field.has_focus = true;
  return {.title = is_counted ? filled(text_of(texts_, "form_title"),
                                       {{"title", pages_.title},
                                        {"question", fmt::format("{}", number)},
                                        {"questions", fmt::format("{}", entries_.size())}})
                              : pages_.title,
          .fields = {std::move(field)},
          .keys = keys_of(text_of(texts_, keys))};
}

ScreenPage Form::confirming_screen() const {
  ScreenPage screen{.title = pages_.title,
                    .paragraphs = {filled(pages_.confirmation, {{"answers", shown_answers()}})},
                    .keys = keys_of(pages_.confirm_keys)};
  const auto left_out = std::count_if(entries_.begin(), entries_.end(),
                                      [](const QuestionEntry& one) { return one.is_empty(); });
  if (left_out > 0) {
    screen.paragraphs.push_back(
        filled(text_of(texts_, "form_left_out"), {{"count", fmt::format("{}", left_out)}}));
  }
  return screen;
}

std::string Form::keys_of(std::string_view text) const {
  std::string keys(text);
  if (page_ > 0) {
    keys +=
        "    " + text_of(texts_, back_key() == FormKey::left ? "form_back_left" : "form_back_up");
  }
  return keys;
}

std::string Form::shown_answers() const {
  std::vector<std::string> shown;
  for (const QuestionEntry& one : entries_) {
    shown.push_back(one.is_empty() ? "–" : one.shown_value());
  }
  return fmt::format("{}", fmt::join(shown, ", "));
}

std::vector<Answer> Form::answers() const {
  std::vector<Answer> answers;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (const QuestionEntry& one = entries_[i]; !one.is_empty()) {
      const bool is_timed = shown_for_[i] > Nanoseconds(0);
      answers.push_back({.question = one.question().id,
                         .value = one.value(),
                         .response = is_timed ? std::optional(shown_for_[i]) : std::nullopt});
    }
  }
  return answers;
}

}  // namespace foveola::study
