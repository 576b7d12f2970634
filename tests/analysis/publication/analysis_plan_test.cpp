#include "analysis/publication/analysis_plan.h"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/base/error.h"
#include "renderer/base/files.h"

namespace foveola::analysis {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

const std::filesystem::path protocols =
    std::filesystem::path(FOVEOLA_DATA_DIR).parent_path() / "protocols";

TEST(AnalysisPlan, IsThatOfTheProtocol) {
  const std::filesystem::path path = protocols / "koskela2018.toml";
  const study::AnalysisPlan read = plan_of(read_file(path));
  const study::AnalysisPlan protocols_own = study::load_protocol(path).analysis;
  EXPECT_EQ(read.alpha, protocols_own.alpha);
  EXPECT_EQ(read.participants, 16);
  ASSERT_EQ(read.primary.size(), protocols_own.primary.size());
  EXPECT_TRUE(is_primary(read, "outline", "fv", "od"));
  EXPECT_TRUE(is_primary(read, "material", "fv", "od"));
  EXPECT_FALSE(is_primary(read, "outline", "vp", "od"));
  EXPECT_FALSE(is_primary(read, "artifacts", "fv", "od"));
  EXPECT_FALSE(equivalence_margin(read, "artifacts"));
}

TEST(AnalysisPlan, ABaselineThatIsNotNamedIsTheFirstMethod) {
  const study::AnalysisPlan plan = plan_of(
      "methods = [\"vp\", \"fv\"]\n[analysis]\nalpha = 0.01\n"
      "[[analysis.primary]]\nmeasure = \"artifacts\"\nmethod = \"fv\"\n"
      "[analysis.equivalence_margins]\nartifacts = 0.5\noutline = 1.25\n");
  EXPECT_EQ(plan.alpha, 0.01);
  EXPECT_TRUE(is_primary(plan, "artifacts", "fv", "vp"));
  EXPECT_EQ(equivalence_margin(plan, "artifacts"), 0.5);
  EXPECT_EQ(equivalence_margin(plan, "outline"), 1.25);
}

TEST(AnalysisPlan, ComparisonsOfWhatHasNoTablesAreCounted) {
  const auto plan = [](const std::string& measures) {
    return plan_of("methods = [\"od\", \"fv\"]\n[analysis]\nprimary = [" + measures + "]\n");
  };
  EXPECT_EQ(planned_without_tables(plan_of("")), 0U);
  const std::string carried =
      "{ measure = \"outline\", method = \"fv\" }, { measure = \"artifacts\", method = \"fv\" }";
  EXPECT_EQ(planned_without_tables(plan(carried)), 0U);
  EXPECT_EQ(planned_without_tables(plan(carried + ", { measure = \"comfort\", method = \"fv\" }")),
            1U);
}

TEST(AnalysisPlan, WithoutOneNothingIsPlanned) {
  EXPECT_TRUE(plan_of("").primary.empty());
  EXPECT_FALSE(plan_of("name = \"x\"").participants);
}

TEST(AnalysisPlan, WhatIsNoPlanIsAnErrorWithItsPlace) {
  EXPECT_THAT([] { (void)plan_of("[analysis]\nalpha = 2\n"); },
              ThrowsMessage<Error>(HasSubstr("the study's protocol:2:")));
  EXPECT_THAT([] { (void)plan_of("[analysis"); }, ThrowsMessage<Error>(HasSubstr("protocol:1:")));
}

}  // namespace
}  // namespace foveola::analysis
