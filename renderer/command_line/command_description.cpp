#include "renderer/command_line/command_description.h"

#include <algorithm>
#include <set>
#include <sstream>
#include <string_view>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "renderer/base/transformed.h"

namespace foveola {
namespace {

std::vector<std::string> words_between_commas(const std::string& text) {
  std::vector<std::string> words;
  std::istringstream list(text);
  for (std::string word; std::getline(list, word, ',');) {
    words.push_back(word);
  }
  return words;
}

/// The text between `open` and `close`; empty if `text` lacks them.
std::string between(const std::string& text, char open, char close) {
  const std::size_t begin = text.find(open);
  const std::size_t end = text.rfind(close);
  return begin < end && end != std::string::npos ? text.substr(begin + 1, end - begin - 1) : "";
}

/// "1 to 1000" from a validator's "INT in [1 - 1000]".
std::string limits_in(const std::string& validators) {
  constexpr std::string_view separator = " - ";
  std::string limits = between(validators, '[', ']');
  const std::size_t middle = limits.find(separator);
  return middle == std::string::npos ? "" : limits.replace(middle, separator.size(), " to ");
}

/// A list's default without its brackets, which are not typed.
std::string typed_default(const CLI::Option& option, bool takes_many) {
  const std::string text = option.get_default_str();
  return takes_many && text.starts_with('[') ? between(text, '[', ']') : text;
}

/// Sorted, since CLI11 orders them by their addresses.
std::vector<std::string> names_of(const std::set<CLI::Option*>& options) {
  std::vector<std::string> names;
  for (const CLI::Option* option : options) {
    if (!option->get_group().empty()) {
      names.push_back(option->get_name());
    }
  }
  std::ranges::sort(names);
  return names;
}

std::vector<std::string> names_of(const CLI::Option& option) {
  if (!option.nonpositional()) {
    return {option.get_name(true)};
  }
  std::vector<std::string> names =
      transformed(option.get_snames(), [&](const std::string& name) { return "-" + name; });
  for (const std::string& name : option.get_lnames()) {
    names.push_back("--" + name);
  }
  return names;
}

OptionDescription described(const CLI::Option& option, const std::string& group) {
  OptionDescription result{.names = names_of(option),
                           .is_required = option.get_required(),
                           .needs = names_of(option.get_needs()),
                           .excludes = names_of(option.get_excludes()),
                           .group = group,
                           .description = option.get_description()};
  if (option.get_items_expected_max() == 0) {
    return result;
  }
  const std::string type = option.get_type_name();  // "INT:INT in [1 - 9]", "TEXT:{plain,filmic}"
  const std::size_t end = std::min(type.find(':'), type.size());
  const std::string validators = type.substr(end);
  result.value_name = type.substr(0, end);
  result.takes_number =
      result.value_name == "INT" || result.value_name == "UINT" || result.value_name == "FLOAT";
  result.takes_many = option.get_expected_max() >= CLI::detail::expected_max_vector_size;
  result.choices = words_between_commas(between(validators, '{', '}'));
  result.limits = limits_in(validators);
  result.default_value = typed_default(option, result.takes_many);
  return result;
}

/// The allowed number of the group's options, in words; empty if all are.
std::string count_allowed(const CLI::App& group) {
  const std::size_t least = group.get_require_option_min();
  const std::size_t most = group.get_require_option_max();
  if (most == 0) {
    return least == 0 ? "" : fmt::format(" (at least {})", least);
  }
  return least == most ? fmt::format(" (exactly {})", most) : fmt::format(" (at most {})", most);
}

/// Adds the options of `app`, and of its groups, which are nameless commands whose own --help is
/// the command's.
void add_options(const CLI::App& app, const std::string& title, CommandDescription& command) {
  const std::string usual = CLI::OptionDefaults().get_group();
  for (const std::string& group : app.get_groups()) {
    for (const CLI::Option* option : app.get_options()) {
      const bool is_groups_help = app.get_name().empty() && option == app.get_help_ptr();
      if (group.empty() || option->get_group() != group || is_groups_help) {
        continue;
      }
      auto& options = option->nonpositional() ? command.options : command.positionals;
      options.push_back(described(*option, group == usual ? title : group));
    }
  }
  for (const CLI::App* group : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (group->get_name().empty() && !group->get_group().empty()) {
      add_options(*group, group->get_description() + count_allowed(*group), command);
    }
  }
}

}  // namespace

CommandDescription describe(const CLI::App& app) {
  CommandDescription command{
      .name = app.get_name(), .description = app.get_description(), .footer = app.get_footer()};
  add_options(app, "", command);
  for (const CLI::App* inner : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (!inner->get_name().empty() && !inner->get_group().empty()) {
      command.commands.push_back(describe(*inner));
    }
  }
  return command;
}

bool may_take_file(const OptionDescription& option) {
  return !option.value_name.empty() && !option.takes_number && option.choices.empty();
}

}  // namespace foveola
