// A form on a participant's screen: pages of words, a question a page, and one to hand it in.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "renderer/base/clock.h"
#include "study/person/forms/question_entry.h"
#include "study/protocol/texts.h"

namespace foveola::study {

struct FormPages {
  std::string title;
  std::vector<std::string> intro;  ///< paragraphs; over as many pages as they take
  std::vector<Question> questions;
  std::string confirmation;  ///< on the last page, {answers} filled in; none: there is no such page
  std::string confirm_keys;  ///< which keys do what there
  bool covers_picture = true;
};

/// Driven by keys alone. A page is left only with an answer that is one; a question that need not
/// be answered can be left without.
class Form {
 public:
  /// texts: the protocol's.
  Form(FormPages pages, Texts texts);

  /// Returns whether the key meant something here.
  bool follow(const FormInput& input);

  /// The page was on the display at `time`, and since the call before if nothing was pressed
  /// meanwhile. Called at each of its frames, and before each key. Times are of one clock.
  void was_shown(Nanoseconds time);
  /// Something else is shown: no response time runs.
  void was_hidden() { shown_.reset(); }

  /// The page without its progress, which others fill in.
  ScreenPage screen() const;

  /// The question on this page; none where there is only something to read or to hand in.
  const Question* question() const;

  bool is_submitted() const { return is_submitted_; }
  /// The answers in the questions' order, without those that were left out. The response time is
  /// that of all of the question's showings.
  std::vector<Answer> answers() const;

 private:
  bool is_reading() const { return page_ < intro_pages_.size(); }
  bool is_confirming() const { return page_ == intro_pages_.size() + entries_.size(); }
  QuestionEntry& entry() { return entries_[page_ - intro_pages_.size()]; }
  const QuestionEntry& entry() const { return entries_[page_ - intro_pages_.size()]; }

  bool go_on();
  bool go_back();
  void turn_to(std::size_t page);
  FormKey back_key() const;

  ScreenPage reading_screen() const;
  ScreenPage question_screen() const;
  ScreenPage confirming_screen() const;
  std::string keys_of(std::string_view text) const;
  std::string shown_answers() const;

  FormPages pages_;
  Texts texts_;
  std::vector<std::vector<std::string>> intro_pages_;
  std::vector<QuestionEntry> entries_;
  std::vector<Nanoseconds> shown_for_;  ///< [entry]
  std::optional<Nanoseconds> shown_;    ///< when the page was last known to be on the display
  std::size_t page_ = 0;
  std::string fault_;  ///< what is wrong with the answer on this page
  bool is_submitted_ = false;
};

/// Paragraphs over as many pages as a screen of any window needs for them (screen_lines); long ones
/// are broken between words.
std::vector<std::vector<std::string>> pages_of(const std::vector<std::string>& paragraphs);

}  // namespace foveola::study
