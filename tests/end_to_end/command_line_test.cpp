// The manual page holds what --help says, and bash completes by the script that is printed.
#include <algorithm>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "renderer/base/files/files.h"
#include "tests/end_to_end/program.h"
#include "tests/matchers.h"

namespace foveola::test {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    lines.push_back(line);
  }
  return lines;
}

/// What the program prints if it does as it is told.
std::string output_of(const std::vector<std::string>& arguments) {
  const ProgramResult result = succeeded(run_foveola(arguments));
  EXPECT_THAT(result.errors, IsEmpty());
  return result.output;
}

/// What a command's --help lists.
struct Help {
  std::vector<std::string> commands;
  std::set<std::string> names;  ///< of options and positionals
};

/// A list's entries are indented by two blanks, or four in a group of options; what goes on below
/// them, by more.
Help help_of(std::vector<std::string> command) {
  static const std::regex entry("( {2}| {4})([^ ]+).*");
  command.emplace_back("--help");
  Help help;
  std::string list;
  for (const std::string& line : lines_of(output_of(command))) {
    std::smatch match;
    if (!line.empty() && line.front() != ' ') {
      list = line;
    } else if (std::regex_match(line, match, entry) && list == "Subcommands:") {
      help.commands.push_back(match[2]);
    } else if (std::regex_match(line, match, entry) &&
               (match[2].str().front() == '-' || list == "Positionals:")) {
      std::istringstream names(match[2].str());
      for (std::string name; std::getline(names, name, ',');) {
        help.names.insert(name);
      }
    }
  }
  return help;
}

std::string without_roff(const std::string& text) {
  return std::regex_replace(text, std::regex(R"(\\f[BIR]|\\(?=-))"), "");
}

/// The names that a part of the manual explains: its terms, without what stands for a value.
std::set<std::string> names_in(const std::string& part) {
  static const std::regex name(R"(\\fB(\\-[^ ]+)\\fR|^\\fI([A-Z0-9]+)\\fR)");
  std::set<std::string> names;
  std::string before;
  for (const std::string& line : lines_of(part)) {
    if (before == ".TP") {
      for (std::sregex_iterator at(line.begin(), line.end(), name), end; at != end; ++at) {
        names.insert(without_roff((*at)[1].matched ? (*at)[1].str() : (*at)[2].str()));
      }
    }
    before = line;
  }
  return names;
}

/// From the line that begins so to the next heading.
std::string part_of(const std::string& manual, const std::string& heading) {
  const std::size_t begin = manual.find("\n" + heading);
  if (begin == std::string::npos) {
    ADD_FAILURE() << "there is no " << heading;
    return {};
  }
  return manual.substr(begin + 1, manual.find("\n.S", begin + 1) - begin);
}

/// Everything that the help of `command`, and of those in it, shows stands in the manual, and
/// nothing else. Returns the number of commands.
int expect_in_manual(const std::string& manual, const std::vector<std::string>& command) {
  Help help = help_of(command);
  const bool is_program = command.empty();
  std::string heading = is_program ? ".SH OPTIONS" : ".SS \\fBfoveola";
  for (const std::string& word : command) {
    heading += " " + std::regex_replace(word, std::regex("-"), R"(\-)");
  }
  if (!is_program) {
    heading += "\\fR";
    EXPECT_EQ(help.names.erase("-h") + help.names.erase("--help"), 2U);  // The program's own.
  }
  EXPECT_EQ(names_in(part_of(manual, heading)), help.names) << heading;
  int count = 1;
  for (const std::string& inner : help.commands) {
    std::vector<std::string> longer = command;
    longer.push_back(inner);
    count += expect_in_manual(manual, longer);
  }
  return count;
}

TEST(Manual, HoldsWhatHelpShows) {
  const std::string manual = output_of({"manual"});
  const int commands = expect_in_manual(manual, {});
  EXPECT_GT(commands, 40);
  const std::vector<std::string> lines = lines_of(manual);
  EXPECT_EQ(std::count_if(lines.begin(), lines.end(),
                          [](const std::string& line) { return line.starts_with(".SS "); }),
            commands - 1);
}

/// Any other line that begins so would be taken for a request and not be printed.
TEST(Manual, HasNoLinesThatRoffMisreads) {
  const std::set<std::string> requests = {".TH", ".SH", ".SS", ".TP", ".PP", ".EX", ".EE", ".br"};
  for (const std::string& line : lines_of(output_of({"manual"}))) {
    EXPECT_FALSE(line.empty());
    EXPECT_FALSE(line.starts_with("'")) << line;
    EXPECT_TRUE(!line.starts_with(".") || requests.contains(line.substr(0, 3))) << line;
    EXPECT_TRUE(std::all_of(line.begin(), line.end(), [](unsigned char letter) {
      return letter >= ' ' && letter < 127;
    })) << line;
  }
}

TEST(Completion, IsForShellsThatItKnows) {
  expect_one_line(run_foveola({"completion", "tcsh"}), 2, "bash,zsh,fish");
  expect_one_line(run_foveola({"completion"}), 2, "SHELL is required");
  EXPECT_THAT(output_of({"completion", "zsh"}), HasSubstr("compdef _foveola foveola"));
  EXPECT_THAT(output_of({"completion", "fish"}), HasSubstr("complete -c foveola"));
  EXPECT_THAT(output_of({"__complete", "study", "re"}), StartsWith("replay\t"));
}

class BashCompletion : public testing::Test {
 protected:
  /// What bash offers for the last of the words, in a folder with some files and without the
  /// package bash-completion. What it prints beside that fails the test.
  std::vector<std::string> completed(std::vector<std::string> words) {
    static const std::string script = R"(
      cd "$0/files" && source ../script
      COMP_WORDS=("$@") COMP_CWORD=$(($# - 1))
      _foveola
      for reply in "${COMPREPLY[@]}"; do echo "$reply"; done)";
    words.insert(words.begin(), {"bash", "-c", script, folder_.path().string(), FOVEOLA_PROGRAM});
    const ProgramResult result = succeeded(run_program(words));
    EXPECT_THAT(result.errors, IsEmpty());
    return lines_of(result.output);
  }

  TemporaryFolder folder_;
  const std::string script_ = folder_.write("script", output_of({"completion", "bash"}));
  const std::string room_ = folder_.write("files/my room.glb", "");
  const std::string inner_ = folder_.write("files/my scenes/hall.glb", "");
  const std::string other_ = folder_.write("files/other.glb", "");
};

TEST_F(BashCompletion, IsRegistered) {
  succeeded(run_program({"bash", "-n", script_}));
  const ProgramResult result = run_program({"bash", "-c", "source \"$0\"; complete -p", script_});
  EXPECT_EQ(result.output, "complete -F _foveola foveola\n");
  EXPECT_THAT(result.errors, IsEmpty());
}

TEST_F(BashCompletion, CompletesCommands) {
  EXPECT_THAT(completed({"s"}), ElementsAre("scene", "study"));
  EXPECT_THAT(completed({"study", "s"}), ElementsAre("simulate", "status", "summary"));
  EXPECT_THAT(completed({""}), IsSupersetOf({"demo", "render", "study", "manual", "completion"}));
  EXPECT_THAT(completed({"--help", "st"}), ElementsAre("study"));
}

TEST_F(BashCompletion, CompletesOptionsOfTheCommand) {
  folder_.write("files/--top.glb", "");  // Typed like that it would be taken for an option.
  EXPECT_THAT(completed({"render", "--t"}), UnorderedElementsAre("--time", "--tone", "--threads"));
  EXPECT_THAT(completed({"study", "simulate", "demo", "--d"}), ElementsAre("--db"));
  EXPECT_THAT(completed({"--v"}), ElementsAre("--version"));
  EXPECT_THAT(completed({"study", "--"}), ElementsAre("--help"));
}

TEST_F(BashCompletion, CompletesChoices) {
  EXPECT_THAT(completed({"render", "room.glb", "--tone", ""}), ElementsAre("plain", "filmic"));
  EXPECT_THAT(completed({"preview", "--show", "r"}), ElementsAre("rings"));
  EXPECT_THAT(completed({"render", "--tone", "=", "p"}), ElementsAre("plain"));
}

TEST_F(BashCompletion, CompletesNamesOfFiles) {
  EXPECT_THAT(completed({"render", ""}),
              UnorderedElementsAre("my room.glb", "my scenes", "other.glb"));
  EXPECT_THAT(completed({"render", "room.glb", "-o", "o"}), ElementsAre("other.glb"));
  EXPECT_THAT(completed({"study", "run", "--db", "o"}), ElementsAre("other.glb"));
}

/// Words as they are typed: with their quotes and backslashes.
TEST_F(BashCompletion, CompletesNamesOfFilesWithBlanks) {
  EXPECT_THAT(completed({"render", "my\\ r"}), ElementsAre("my room.glb"));
  EXPECT_THAT(completed({"render", "\"my r"}), ElementsAre("my room.glb"));
  EXPECT_THAT(completed({"render", "'my r"}), ElementsAre("my room.glb"));
  EXPECT_THAT(completed({"render", "my\\ scenes/"}), ElementsAre("my scenes/hall.glb"));
}

TEST_F(BashCompletion, OffersNothingWhereNothingIsKnown) {
  EXPECT_THAT(completed({"nonsense", ""}), IsEmpty());
  EXPECT_THAT(completed({"study", "nonsense", "s"}), IsEmpty());
  EXPECT_THAT(completed({"render", "room.glb", "--threads", ""}), IsEmpty());
  EXPECT_THAT(completed({"demo", ""}), IsEmpty());
  EXPECT_THAT(completed({"render", "--nonsense"}), IsEmpty());
}

}  // namespace
}  // namespace foveola::test
