#include "study/record/log/question_json.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include <nlohmann/json.hpp>

namespace foveola::study {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array kinds = {"likert", "number", "choice", "text"};

QuestionKind kind_named(const std::string& name) {
  const auto* found = std::find(kinds.begin(), kinds.end(), name);
  if (found == kinds.end()) {
    throw std::invalid_argument("there is no kind of question " + name);
  }
  return static_cast<QuestionKind>(found - kinds.begin());
}

Json options_json(const std::vector<Option>& options) {
  Json list = Json::array();
  for (const Option& option : options) {
    list.push_back(
        {{"label", option.label}, {"value", option.value ? Json(*option.value) : Json()}});
  }
  return list;
}

std::vector<Option> options_from(const Json& list) {
  std::vector<Option> options;
  for (const Json& json : list) {
    Option option{.label = json.at("label"), .value = {}};
    if (const Json& value = json.at("value"); !value.is_null()) {
      option.value = value.get<double>();
    }
    options.push_back(std::move(option));
  }
  return options;
}

}  // namespace

std::string question_json(const Question& question) {
  const Json json = {
      {"text", question.text},        {"kind", kinds.at(static_cast<std::size_t>(question.kind))},
      {"minimum", question.minimum},  {"maximum", question.maximum},
      {"labels", question.labels},    {"options", options_json(question.options)},
      {"required", question.required}};
  return json.dump();
}

Question question_from(const std::string& id, const std::string& json) {
  try {
    const Json values = Json::parse(json);
    return {.id = id,
            .text = values.at("text"),
            .kind = kind_named(values.at("kind")),
            .minimum = values.at("minimum"),
            .maximum = values.at("maximum"),
            .labels = values.at("labels"),
            .options = options_from(values.at("options")),
            .required = values.at("required")};
  } catch (const Json::exception& fault) {
    throw std::invalid_argument(fault.what());
  }
}

}  // namespace foveola::study
