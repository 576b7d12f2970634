#include "renderer/command_line/manual_page.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/base/text/words.h"
#include "renderer/base/transformed.h"

namespace foveola {
namespace {

std::string bold(std::string_view text) { return fmt::format("\\fB{}\\fR", roff_text(text)); }
std::string italic(std::string_view text) { return fmt::format("\\fI{}\\fR", roff_text(text)); }

std::string in_capitals(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::toupper(letter)); });
  return text;
}

/// For the manual's first line, which mandb lists: "a laboratory" for "A laboratory.".
std::string as_clause(std::string sentence) {
  if (sentence.ends_with('.')) {
    sentence.pop_back();
  }
  if (!sentence.empty()) {
    sentence.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(sentence[0])));
  }
  return sentence;
}

std::string as_sentence(const std::string& text) {
  const bool has_end = text.empty() || text.ends_with('.') || text.ends_with('?');
  return has_end ? text : text + ".";
}

/// Running text, which roff fills itself, in lines of up to 80 characters, as mandoc requires.
std::string filled(const std::string& text) {
  constexpr std::size_t width = 80;
  std::istringstream words(roff_text(text));
  std::string lines;
  std::string line;
  for (std::string word; words >> word;) {
    if (!line.empty() && line.size() + 1 + word.size() > width) {
      lines += line + "\n";
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  return line.empty() ? lines : lines + line + "\n";
}

std::string paragraph(const std::string& text) { return ".PP\n" + filled(text); }

/// body: roff. A section begins with a paragraph by itself.
std::string section(const std::string& title, std::string body) {
  const std::string_view own = ".PP\n";
  if (body.starts_with(own)) {
    body.erase(0, own.size());
  }
  return fmt::format(".SH {}\n{}", roff_text(title), body);
}

/// `term` and its explanation, indented below it. term: roff.
std::string term_with_text(const std::string& term, const std::string& text) {
  return fmt::format(".TP\n{}\n{}", term, filled(text));
}

/// "SCENE", "[SCENE...]" and so on, as in help.
std::string usage_of(const OptionDescription& positional) {
  const std::string name = italic(positional.names.front()) + (positional.takes_many ? "..." : "");
  return positional.is_required ? name : "[" + name + "]";
}

/// `path` with its possible arguments. path: the command's name behind its parents'.
std::string usage_of(const CommandDescription& command, const std::string& path) {
  std::string usage = bold(path);
  if (!command.options.empty()) {
    usage += fmt::format(" [{}]", italic("OPTIONS"));
  }
  for (const OptionDescription& positional : command.positionals) {
    usage += " " + usage_of(positional);
  }
  return command.commands.empty() ? usage : usage + " " + italic("COMMAND");
}

/// "-o, --output TEXT", or "SCENE"
std::string term_of(const OptionDescription& option) {
  if (!option.names.front().starts_with('-')) {
    return italic(option.names.front());
  }
  const std::vector<std::string> names =
      transformed(option.names, [&](const std::string& name) { return bold(name); });
  const std::string value = option.value_name.empty() ? "" : " " + italic(option.value_name);
  return fmt::format("{}{}", fmt::join(names, ", "), value);
}

/// Help's conditions in words: "from 1 to 9; default: 4".
std::string conditions_of(const OptionDescription& option) {
  std::vector<std::string> conditions;
  if (option.is_required) {
    conditions.emplace_back("required");
  }
  if (!option.choices.empty()) {
    conditions.push_back(fmt::format("one of {}", fmt::join(option.choices, ", ")));
  }
  if (!option.limits.empty()) {
    conditions.push_back("from " + option.limits);
  }
  if (!option.default_value.empty()) {
    conditions.push_back("default: " + option.default_value);
  }
  if (!option.needs.empty()) {
    conditions.push_back(fmt::format("only with {}", fmt::join(option.needs, " and ")));
  }
  if (!option.excludes.empty()) {
    conditions.push_back(fmt::format("not with {}", fmt::join(option.excludes, " or ")));
  }
  return fmt::format("{}", fmt::join(conditions, "; "));
}

/// The conditions have their own line, in brackets, so that no full stop can be read as part of
/// them: the default of a folder is ".".
std::string part_of(const OptionDescription& option) {
  const std::string conditions = conditions_of(option);
  return term_with_text(term_of(option), as_sentence(option.description)) +
         (conditions.empty() ? "" : ".br\n" + filled("(" + conditions + ")"));
}

std::string parts_of(const std::vector<OptionDescription>& options) {
  std::string page;
  std::string group;
  for (const OptionDescription& option : options) {
    if (option.group != group) {
      group = option.group;
      page += fmt::format(".PP\n{}:\n", bold(group));
    }
    page += part_of(option);
  }
  return page;
}

/// Its lines, unfilled.
std::string example(const std::string& footer) {
  return footer.empty() ? "" : fmt::format(".PP\n.EX\n{}\n.EE\n", roff_text(footer));
}

/// The command, followed by its own commands. everywhere: options that are already described.
std::string part_of(const CommandDescription& command, const std::string& path,
                    const std::vector<OptionDescription>& everywhere) {
  std::vector<OptionDescription> own = command.options;
  std::erase_if(own, [&](const OptionDescription& option) {
    return std::ranges::find(everywhere, option) != everywhere.end();
  });
  std::string page =
      fmt::format(".SS {}\n{}", usage_of(command, path), filled(as_sentence(command.description)));
  page += parts_of(command.positionals) + parts_of(own) + example(command.footer);
  for (const CommandDescription& inner : command.commands) {
    page += part_of(inner, path + " " + inner.name, everywhere);
  }
  return page;
}

std::string part_of(const ManualSection& written) {
  std::string body;
  for (const ManualEntry& entry : written.entries) {
    body +=
        entry.term.empty() ? paragraph(entry.text) : term_with_text(bold(entry.term), entry.text);
  }
  return section(written.title, body);
}

}  // namespace

std::string roff_text(std::string_view text) {
  constexpr auto escapes = std::to_array<Word<char>>({{"\\(rs", '\\'},
                                                      {"\\-", '-'},
                                                      {"\\(aq", '\''},
                                                      {"\\(dq", '"'},
                                                      {"\\(ga", '`'},
                                                      {"\\(ha", '^'},
                                                      {"\\(ti", '~'}});
  std::string roff;
  char before = ' ';
  for (const char letter : text) {
    const auto* const escape = std::ranges::find(escapes, letter, &Word<char>::value);
    // A dot at the beginning of a line begins a request, and any word may be placed there.
    if (letter == '.' && (before == ' ' || before == '\n')) {
      roff += "\\&.";
    } else if (escape != escapes.end()) {
      roff += escape->text;
    } else {
      roff += letter;
    }
    before = letter;
  }
  return roff;
}

std::string manual_page(const CommandDescription& program, const std::string& version,
                        const ManualText& text) {
  // No date: the same source then gives the same page on any day.
  std::string page = fmt::format(".TH {} 1 \"\" \"{} {}\" \"User Commands\"\n",
                                 roff_text(in_capitals(program.name)), roff_text(program.name),
                                 roff_text(version));
  page += section("NAME", fmt::format("{} \\- {}\n", roff_text(program.name),
                                      roff_text(as_clause(program.description))));
  page += section("SYNOPSIS", usage_of(program, program.name) + "\n");
  std::string description;
  for (const std::string& words : text.description) {
    description += paragraph(words);
  }
  page += section("DESCRIPTION", description);
  page += section("OPTIONS", parts_of(program.positionals) + parts_of(program.options));
  std::string commands;
  for (const CommandDescription& command : program.commands) {
    commands += part_of(command, program.name + " " + command.name, program.options);
  }
  page += section("COMMANDS", commands);
  for (const ManualSection& behind : text.sections) {
    page += part_of(behind);
  }
  return page;
}

}  // namespace foveola
