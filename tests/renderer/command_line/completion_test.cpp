// What scripts say. The one for bash is run in tests/end_to_end/command_line_test.cpp.
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
                                           {.names = {"--show"},
                                            .value_name = "TEXT",
                                            .takes_many = true,
                                            .choices = {"gaze"},
                                            .description = "Show"},
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

TEST(ZshCompletion, DescribesOptionsAndValues) {
  const std::string script = zsh_completion(program());
  EXPECT_THAT(script, HasSubstr("\n_lab_study_run() {\n"
                                "  _arguments -C \\\n"
                                "    '(-o --output)-o[The person'\\''s folder]:TEXT:_files' \\\n"
                                "    '(-o --output)--output=[The person'\\''s folder]"
                                ":TEXT:_files' \\\n"
                                "    '(--tone)--tone=[Tone \\[of light\\]]"
                                ":TEXT:(plain filmic)' \\\n"
                                "    '*--show=[Show]:TEXT:(gaze)' \\\n"
                                "    '(--threads)--threads=[Threads]:INT: ' \\\n"
                                "    '(--json)--json[As JSON]' \\\n"
                                "    ':PROTOCOL:_files'\n"
                                "}\n"));
}

TEST(ZshCompletion, GoesFromCommandToCommand) {
  const std::string script = zsh_completion(program());
  EXPECT_THAT(script, HasSubstr("'run:Run it')\n"));
  EXPECT_THAT(script, HasSubstr("      case $words[1] in\n"
                                "        study) _lab_study ;;\n"
                                "        shell) _lab_shell ;;\n"));
  EXPECT_THAT(script, HasSubstr("        run) _lab_study_run ;;\n"));
  EXPECT_TRUE(script.starts_with("#compdef lab\n"));
  EXPECT_THAT(script, AllOf(HasSubstr("compdef _lab lab\n"), Not(HasSubstr("PROGRAM"))));
}

TEST(FishCompletion, DescribesOptionsAndValues) {
  const std::string script = fish_completion(program());
  const std::string run = "complete -c lab -n '__lab_in study run'";
  EXPECT_THAT(script, HasSubstr(run + " -s o -l output -r -F -d 'The person\\'s folder'\n"));
  EXPECT_THAT(script, HasSubstr(run + " -l tone -x -a 'plain filmic' -d 'Tone [of light]'\n"));
  EXPECT_THAT(script, HasSubstr(run + " -l threads -x -d 'Threads'\n"));
  EXPECT_THAT(script, HasSubstr(run + " -l json -d 'As JSON'\n"));
  EXPECT_THAT(script, HasSubstr(run + " -F\n"));
  EXPECT_THAT(script, HasSubstr("complete -c lab -n '__lab_in shell' -a 'bash zsh'\n"));
}

TEST(FishCompletion, GoesFromCommandToCommand) {
  const std::string script = fish_completion(program());
  EXPECT_THAT(script, HasSubstr("complete -c lab -n '__lab_at' -a study -d 'Studies'\n"));
  EXPECT_THAT(script, HasSubstr("complete -c lab -n '__lab_at study' -a run -d 'Run it'\n"));
  EXPECT_THAT(script, AllOf(HasSubstr("\ncomplete -c lab -f\n"), Not(HasSubstr("PROGRAM"))));
}

}  // namespace
}  // namespace foveola
