// A form on a participant's screen: introductory pages, a page per question, a page to submit it.
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
  std::vector<std::string> intro;  ///< paragraphs, split over pages as needed
  std::vector<Question> questions;
  std::string
      confirmation;  ///< text of the last page, with {answers} filled in; empty: no such page
  std::string confirm_keys;  ///< the help line of that page: its keys
  bool covers_picture = true;
};

/// Driven by keys alone. A page is left only with a valid answer; an optional question can also be
/// left empty.
class Form {
 public:
  /// texts: the protocol's.
  Form(FormPages pages, Texts texts);

  /// Returns whether the key had a meaning here.
  bool follow(const FormInput& input);

  /// Records that the page was visible at `time`, and since the last call unless a key was pressed
  /// in between. Called at each of its frames, and before each key. Times are of one clock.
  void was_shown(Nanoseconds time);
  /// Records that something else is shown: response times pause.
  void was_hidden() { shown_.reset(); }

  /// Returns the page without its progress, which the caller fills in.
  ScreenPage screen() const;

  /// Returns the question on this page; null on introductory pages and the submitting one.
  const Question* question() const;

  bool is_submitted() const { return is_submitted_; }
  /// Returns the answers in the questions' order, without skipped ones. A response time is the sum
  /// over all showings of its question.
  std::vector<Answer> answers() const;

 private:
  bool is_reading() const { return page_ < intro_pages_.size(); }
  bool is_confirming() const { return page_ == intro_pages_.size() + entries_.size(); }
  QuestionEntry& entry() { return entries_[page_ - intro_pages_.size()]; }
  const QuestionEntry& entry() const { return entries_[page_ - intro_pages_.size()]; }

  bool go_forward();
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
  std::optional<Nanoseconds> shown_;    ///< time at which the page was last known to be visible
  std::size_t page_ = 0;
  std::string fault_;  ///< the fault of the answer on this page, in words
  bool is_submitted_ = false;
};

/// Splits paragraphs into pages that fit on a screen of any window (max_screen_lines). Long
/// paragraphs are broken between words.
std::vector<std::vector<std::string>> split_into_pages(const std::vector<std::string>& paragraphs);

}  // namespace foveola::study
