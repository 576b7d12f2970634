#include "study/participant/population_file.h"

#include <algorithm>
#include <functional>
#include <vector>

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "tests/matchers.h"
#include "tests/temporary_folder.h"

namespace foveola::study {
namespace {

using test::TemporaryFolder;

std::string adults() { return read_people("adults").toml; }

/// The text with its one `from` replaced.
std::string with(const std::string& from, const std::string& to) {
  std::string text = adults();
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  EXPECT_EQ(text.find(from, at + 1), std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

/// The line of the text that `part` begins in, from 1 on.
long line_of(const std::string& text, const std::string& part) {
  const auto at = static_cast<long>(text.find(part));
  return 1 + std::count(text.begin(), text.begin() + at, '\n');
}

std::string refusal(const std::string& text) {
  const TemporaryFolder folder;
  try {
    read_people(folder.write("people.toml", text).string());
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(People, AdultsAreReadWithASourceForEachNumber) {
  const People people = read_people("adults");
  EXPECT_EQ(people.name, "adults");
  EXPECT_EQ(people.population.vision.jnd_lab, 2.3);
  EXPECT_EQ(people.population.gaze.fixations_per_head_turn, 3.0);
  EXPECT_EQ(people.population.background.age_mean_years, 30.0);
  EXPECT_EQ((people.numbers.size() + 1) * sizeof(double), sizeof(Population))
      << "all numbers are stated, but for a study's coarseness, and none else";
  for (const StatedNumber& number : people.numbers) {
    EXPECT_GT(number.source.size(), 6U) << number.name;
  }
  EXPECT_THAT(people_names(), Contains("adults"));
}

TEST(People, EveryNumberOfTheFileReachesItsOwnPlace) {
  const TemporaryFolder folder;
  const People people = read_people("adults");
  for (const StatedNumber& number : people.numbers) {
    const double other = number.value == 0.5 ? 0.75 : number.value + 1e-3 * (1.0 + number.value);
    const Population changed =
        read_people(
            folder.write("other.toml", toml_with_number(people, number.name, other)).string())
            .population;

    const auto* before = reinterpret_cast<const double*>(&people.population);
    const auto* after = reinterpret_cast<const double*>(&changed);
    const auto place = static_cast<std::size_t>(&number - people.numbers.data());
    for (std::size_t i = 0; i < people.numbers.size(); ++i) {
      EXPECT_EQ(after[i], i == place ? other : before[i]) << number.name;
    }
  }
}

TEST(People, AFileOfOnesOwnIsReadByItsPath) {
  const TemporaryFolder folder;
  const std::string text = with("value = 2.3, source = \"Mahy", "value = 1.0, source = \"Mahy");
  const People people = read_people(folder.write("keen.toml", text).string());
  EXPECT_EQ(people.name, "keen");
  EXPECT_EQ(people.population.vision.jnd_lab, 1.0);
  EXPECT_EQ(people.toml, text);
}

TEST(People, WhatIsWrongWithAFileIsSaidWithItsPlace) {
  struct Fault {
    std::string instead;
    std::string says;
  };
  const auto refused = [](const std::string& key, const std::vector<Fault>& faults) {
    const std::string place = fmt::format("people.toml:{}:", line_of(adults(), key));
    for (const Fault& fault : faults) {
      EXPECT_THAT(refusal(with(key, fault.instead)), AllOf(HasSubstr(place), HasSubstr(fault.says)))
          << fault.instead;
    }
  };
  refused("glance_noise = { value = 0.1",
          {{"glance_noise = { value = -0.1", "out of range"},
           {"glance_noise = { value = \"much\"", ""},
           {"glance_noise = { number = 0.1", "value is missing"},
           {"blinks = { value = 1.0, source = \"assumed\" }\nglance_noise = { value = 0.1",
            "unknown key 'decision.blinks'"}});
  // Each number needs a source.
  refused("lapse_s = { value = 1.0, source = \"assumed\" }",
          {{"lapse_s = { value = 1.0 }", "source is missing"},
           {"lapse_s = { value = 1.0, source = \"\" }", ""},
           {"lapse_s = 1.0", ""}});
  EXPECT_THAT(refusal(with("glance_noise =", "glance_nois =")),
              AllOf(HasSubstr("people.toml:"), HasSubstr("decision.glance_noise is missing")));
  EXPECT_THAT(refusal(with("[rating]", "[ratings]")), HasSubstr("people.toml:"));
  EXPECT_THAT(refusal("title = \n"), HasSubstr("people.toml:1:"));
  EXPECT_THAT(
      refusal(with("longest_fixation_s = { value = 0.35", "longest_fixation_s = { value = 0.1")),
      AllOf(HasSubstr("people.toml:"), HasSubstr("shorter than the minimum")));
}

TEST(People, UnknownNamesAreRefused) {
  EXPECT_THROW(read_people("martians"), Error);
  const People people = read_people("adults");
  EXPECT_THROW(toml_with_number(people, "decision.courage", 1.0), Error);
  EXPECT_THROW(toml_with_number(people, "vision.jnd_lab", -1.0), Error);
}

}  // namespace
}  // namespace foveola::study
