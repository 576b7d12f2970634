#include "renderer/view/method_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/base/error.h"
#include "renderer/base/text/similar_word.h"

namespace foveola {
namespace {

constexpr std::string_view hybrid_prefix = "hybrid:";

/// The first place of `separator` outside quotes, or the size of `text`.
std::size_t find_unquoted(std::string_view text, char separator) {
  bool is_quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '"') {
      is_quoted = !is_quoted;
    } else if (text[i] == separator && !is_quoted) {
      return i;
    }
  }
  return text.size();
}

/// Removes the part before `separator` from the front of `rest`.
std::string_view take(std::string_view& rest, char separator) {
  const std::string_view first = rest.substr(0, find_unquoted(rest, separator));
  rest.remove_prefix(std::min(first.size() + 1, rest.size()));
  return first;
}

std::string_view without_quotes(std::string_view value) {
  const bool is_quoted = value.size() >= 2 && value.front() == '"' && value.back() == '"';
  return is_quoted ? value.substr(1, value.size() - 2) : value;
}

}  // namespace

MethodText::MethodText(std::string_view text) : text_(text) {
  const std::size_t colon = std::min(text.find(':'), text.size());
  name_ = text.substr(0, colon);
  std::string_view rest = text.substr(std::min(colon + 1, text.size()));
  while (!rest.empty()) {
    const std::string_view setting = take(rest, ',');
    const std::size_t equals = std::min(setting.find('='), setting.size());
    const std::string key(setting.substr(0, equals));
    const std::string_view value =
        without_quotes(setting.substr(std::min(equals + 1, setting.size())));
    if (key.empty() || value.empty() || value.find('"') != std::string_view::npos) {
      fail(fmt::format("'{}' is not a setting", setting),
           "write KEY=VALUE, in double quotes a value with commas or pluses");
    }
    if (lookup(key) != nullptr) {
      fail(fmt::format("'{}' is set twice", key), "set it once");
    }
    settings_.emplace_back(key, value);
  }
}

double MethodText::number(std::string_view key, double fallback, double minimum, double maximum) {
  return number(key, minimum, maximum).value_or(fallback);
}

std::optional<double> MethodText::number(std::string_view key, double minimum, double maximum) {
  const std::string* value = find(key);
  if (value == nullptr) {
    return std::nullopt;
  }
  double result = 0.0;
  const char* end = value->data() + value->size();
  const auto [stop, failure] = std::from_chars(value->data(), end, result);
  if (failure != std::errc() || stop != end || !(result >= minimum && result <= maximum)) {
    fail(fmt::format("{}={} is out of range or not a number", key, *value),
         fmt::format("{} lies in [{:g}, {:g}]", key, minimum, maximum));
  }
  return result;
}

std::string MethodText::required(std::string_view key, std::string_view what) {
  const std::string* value = find(key);
  if (value == nullptr) {
    fail(fmt::format("{} is missing", what), fmt::format("add {}=...", key));
  }
  return *value;
}

std::string MethodText::word(std::string_view key, std::string_view fallback,
                             const std::vector<std::string>& known) {
  const std::string* value = find(key);
  if (value == nullptr) {
    return std::string(fallback);
  }
  if (std::ranges::find(known, *value) == known.end()) {
    fail(fmt::format("'{}' is not a value of {}", *value, key),
         did_you_mean(*value, {known.begin(), known.end()},
                      fmt::format("choose one of {}", fmt::join(known, ", "))));
  }
  return *value;
}

void MethodText::reject_unknown_settings() const {
  for (const auto& [key, value] : settings_) {
    if (std::ranges::find(asked_, key) == asked_.end()) {
      fail(fmt::format("'{}' is not a setting", key),
           asked_.empty() ? fmt::format("{} has no settings", name_)
                          : did_you_mean(key, asked_,
                                         fmt::format("settings are {}", fmt::join(asked_, ", "))));
    }
  }
}

void MethodText::fail(const std::string& what, const std::string& remedy) const {
  throw Error(fmt::format("method '{}'", text_), what, remedy);
}

const std::string* MethodText::find(std::string_view key) {
  asked_.emplace_back(key);
  return lookup(key);
}

const std::string* MethodText::lookup(std::string_view key) const {
  const auto found =
      std::ranges::find_if(settings_, [&](const auto& setting) { return setting.first == key; });
  return found == settings_.end() ? nullptr : &found->second;
}

bool is_hybrid(std::string_view method) { return method.starts_with(hybrid_prefix); }

std::vector<HybridPart> hybrid_parts(std::string_view method) {
  const auto fail = [&](const std::string& what,
                        const std::string& remedy = "write for instance hybrid:0.9*fv+0.1*od") {
    return Error(fmt::format("method '{}'", method), what, remedy);
  };
  std::vector<HybridPart> parts;
  std::string_view rest = method.substr(hybrid_prefix.size());
  while (!rest.empty()) {
    const std::string_view part = take(rest, '+');
    const std::size_t star = part.find('*');
    if (star == std::string_view::npos) {
      throw fail(fmt::format("'{}' is not a WEIGHT*METHOD", part));
    }
    double weight = 0.0;
    const auto [stop, failure] = std::from_chars(part.data(), part.data() + star, weight);
    if (failure != std::errc() || stop != part.data() + star || !(weight > 0.0) ||
        !std::isfinite(weight)) {
      throw fail(fmt::format("'{}' is not a positive weight", part.substr(0, star)));
    }
    const std::string_view written = part.substr(star + 1);
    if (is_hybrid(written)) {
      throw fail("the end of the hybrid within it is ambiguous",
                 "put it in quotes, as in hybrid:0.6*\"hybrid:0.9*fv+0.1*od\"+0.4*vp");
    }
    parts.push_back({weight, without_quotes(written)});
  }
  if (parts.empty()) {
    throw fail("there are no parts");
  }
  return parts;
}

}  // namespace foveola
