#include "renderer/commands/typed_command.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <optional>
#include <system_error>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/base/error.h"
#include "renderer/base/text/similar_word.h"
#include "renderer/base/transformed.h"
#include "renderer/command_line/command_description.h"

namespace foveola {
namespace {

/// The number in the whole of `text`, as the C library reads it.
std::optional<double> number_in(const std::string& text) {
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  return !text.empty() && *end == '\0' ? std::optional(number) : std::nullopt;
}

std::string no_number(const std::string& text) {
  char* end = nullptr;
  std::strtod(text.c_str(), &end);
  const bool has_unit = end != text.c_str();
  return fmt::format("'{}' is not a number{}", text,
                     has_unit ? fmt::format("; leave out '{}'", end) : "");
}

/// In CLI11's form: the fault of `text`, or empty.
std::string check_number(std::string& text) { return number_in(text) ? "" : no_number(text); }

/// Rewrites a number for CLI11, which clamps, wraps and reads 010 as octal: 1e6 as 1000000.
template <typename Number>
std::string check_whole_number(std::string& text) {
  constexpr double largest = 9007199254740992.0;  // Beyond it doubles skip integers.
  const std::optional<double> number = number_in(text);
  if (!number) {
    return no_number(text);
  }
  std::string digits = text.starts_with('+') ? text.substr(1) : text;
  if (text.find_first_of(".eE") != std::string::npos) {
    if (*number != std::trunc(*number)) {
      return fmt::format("'{}' is not a whole number", text);
    }
    if (std::abs(*number) >= largest) {
      return fmt::format("'{}' is not a whole number that is exact: write its digits alone", text);
    }
    digits = fmt::format("{:.0f}", *number);
  }
  Number whole = 0;
  const char* const end = digits.data() + digits.size();
  const auto [rest, fault] = std::from_chars(digits.data(), end, whole);
  if (fault != std::errc() || rest != end) {
    return fmt::format("'{}' is not a whole number from {} to {}", text,
                       std::numeric_limits<Number>::min(), std::numeric_limits<Number>::max());
  }
  text = fmt::format("{}", whole);
  return {};
}

void state_default(CLI::Option& option) {
  if (!option.get_required() && option.get_description().find("default") == std::string::npos) {
    option.capture_default_str();
  }
  if (option.get_default_str() == "[]") {
    option.default_str("");
  }
}

std::vector<std::string> command_names(const CLI::App& app) {
  return transformed(foveola::describe(app).commands, &CommandDescription::name);
}

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const OptionDescription& option : foveola::describe(app).options) {
    std::ranges::copy_if(option.names, std::back_inserter(names),
                         [](const std::string& name) { return name.starts_with("--"); });
  }
  return names;
}

const CLI::App& last_command(const CLI::App& app) {
  const std::vector<CLI::App*> typed = app.get_subcommands();
  return typed.empty() ? app : last_command(*typed.back());
}

std::string see_help(const CLI::App& app) {
  return fmt::format("see {} --help", typed_command(app));
}

std::string text_of_extras(const CLI::App& app) {
  const CLI::App& command = last_command(app);
  const std::vector<std::string> extras = app.remaining(true);
  std::string remedy = see_help(app);
  for (const std::string& extra : extras) {
    if (extra.starts_with("--shard")) {
      remedy =
          fmt::format("parts of {} could not be merged, so it cannot be split", typed_command(app));
      break;
    }
    if (const auto meant = similar_word(extra.substr(0, extra.find('=')), option_names(command))) {
      remedy = fmt::format("did you mean {}? {}", *meant, remedy);
      break;
    }
  }
  return fmt::format("not expected: {}; {}", fmt::join(extras, " "), remedy);
}

}  // namespace

void complete_options(CLI::App& app) {
  for (CLI::Option* option : app.get_options()) {
    state_default(*option);
    const std::string type = option->get_type_name();
    if (type.starts_with("FLOAT")) {
      option->transform(CLI::Validator(check_number, ""));
    } else if (type.starts_with("INT")) {
      option->transform(CLI::Validator(check_whole_number<std::int64_t>, ""));
    } else if (type.starts_with("UINT")) {
      option->transform(CLI::Validator(check_whole_number<std::uint64_t>, ""));
    }
  }
  for (CLI::App* command : app.get_subcommands([](CLI::App*) { return true; })) {
    complete_options(*command);
  }
}

void reject_unknown_commands(const CLI::App& app, const std::vector<std::string>& words) {
  const CLI::App* parent = &app;
  std::string path = app.get_name();
  for (const std::string& word : words) {
    if (word.empty() || word.front() == '-' || command_names(*parent).empty()) {
      return;
    }
    const std::vector<const CLI::App*> named =
        parent->get_subcommands([&](const CLI::App* command) { return command->check_name(word); });
    if (named.empty()) {
      throw UsageError(word, "there is no such command",
                       did_you_mean(word, command_names(*parent), "see " + path + " --help"));
    }
    parent = named.front();
    path += " " + word;
  }
}

std::string typed_command(const CLI::App& app) {
  std::string name = app.get_name();
  for (const CLI::App* command : app.get_subcommands()) {
    name += " " + typed_command(*command);
  }
  return name;
}

std::string fault_text(const CLI::App& app, const CLI::ParseError& error) {
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) {
    return text_of_extras(app);
  }
  const CLI::App& command = last_command(app);
  const std::vector<std::string> names = command_names(command);
  if (!names.empty() && command.get_subcommands().empty()) {
    return fmt::format("{}: which of {}? {}", typed_command(app), fmt::join(names, ", "),
                       see_help(app));
  }
  const std::string what = error.what();
  return fmt::format("{}{} {}", what, what.ends_with('?') ? "" : ";", see_help(app));
}

}  // namespace foveola
