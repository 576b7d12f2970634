// What the program answers to the scripts, which tests/end_to_end/command_line_test.cpp has bash
// run.
#include "renderer/command_line/completion.h"

#include <string>

#include "tests/matchers.h"

namespace foveola {
namespace {

/// A program with a command in a command.
CommandDescription program() {
  const CommandDescription run{.name = "run",
                               .description = "Run it: a person's [own] session",
                               .positionals = {{.names = {"PROTOCOL"}, .value_name = "TEXT"}},
                               .options = {{.names = {"-o", "--output"},
                                            .value_name = "TEXT",
                                            .description = "The person's folder (default: none)"},
                                           {.names = {"--tone"},
                                            .value_name = "TEXT",
                                            .choices = {"plain", "filmic"},
                                            .description = "Tone [of light]; plain cuts"},
                                           {.names = {"--threads"},
                                            .value_name = "INT",
                                            .takes_number = true,
                                            .description = "Threads"},
                                           {.names = {"--json"}, .description = "As JSON"}}};
  const CommandDescription shell{
      .name = "shell",
      .positionals = {{.names = {"SHELL"}, .value_name = "TEXT", .choices = {"bash", "zsh"}}}};
  return {.name = "lab",
          .description = "A lab",
          .options = {{.names = {"--version"}, .description = "Version"}},
          .commands = {{.name = "study", .description = "Studies", .commands = {run}}, shell}};
}

TEST(Completions, GoFromCommandToCommand) {
  EXPECT_EQ(completions(program(), {""}), "study\tStudies\nshell\n");
  EXPECT_EQ(completions(program(), {"--version", "st"}), "study\tStudies\n");
  EXPECT_EQ(completions(program(), {"study", ""}), "run\tRun it\n");
  EXPECT_EQ(completions(program(), {"nonsense", ""}), "");
}

TEST(Completions, DescribeOptions) {
  EXPECT_EQ(completions(program(), {"study", "run", "x.toml", "-"}),
            "-o\tThe person's folder\n--output\tThe person's folder\n--tone\tTone [of light]\n"
            "--threads\tThreads\n--json\tAs JSON\n");
  EXPECT_EQ(completions(program(), {"study", "run", "--th"}), "--threads\tThreads\n");
}

TEST(Completions, AreValues) {
  EXPECT_EQ(completions(program(), {"study", "run", ""}), "/\n");
  EXPECT_EQ(completions(program(), {"study", "run", "-o", ""}), "/\n");
  EXPECT_EQ(completions(program(), {"study", "run", "--threads", ""}), "");
  EXPECT_EQ(completions(program(), {"study", "run", "--json", ""}), "/\n");
  EXPECT_EQ(completions(program(), {"shell", ""}), "bash\nzsh\n");
  EXPECT_EQ(completions(program(), {"study", "run", "--tone", ""}), "plain\nfilmic\n");
}

TEST(Completions, AreValuesBehindAnEqualsSign) {
  EXPECT_EQ(completions(program(), {"study", "run", "--tone=f"}), "--tone=filmic\n");
  EXPECT_EQ(completions(program(), {"study", "run", "--tone", "="}), "plain\nfilmic\n");
  EXPECT_EQ(completions(program(), {"study", "run", "--tone", "=", "p"}), "plain\n");
}

TEST(CompletionScript, IsOfTheProgram) {
  for (const char* shell : {"bash", "zsh", "fish"}) {
    const std::string script = completion_script(shell, "lab");
    EXPECT_THAT(script, AllOf(HasSubstr("lab"), HasSubstr(complete_command)));
    EXPECT_THAT(script, Not(HasSubstr("PROGRAM")));
  }
}

}  // namespace
}  // namespace foveola
