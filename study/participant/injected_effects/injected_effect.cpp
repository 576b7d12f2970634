#include "study/participant/injected_effects/injected_effect.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>

#include <fmt/format.h>

#include "renderer/base/error.h"

namespace foveola::study {
namespace {

constexpr double largest_factor = 1e3;
constexpr double max_points = 1e6;

[[noreturn]] void refuse(std::string_view part, const std::string& what) {
  throw UsageError(fmt::format("--inject {}", part), what,
                   "write none, faster:METHOD:FACTOR, faster-mark:MARK:METHOD:FACTOR, "
                   "shift-rating:RATING:METHOD:POINTS, order:FACTOR, outlier:PARTICIPANT:FACTOR, "
                   "dropout:FRACTION or tracker-loss:FRACTION");
}

double number_from(std::string_view text, double minimum, double maximum, std::string_view part) {
  double value = std::numeric_limits<double>::quiet_NaN();
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() ||
      !(value >= minimum && value <= maximum)) {
    refuse(part, fmt::format("'{}' is not a number from {} to {}", text, minimum, maximum));
  }
  return value;
}

double factor_from(std::string_view text, std::string_view part) {
  return number_from(text, 1.0 / largest_factor, largest_factor, part);
}

/// Parses a number from -max_points to max_points, with or without a sign.
double points_from(std::string_view text, std::string_view part) {
  const bool has_plus = text.starts_with('+') && !text.starts_with("+-");
  return number_from(text.substr(has_plus ? 1 : 0), -max_points, max_points, part);
}

/// The text of one effect, split at its first and its last colon.
struct Words {
  std::string_view kind;
  std::string_view subject;  ///< Between the colons; empty if there is only one.
  std::string_view amount;
};

Words words_of(std::string_view part) {
  const std::size_t first = part.find(':');
  const std::size_t last = part.rfind(':');
  if (first == std::string_view::npos) {
    return {.kind = part};
  }
  const bool has_subject = last > first;
  return {.kind = part.substr(0, first),
          .subject = has_subject ? part.substr(first + 1, last - first - 1) : std::string_view(),
          .amount = part.substr(last + 1)};
}

/// Returns whether the effect may be repeated.
bool is_of_a_method(std::string_view kind) {
  return kind == "faster" || kind == "faster-mark" || kind == "shift-rating";
}

bool takes_subject(std::string_view kind) { return is_of_a_method(kind) || kind == "outlier"; }

void add_of_method(std::string_view method, double amount, std::string_view part,
                   InjectedEffect::ByMethod& amounts) {
  if (method.empty()) {
    refuse(part, "names no method");
  }
  if (!amounts.emplace(method, amount).second) {
    refuse(part, "is a second effect of that method");
  }
}

/// `subject`: the id of a measure, which has no colon, a colon, and a method.
void add_of_measure(std::string_view subject, double amount, std::string_view part,
                    std::map<std::string, InjectedEffect::ByMethod>& effects) {
  const std::size_t colon = std::min(subject.find(':'), subject.size());
  add_of_method(subject.substr(std::min(colon + 1, subject.size())), amount, part,
                effects[std::string(subject.substr(0, colon))]);
}

void add(std::string_view part, InjectedEffect& effect) {
  const Words words = words_of(part);
  if (takes_subject(words.kind) == words.subject.empty()) {
    refuse(part, "is not a known effect");
  }
  if (words.kind == "faster") {
    add_of_method(words.subject, factor_from(words.amount, part), part, effect.faster);
  } else if (words.kind == "faster-mark") {
    add_of_measure(words.subject, factor_from(words.amount, part), part, effect.faster_marks);
  } else if (words.kind == "shift-rating") {
    add_of_measure(words.subject, points_from(words.amount, part), part, effect.shifted_ratings);
  } else if (words.kind == "order") {
    effect.order_factor = factor_from(words.amount, part);
  } else if (words.kind == "outlier") {
    const double number = number_from(words.subject, 1.0, 1e6, part);
    if (number != std::floor(number)) {
      refuse(part, "the participant's number is not whole");
    }
    effect.outlier = {.participant = static_cast<int>(number),
                      .slower = factor_from(words.amount, part)};
  } else if (words.kind == "dropout") {
    effect.dropout_part = number_from(words.amount, 0.0, 1.0, part);
  } else if (words.kind == "tracker-loss") {
    effect.tracker_loss_part = number_from(words.amount, 0.0, 1.0, part);
  } else {
    refuse(part, "is not a known effect");
  }
}

}  // namespace

InjectedEffect parse_injected_effect(const std::string& text) {
  InjectedEffect effect;
  if (text == "none") {
    return effect;
  }
  std::vector<std::string_view> kinds;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string_view part = std::string_view(text).substr(begin, end - begin);
    const std::string_view kind = words_of(part).kind;
    if (!is_of_a_method(kind) && std::ranges::find(kinds, kind) != kinds.end()) {
      refuse(part, "is given twice");
    }
    add(part, effect);
    kinds.push_back(kind);
    begin = end + 1;
  }
  return effect;
}

}  // namespace foveola::study
