#include "renderer/commands/typed_command.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "renderer/base/error.h"
#include "tests/matchers.h"

namespace foveola {
namespace {

class TypedCommand : public testing::Test {
 protected:
  TypedCommand() {
    app_.require_subcommand(1);
    CLI::App* render = app_.add_subcommand("render", "");
    render->add_option("SCENE", scene_);
    render->add_option("--exposure", exposure_)->check(CLI::Range(-20.0, 20.0));
    render->add_option("--former", exposure_)->group("");
    CLI::App* budget = render->add_option_group("budget");
    budget->add_option("--samples", samples_);
    budget->add_option("--threads", threads_)->check(CLI::Range(0, 1024));
    CLI::App* study = app_.add_subcommand("study", "");
    study->require_subcommand(1);
    study->add_subcommand("simulate", "");
    study->add_subcommand("run", "");
    complete_options(app_);
  }

  /// What is wrong with the words; empty if nothing is.
  std::string fault_of(std::vector<std::string> words) {
    try {
      reject_unknown_commands(app_, words);
      std::reverse(words.begin(), words.end());  // CLI11 takes the last first.
      app_.parse(words);
    } catch (const UsageError& error) {
      return error.what();
    } catch (const CLI::ParseError& error) {
      return fault_text(app_, error);
    }
    return {};
  }

  std::optional<double> exposure_;
  std::uint64_t samples_ = 0;
  int threads_ = 0;

 private:
  CLI::App app_{"", "foveola"};
  std::string scene_;
};

TEST_F(TypedCommand, WhatIsNotExpectedKeepsItsOrder) {
  EXPECT_EQ(fault_of({"render", "x", "--bla", "3", "--blu"}),
            "not expected: --bla 3 --blu; see foveola render --help");
  EXPECT_EQ(fault_of({"render", "x", "y"}), "not expected: y; see foveola render --help");
}

TEST_F(TypedCommand, AsksWhetherASimilarOptionWasMeant) {
  EXPECT_EQ(fault_of({"render", "x", "--exposre", "3"}),
            "not expected: --exposre 3; did you mean --exposure? see foveola render --help");
  EXPECT_THAT(fault_of({"render", "x", "--expsure=3"}), HasSubstr("did you mean --exposure?"));
  EXPECT_THAT(fault_of({"render", "x", "--sample", "3"}), HasSubstr("did you mean --samples?"));
}

TEST_F(TypedCommand, NamesOfEarlierVersionsAreNotMeant) {
  EXPECT_EQ(fault_of({"render", "x", "--forner", "3"}),
            "not expected: --forner 3; see foveola render --help");
}

TEST_F(TypedCommand, AsksWhetherASimilarCommandWasMeant) {
  EXPECT_EQ(fault_of({"rendre", "x"}), "rendre: there is no such command; did you mean 'render'?");
  EXPECT_EQ(fault_of({"study", "simluate"}),
            "simluate: there is no such command; did you mean 'simulate'?");
  EXPECT_EQ(fault_of({"study", "walk"}),
            "walk: there is no such command; see foveola study --help");
  EXPECT_EQ(fault_of({"walk"}), "walk: there is no such command; see foveola --help");
}

TEST_F(TypedCommand, ListsTheCommandsWhereNoneIsNamed) {
  EXPECT_EQ(fault_of({}), "foveola: which of render, study? see foveola --help");
  EXPECT_EQ(fault_of({"study"}), "foveola study: which of simulate, run? see foveola study --help");
}

TEST_F(TypedCommand, SaysWhatIsNoNumber) {
  EXPECT_THAT(fault_of({"render", "--exposure", "abc"}),
              HasSubstr("--exposure: 'abc' is not a number"));
  EXPECT_THAT(fault_of({"render", "--exposure", "5s"}),
              HasSubstr("--exposure: '5s' is not a number; leave out 's'"));
  EXPECT_THAT(fault_of({"render", "--samples", "many"}), HasSubstr("'many' is not a number"));
  EXPECT_THAT(fault_of({"render", "--samples", ""}), HasSubstr("'' is not a number"));
  EXPECT_THAT(fault_of({"render", "--samples", "1.5"}), HasSubstr("'1.5' is not a whole number"));
  EXPECT_THAT(fault_of({"render", "--samples", "1e40"}), HasSubstr("'1e40' is not a whole number"));
  EXPECT_THAT(fault_of({"render", "--samples", "nan"}), HasSubstr("'nan' is not a whole number"));
}

TEST_F(TypedCommand, WholeNumbersMayHaveAnExponent) {
  EXPECT_EQ(fault_of({"render", "--samples", "1.5e6", "--threads", "1e1"}), "");
  EXPECT_EQ(samples_, 1'500'000U);
  EXPECT_EQ(threads_, 10);
  EXPECT_THAT(fault_of({"render", "--threads", "1e6"}), HasSubstr("not in range"));
}

TEST_F(TypedCommand, NumbersThatNoOptionHoldsAreRefusedAndNotChanged) {
  for (const char* number : {"-1", "18446744073709551616", "99999999999999999999"}) {
    EXPECT_THAT(fault_of({"render", "--samples", number}),
                HasSubstr(number + std::string("' is not a whole number from 0 to "
                                               "18446744073709551615")));
  }
  EXPECT_THAT(fault_of({"render", "--threads", "-9223372036854775809"}),
              HasSubstr("from -9223372036854775808 to 9223372036854775807"));
  EXPECT_THAT(fault_of({"render", "--samples", "0x10"}), HasSubstr("'0x10' is not a whole"));
  EXPECT_EQ(fault_of({"render", "--samples", "010", "--threads", "+8"}), "");
  EXPECT_EQ(samples_, 10U);
  EXPECT_EQ(threads_, 8);
}

TEST_F(TypedCommand, OtherNumbersAreReadAsEver) {
  EXPECT_EQ(fault_of({"render", "--samples", "18446744073709551615", "--exposure", "-2.5e-1"}), "");
  EXPECT_EQ(samples_, 18'446'744'073'709'551'615U);
  EXPECT_EQ(exposure_, -0.25);
  EXPECT_THAT(fault_of({"render", "--exposure", "21"}), HasSubstr("not in range"));
}

TEST_F(TypedCommand, SaysWhereWorkCannotBeSplit) {
  EXPECT_THAT(fault_of({"study", "run", "--shard", "1/2"}),
              HasSubstr("parts of foveola study run could not be merged"));
}

}  // namespace
}  // namespace foveola
