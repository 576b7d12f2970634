#include "study/protocol/amendment.h"

#include <algorithm>
#include <array>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <toml++/toml.h>

#include "renderer/base/toml/toml_file.h"

namespace foveola::study {
namespace {

/// The values by key. Empty tables and arrays are values too.
using Leaves = std::map<std::string, std::string>;

void add_leaves(const toml::node& node, const std::string& key, Leaves& leaves) {
  if (const toml::table* table = node.as_table(); table != nullptr && !table->empty()) {
    for (const auto& [name, child] : *table) {
      add_leaves(child,
                 key.empty() ? std::string(name.str()) : fmt::format("{}.{}", key, name.str()),
                 leaves);
    }
  } else if (const toml::array* array = node.as_array(); array != nullptr && !array->empty()) {
    for (std::size_t i = 0; i < array->size(); ++i) {
      add_leaves((*array)[i], fmt::format("{}[{}]", key, i), leaves);
    }
  } else {
    std::ostringstream value;
    node.visit([&](const auto& leaf) { value << leaf; });
    leaves[key] = value.str();
  }
}

Leaves leaves_of(const std::string& text, const std::filesystem::path& path,
                 const std::string& key) {
  Leaves leaves;
  add_leaves(parse_toml(path.string(), text, "see protocols/demo.toml for an example"), key,
             leaves);
  return leaves;
}

/// Patterns of keys, without the indices of arrays.
constexpr std::array words_and_times = {
    "title",
    "language",
    "texts.*",
    "mark[].instruction",
    "rating[].text",
    "rating[].labels[]",
    "rating[].options[].label",
    "questionnaire[].title",
    "questionnaire[].intro",
    "questionnaire[].question[].text",
    "questionnaire[].question[].labels[]",
    "questionnaire[].question[].options[].label",
    "timing.mark_timeout_s",
    "timing.rating_s",
    "override[].timing.mark_timeout_s",
    "override[].timing.rating_s",
    "catch_trials.timeout_s",
};

bool matches(const std::string& key, std::string_view pattern) {
  return pattern.ends_with('*') ? key.starts_with(pattern.substr(0, pattern.size() - 1))
                                : key == pattern;
}

/// Returns whether the key is an option's label that is recorded, as the option has no value.
bool is_recorded(const std::string& key, const Leaves& before, const Leaves& after) {
  constexpr std::string_view label = "].label";
  if (!key.ends_with(label)) {
    return false;
  }
  const std::string value = key.substr(0, key.size() - label.size()) + "].value";
  return !before.contains(value) || !after.contains(value);
}

bool may_change(const std::string& key, const Leaves& before, const Leaves& after) {
  static const std::regex place("\\[[0-9]+\\]");
  const std::string placeless = std::regex_replace(key, place, "[]");
  return !is_recorded(key, before, after) &&
         std::ranges::any_of(words_and_times,
                             [&](const char* pattern) { return matches(placeless, pattern); });
}

ProtocolChanges changes_between(const Leaves& old_leaves, const Leaves& new_leaves) {
  std::set<std::string> keys;
  for (const Leaves* leaves : {&old_leaves, &new_leaves}) {
    for (const auto& [key, value] : *leaves) {
      keys.insert(key);
    }
  }
  ProtocolChanges changes;
  for (const std::string& key : keys) {
    const auto was = old_leaves.find(key);
    const auto is = new_leaves.find(key);
    if (was == old_leaves.end() || is == new_leaves.end() || was->second != is->second) {
      (may_change(key, old_leaves, new_leaves) ? changes.of_words_and_times : changes.of_design)
          .push_back(key);
    }
  }
  return changes;
}

}  // namespace

ProtocolChanges changes_between(const std::string& before, const std::string& after,
                                const std::filesystem::path& path) {
  return changes_between(leaves_of(before, path, ""), leaves_of(after, path, ""));
}

ProtocolChanges changes_of_questionnaire(const std::string& before, const std::string& after,
                                         const std::string& name) {
  // As if it were in the protocol.
  const std::string key = "questionnaire[0]";
  ProtocolChanges changes =
      changes_between(leaves_of(before, name, key), leaves_of(after, name, key));
  for (std::vector<std::string>* keys : {&changes.of_words_and_times, &changes.of_design}) {
    for (std::string& changed : *keys) {
      changed.replace(0, key.size() + 1, name + ": ");
    }
  }
  return changes;
}

}  // namespace foveola::study
