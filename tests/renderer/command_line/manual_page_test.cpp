#include "renderer/command_line/manual_page.h"

#include <algorithm>
#include <sstream>
#include <string>

#include "tests/matchers.h"

namespace foveola {
namespace {

const OptionDescription help{.names = {"-h", "--help"}, .description = "Print help"};

/// The page of a program that has only this command.
std::string page_with(CommandDescription command) {
  return manual_page({.name = "program", .description = "A program", .commands = {command}}, "1.2",
                     {});
}

/// The page of a program whose only command has only this option.
std::string page_with(const OptionDescription& option) {
  return page_with(CommandDescription{.name = "go", .description = "Go", .options = {option}});
}

TEST(RoffText, IsPrintedAsItStands) {
  EXPECT_EQ(roff_text("--max-depth"), "\\-\\-max\\-depth");
  EXPECT_EQ(roff_text("C:\\new"), "C:\\(rsnew");
  EXPECT_EQ(roff_text("'it's'"), "\\(aqit\\(aqs\\(aq");
  EXPECT_EQ(roff_text("~ ^ ` \""), "\\(ti \\(ha \\(ga \\(dq");
}

TEST(RoffText, NoWordCanBecomeARequest) {
  EXPECT_EQ(roff_text(".glb"), "\\&.glb");
  EXPECT_EQ(roff_text("a .glb or b.obj."), "a \\&.glb or b.obj.");
  EXPECT_EQ(roff_text("first\n.second"), "first\n\\&.second");
}

TEST(ManualPage, HasItsPartsInTheirOrder) {
  const OptionDescription scene{
      .names = {"SCENE"}, .value_name = "TEXT", .is_required = true, .description = "A scene"};
  const OptionDescription output{
      .names = {"-o", "--output"}, .value_name = "TEXT", .description = "The image"};
  const CommandDescription render{.name = "render",
                                  .description = "Render a picture",
                                  .positionals = {scene},
                                  .options = {help, output},
                                  .footer = "Example: program render room -o a.png"};
  const CommandDescription program{
      .name = "program", .description = "A program.", .options = {help}, .commands = {render}};
  const ManualText text{.description = {"First.", "Second."},
                        .sections = {{.title = "FILES", .entries = {{"~/.cache", "The cache."}}},
                                     {.title = "SEE ALSO", .entries = {{"", "man(1)"}}}}};
  EXPECT_EQ(manual_page(program, "1.2", text), R"(.TH PROGRAM 1 "" "program 1.2" "User Commands"
.SH NAME
program \- a program
.SH SYNOPSIS
\fBprogram\fR [\fIOPTIONS\fR] \fICOMMAND\fR
.SH DESCRIPTION
First.
.PP
Second.
.SH OPTIONS
.TP
\fB\-h\fR, \fB\-\-help\fR
Print help.
.SH COMMANDS
.SS \fBprogram render\fR [\fIOPTIONS\fR] \fISCENE\fR
Render a picture.
.TP
\fISCENE\fR
A scene.
.br
(required)
.TP
\fB\-o\fR, \fB\-\-output\fR \fITEXT\fR
The image.
.PP
.EX
Example: program render room \-o a.png
.EE
.SH FILES
.TP
\fB\(ti/.cache\fR
The cache.
.SH SEE ALSO
man(1)
)");
}

TEST(ManualPage, TellsWhatAnOptionAccepts) {
  EXPECT_THAT(page_with(OptionDescription{.names = {"--tone"},
                                          .value_name = "TEXT",
                                          .choices = {"plain", "filmic"},
                                          .default_value = "plain",
                                          .description = "The tone"}),
              HasSubstr("The tone.\n.br\n(one of plain, filmic; default: plain)\n"));
  EXPECT_THAT(page_with(OptionDescription{.names = {"--threads"},
                                          .value_name = "INT",
                                          .limits = "1 to 9",
                                          .needs = {"--all"},
                                          .excludes = {"--one", "--two"},
                                          .description = "Threads"}),
              HasSubstr("(from 1 to 9; only with \\-\\-all; not with \\-\\-one or \\-\\-two)\n"));
}

TEST(ManualPage, FillsLinesOfUpToEightyCharacters) {
  std::string description = "Formats";
  for (int i = 0; i < 30; ++i) {
    description += " .glb or-so";
  }
  std::istringstream lines(
      page_with(OptionDescription{.names = {"--x"}, .description = description}));
  int longest = 0;
  int words = 0;
  for (std::string line; std::getline(lines, line);) {
    longest = std::max(longest, static_cast<int>(line.size()));
    EXPECT_FALSE(line.starts_with(".glb"));
    EXPECT_FALSE(line.empty());
    for (std::size_t at = line.find("or\\-so"); at != std::string::npos;
         at = line.find("or\\-so", at + 1)) {
      ++words;
    }
  }
  EXPECT_EQ(words, 30);
  EXPECT_LE(longest, 80);
  EXPECT_GT(longest, 60);
}

}  // namespace
}  // namespace foveola
