#include "renderer/view/method_text.h"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/base/error.h"

namespace foveola {

MethodText::MethodText(std::string_view text) : text_(text) {
  const std::size_t colon = std::min(text.find(':'), text.size());
  name_ = text.substr(0, colon);
  std::string_view rest = text.substr(std::min(colon + 1, text.size()));
  while (!rest.empty()) {
    const std::size_t comma = std::min(rest.find(','), rest.size());
    const std::string_view setting = rest.substr(0, comma);
    const std::size_t equals = setting.find('=');
    if (equals == std::string_view::npos || equals == 0 || equals + 1 == setting.size()) {
      fail(fmt::format("'{}' is no setting", setting), "write KEY=VALUE");
    }
    const std::string key(setting.substr(0, equals));
    if (lookup(key) != nullptr) {
      fail(fmt::format("'{}' is set twice", key), "set it once");
    }
    settings_.emplace_back(key, setting.substr(equals + 1));
    rest.remove_prefix(std::min(comma + 1, rest.size()));
  }
}

double MethodText::number(std::string_view key, double fallback, double minimum, double maximum) {
  const std::string* value = find(key);
  if (value == nullptr) {
    return fallback;
  }
  double result = 0.0;
  const char* end = value->data() + value->size();
  const auto [stop, failure] = std::from_chars(value->data(), end, result);
  if (failure != std::errc() || stop != end || !(result >= minimum && result <= maximum)) {
    fail(fmt::format("{}={} is out of range or no number", key, *value),
         fmt::format("{} lies in [{:g}, {:g}]", key, minimum, maximum));
  }
  return result;
}

std::string MethodText::word(std::string_view key, std::string_view fallback,
                             const std::vector<std::string>& known) {
  const std::string* value = find(key);
  if (value == nullptr) {
    return std::string(fallback);
  }
  if (std::find(known.begin(), known.end(), *value) == known.end()) {
    fail(fmt::format("there is no {} '{}'", key, *value),
         fmt::format("choose one of {}", fmt::join(known, ", ")));
  }
  return *value;
}

void MethodText::reject_unknown_settings() const {
  for (const auto& [key, value] : settings_) {
    if (std::find(asked_.begin(), asked_.end(), key) == asked_.end()) {
      fail(fmt::format("there is no setting '{}' here", key),
           asked_.empty() ? fmt::format("{} has none", name_)
                          : fmt::format("there are {}", fmt::join(asked_, ", ")));
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
  const auto found = std::find_if(settings_.begin(), settings_.end(),
                                  [&](const auto& setting) { return setting.first == key; });
  return found == settings_.end() ? nullptr : &found->second;
}

}  // namespace foveola
