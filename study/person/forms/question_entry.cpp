#include "study/person/forms/question_entry.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "renderer/base/text/utf8.h"
#include "study/person/forms/typed_number.h"

namespace foveola::study {
namespace {

constexpr std::size_t longest_number = 12;  // characters
constexpr std::size_t longest_text = 2000;

std::size_t points_of(const Question& question) {
  return static_cast<std::size_t>(std::lround(question.maximum - question.minimum)) + 1;
}

ScreenField::Kind kind_of(const Question& question) {
  switch (question.kind) {
    case QuestionKind::likert:
      return points_of(question) <= QuestionEntry::max_points ? ScreenField::Kind::scale
                                                              : ScreenField::Kind::line;
    case QuestionKind::choice:
      return ScreenField::Kind::choice;
    case QuestionKind::text:
      return ScreenField::Kind::text;
    case QuestionKind::number:
      break;
  }
  return ScreenField::Kind::line;
}

/// Returns the label of a scale's point. A question labels no point, the ends, or every point.
std::string point_words(const Question& question, std::size_t point, std::size_t points) {
  if (question.labels.size() == points) {
    return question.labels[point];
  }
  const bool is_end = point == 0 || point + 1 == points;
  if (question.labels.empty() || !is_end) {
    return {};
  }
  return point == 0 ? question.labels.front() : question.labels.back();
}

std::vector<std::string> point_labels(const Question& question) {
  const std::size_t points = points_of(question);
  std::vector<std::string> labels;
  for (std::size_t i = 0; i < points; ++i) {
    std::string label = fmt::format("{}", question.minimum + static_cast<double>(i));
    if (const std::string words = point_words(question, i, points); !words.empty()) {
      label += '\n' + words;
    }
    labels.push_back(std::move(label));
  }
  return labels;
}

std::vector<std::string> option_labels(const Question& question) {
  constexpr std::size_t max_digits = 9;
  std::vector<std::string> labels;
  for (std::size_t i = 0; i < question.options.size(); ++i) {
    const std::string& label = question.options[i].label;
    labels.push_back(i < max_digits ? fmt::format("{}  {}", i + 1, label) : label);
  }
  return labels;
}

std::vector<std::string> labels_of(const Question& question, ScreenField::Kind kind) {
  switch (kind) {
    case ScreenField::Kind::scale:
      return point_labels(question);
    case ScreenField::Kind::choice:
      return option_labels(question);
    default:
      return {};
  }
}

bool is_of_a_number(char32_t typed) {
  return (typed >= '0' && typed <= '9') || typed == '-' || typed == '.' || typed == ',';
}

}  // namespace

QuestionEntry::QuestionEntry(Question question)
    : question_(std::move(question)),
      kind_(kind_of(question_)),
      labels_(labels_of(question_, kind_)) {}

bool QuestionEntry::follow(const FormInput& input) {
  if (const auto* typed = std::get_if<char32_t>(&input)) {
    return is_listed() ? choose_by(*typed) : type(*typed);
  }
  const bool is_scale = kind_ == ScreenField::Kind::scale;
  const bool is_choice = kind_ == ScreenField::Kind::choice;
  const bool is_number = kind_ == ScreenField::Kind::line;
  switch (std::get<FormKey>(input)) {
    case FormKey::left:
      return is_number ? count(-1.0) : is_scale && move(-1);
    case FormKey::right:
      return is_number ? count(1.0) : is_scale && move(1);
    case FormKey::up:
      return is_choice && move(-1);
    case FormKey::down:
      return is_choice && move(1);
    case FormKey::erase:
      return erase();
    case FormKey::step:
      return step();
    default:
      return false;
  }
}

/// Counts from the minimum, or from the maximum, if there is no number yet.
bool QuestionEntry::count(double by) {
  const std::optional<double> from = number();
  const double next = from ? *from + by : (by > 0.0 ? question_.minimum : question_.maximum);
  typed_ = fmt::format("{}", std::clamp(next, question_.minimum, question_.maximum));
  is_counted_ = true;
  return true;
}

bool QuestionEntry::step() {
  if (kind_ == ScreenField::Kind::line) {
    if (const std::optional<double> from = number(); from && *from >= question_.maximum) {
      typed_.clear();
    }
    return count(1.0);
  }
  if (!is_listed()) {
    return false;
  }
  if (chosen_ && *chosen_ + 1 == labels_.size()) {
    chosen_.reset();
  }
  return move(1);
}

bool QuestionEntry::move(std::ptrdiff_t by) {
  const auto last = static_cast<std::ptrdiff_t>(labels_.size()) - 1;
  const std::ptrdiff_t from =
      chosen_ ? static_cast<std::ptrdiff_t>(*chosen_) : (by > 0 ? -1 : last + 1);
  chosen_ = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(from + by, 0, last));
  return true;
}

bool QuestionEntry::choose_by(char32_t typed) {
  const double digit = static_cast<double>(typed) - '0';
  const double first = kind_ == ScreenField::Kind::scale ? question_.minimum : 1.0;
  const double last = std::min(9.0, first + static_cast<double>(labels_.size()) - 1.0);
  if (digit < std::max(first, 0.0) || digit > last) {
    return false;
  }
  chosen_ = static_cast<std::size_t>(std::lround(digit - first));
  return true;
}

bool QuestionEntry::type(char32_t typed) {
  const bool is_number = kind_ == ScreenField::Kind::line;
  const bool has_room =
      is_counted_ || count_characters(typed_) < (is_number ? longest_number : longest_text);
  const bool is_printable = typed >= ' ' && typed != 0x7F;
  if (!has_room || (is_number ? !is_of_a_number(typed) : !is_printable)) {
    return false;
  }
  if (std::exchange(is_counted_, false)) {
    typed_.clear();
  }
  append_character(typed_, typed);
  return true;
}

bool QuestionEntry::erase() {
  if (is_empty()) {
    return false;
  }
  chosen_.reset();
  is_counted_ = false;
  erase_last_character(typed_);
  return true;
}

std::optional<double> QuestionEntry::number() const {
  const std::vector<double> readings = readings_of(typed_);
  return readings.size() == 1 ? std::optional(readings.front()) : std::nullopt;
}

ScreenField QuestionEntry::field() const {
  const std::string shown = shown_value();
  return {.kind = kind_,
          .question = question_.text,
          .labels = labels_,
          .chosen = chosen_,
          .typed = typed_,
          .note = chosen_ || shown == typed_ ? "" : "= " + shown};
}

std::string QuestionEntry::fault(const Texts& texts) const {
  const std::vector<double> readings =
      kind_ == ScreenField::Kind::line ? readings_of(typed_) : std::vector<double>{};
  if (readings.size() < 2) {
    return fault_of(question_, value(), texts);
  }
  const char mark = typed_[typed_.find_first_of(".,")];
  return filled(text_of(texts, "fault_ambiguous"), {{"typed", typed_},
                                                    {"decimal", unambiguous(readings[0], mark)},
                                                    {"whole", unambiguous(readings[1])}});
}

std::variant<double, std::string> QuestionEntry::value() const {
  if (chosen_ && kind_ == ScreenField::Kind::scale) {
    return question_.minimum + static_cast<double>(*chosen_);
  }
  if (chosen_) {
    const Option& option = question_.options[*chosen_];
    if (option.value) {
      return *option.value;
    }
    return option.label;
  }
  if (kind_ == ScreenField::Kind::line) {
    if (const std::optional<double> typed = number()) {
      return *typed;
    }
  }
  return typed_;
}

bool QuestionEntry::is_empty() const { return !chosen_ && typed_.empty(); }

std::string QuestionEntry::shown_value() const {
  if (!chosen_) {
    const std::variant<double, std::string> typed = value();
    const auto* const read = std::get_if<double>(&typed);
    return read != nullptr ? fmt::format("{}", *read) : typed_;
  }
  return kind_ == ScreenField::Kind::choice
             ? question_.options[*chosen_].label
             : labels_[*chosen_].substr(0, labels_[*chosen_].find('\n'));
}

}  // namespace foveola::study
