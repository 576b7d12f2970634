#include "renderer/command_line/command_description.h"

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "tests/matchers.h"

namespace foveola {
namespace {

class Description : public testing::Test {
 protected:
  /// What the only command says of the option that it calls `name`.
  OptionDescription option(const std::string& name) {
    const CommandDescription program = describe(app_);
    for (const OptionDescription& option : program.commands.at(0).options) {
      if (option.names.back() == name) {
        return option;
      }
    }
    ADD_FAILURE() << name << " is not described";
    return {};
  }

  CLI::App app_{"A program", "program"};
  CLI::App& command_ = *app_.add_subcommand("render", "Render");
  std::string text_;
  int number_ = 4;
  std::vector<std::string> list_ = {"one", "two"};
  bool flag_ = false;
};

std::vector<std::string> names_of(const std::vector<CommandDescription>& commands) {
  std::vector<std::string> names;
  for (const CommandDescription& command : commands) {
    names.push_back(command.name);
  }
  return names;
}

std::vector<std::string> last_names_of(const std::vector<OptionDescription>& options) {
  std::vector<std::string> names;
  for (const OptionDescription& option : options) {
    names.push_back(option.names.back());
  }
  return names;
}

TEST_F(Description, GoesDownThroughCommandsInTheirOrder) {
  command_.footer("Example: program render");
  CLI::App* study = app_.add_subcommand("study", "Study");
  study->add_subcommand("simulate", "Simulate");
  study->add_subcommand("run", "Run");
  app_.add_subcommand("former", "A name of earlier times")->group("");
  const CommandDescription program = describe(app_);
  EXPECT_EQ(program.name, "program");
  EXPECT_EQ(program.description, "A program");
  ASSERT_THAT(names_of(program.commands), ElementsAre("render", "study"));
  EXPECT_EQ(program.commands[0].footer, "Example: program render");
  EXPECT_THAT(names_of(program.commands[1].commands), ElementsAre("simulate", "run"));
  EXPECT_EQ(program.commands[1].commands[1].description, "Run");
}

TEST_F(Description, KeepsPositionalsAndOptionsApart) {
  command_.add_option("SCENE", text_, "The scene")->required();
  command_.add_option("OTHER", list_, "More");
  command_.add_option("-o,--output", text_, "The image");
  const CommandDescription render = describe(app_).commands.at(0);
  ASSERT_EQ(render.positionals.size(), 2U);
  EXPECT_THAT(render.positionals[0].names, ElementsAre("SCENE"));
  EXPECT_TRUE(render.positionals[0].is_required);
  EXPECT_FALSE(render.positionals[0].takes_many);
  EXPECT_FALSE(render.positionals[1].is_required);
  EXPECT_TRUE(render.positionals[1].takes_many);
  ASSERT_EQ(render.options.size(), 2U);
  EXPECT_THAT(render.options[0].names, ElementsAre("-h", "--help"));
  EXPECT_THAT(render.options[1].names, ElementsAre("-o", "--output"));
  EXPECT_EQ(render.options[1].description, "The image");
}

TEST_F(Description, TellsWhatAnOptionAccepts) {
  command_.add_option("--tone", text_)->check(CLI::IsMember({"plain", "filmic"}));
  command_.add_option("--threads", number_)->check(CLI::Range(-1, 1000))->capture_default_str();
  command_.add_option("--overlays", list_)->capture_default_str();
  command_.add_option("--exposure", text_)->check([](const std::string&) { return ""; });
  command_.add_flag("--json", flag_);
  const OptionDescription tone = option("--tone");
  EXPECT_EQ(tone.value_name, "TEXT");
  EXPECT_THAT(tone.choices, ElementsAre("plain", "filmic"));
  EXPECT_FALSE(tone.takes_number);
  EXPECT_EQ(tone.default_value, "");
  const OptionDescription threads = option("--threads");
  EXPECT_EQ(threads.value_name, "INT");
  EXPECT_EQ(threads.limits, "-1 to 1000");
  EXPECT_EQ(threads.default_value, "4");
  EXPECT_TRUE(threads.takes_number);
  EXPECT_THAT(threads.choices, IsEmpty());
  EXPECT_EQ(option("--overlays").default_value, "one,two");
  EXPECT_EQ(option("--exposure").limits, "");
  EXPECT_THAT(option("--exposure").choices, IsEmpty());
  EXPECT_EQ(option("--json").value_name, "");
}

TEST_F(Description, OnlyTextWithoutChoicesMayBeAFile) {
  command_.add_option("--output", text_);
  command_.add_option("--tone", text_)->check(CLI::IsMember({"plain", "filmic"}));
  command_.add_option("--threads", number_);
  command_.add_flag("--json", flag_);
  EXPECT_TRUE(may_take_file(option("--output")));
  EXPECT_FALSE(may_take_file(option("--tone")));
  EXPECT_FALSE(may_take_file(option("--threads")));
  EXPECT_FALSE(may_take_file(option("--json")));
}

TEST_F(Description, TellsWhichOptionsGoTogether) {
  CLI::Option* view = command_.add_option("--view", text_);
  CLI::Option* all = command_.add_flag("--all", flag_);
  CLI::Option* former = command_.add_flag("--former", flag_)->group("");
  command_.add_option("--size", text_)->needs(view)->excludes(all)->excludes(former)->required();
  const OptionDescription size = option("--size");
  EXPECT_THAT(size.needs, ElementsAre("--view"));
  EXPECT_THAT(size.excludes, ElementsAre("--all"));
  EXPECT_TRUE(size.is_required);
}

TEST_F(Description, KeepsGroupsTogetherUnderTheirTitles) {
  command_.add_option("--view", text_)->group("Image");
  command_.add_option("--size", text_);
  command_.add_option("--lens", text_)->group("Image");
  CLI::App* budget = command_.add_option_group("budget", "How much");
  budget->add_option("--samples", number_);
  budget->require_option(0, 1);
  CLI::App* hidden = command_.add_option_group("", "Hidden");
  hidden->add_option("--hidden", number_);
  const std::vector<OptionDescription> options = describe(app_).commands.at(0).options;
  ASSERT_THAT(last_names_of(options),
              ElementsAre("--help", "--size", "--view", "--lens", "--samples"));
  EXPECT_EQ(options[1].group, "");
  EXPECT_EQ(options[3].group, "Image");
  EXPECT_EQ(options[4].group, "How much (at most 1)");
}

}  // namespace
}  // namespace foveola
