#include "analysis/replication/claims.h"

#include <filesystem>
#include <string>

#include "renderer/base/error.h"
#include "renderer/base/files/files.h"
#include "tests/error_of.h"
#include "tests/matchers.h"
#include "tests/temporary_folder.h"

namespace foveola::analysis {
namespace {

constexpr const char* stage = R"(
[[stage]]
id = "speed"
run = ["bench sampling --json"]
minutes = 1
)";
constexpr const char* claim = R"(
[[stage.claim]]
id = "sooner"
document = "page.md"
text = "FV is {51 [34, 75]} times sooner, with {734 700} samples and −{0.5}, "
figures = ["a", "b", "c"]
relative = 0.1
)";
constexpr const char* page =
    "# Page\n\nFV is 51 [34,\n75] times sooner, with 734 700 samples and\n−0.5, so.\n";

/// A document, and claims of it.
struct Papers {
  test::TemporaryFolder folder;
  std::filesystem::path file;

  explicit Papers(const std::string& claims = std::string(stage) + claim,
                  const std::string& text = page)
      : file(folder.write("data/claims.toml", claims)) {
    folder.write("page.md", text);
  }

  std::vector<std::string> faults() const { return faults_of_documents(read_claims(file)); }
};

std::string refusal_of(const std::string& claims) {
  const Papers papers(claims);
  return test::error_of([&] { (void)read_claims(papers.file); });
}

TEST(Claims, StandInTheDocumentsOfThisRepository) {
  const std::filesystem::path file =
      std::filesystem::path(TEST_DATA_DIR) / "../../data/claims.toml";
  EXPECT_THAT(faults_of_documents(read_claims(file)), IsEmpty());
}

TEST(Claims, StandAcrossLines) { EXPECT_THAT(Papers().faults(), IsEmpty()); }

TEST(Claims, ANumberThatWasChangedInADocumentIsFound) {
  const auto faults_with = [](std::string text, const std::string& from, const std::string& to) {
    return Papers(std::string(stage) + claim, text.replace(text.find(from), from.size(), to))
        .faults();
  };
  EXPECT_THAT(faults_with(page, "734 700", "734 800"),
              ElementsAre(AllOf(HasSubstr("page.md:4: "), HasSubstr("734 700 of claim 'sooner'"),
                                HasSubstr("claims.toml:7"))));
  EXPECT_THAT(faults_with(page, "34,", "35,"), ElementsAre(HasSubstr("page.md:3: ")));
  EXPECT_THAT(faults_with(page, "0.5", "0.55"), ElementsAre(HasSubstr("page.md:5: ")));
  EXPECT_THAT(faults_with(page, "# Page", page), ElementsAre(HasSubstr("more than once")));
}

TEST(Claims, BadOnesAreRefusedWithTheirPlace) {
  const auto without = [](std::string text, const std::string& part) {
    return std::string(stage) + text.replace(text.find(part), part.size(), "");
  };
  EXPECT_THAT(refusal_of(without(claim, "relative = 0.1\n")),
              HasSubstr("claims.toml:7:1: claim 'sooner' has no tolerance"));
  EXPECT_THAT(refusal_of(without(claim, R"(, "c")")), HasSubstr("claims.toml:11"));
  EXPECT_THAT(refusal_of(without(claim, "FV is ")), HasSubstr("words before and after"));
  EXPECT_THAT(refusal_of(std::string(stage) + claim + claim),
              HasSubstr("repeats the id of another claim"));
  EXPECT_THAT(refusal_of(std::string(stage) + claim + "relativ = 1\n"), HasSubstr("relativ"));
  EXPECT_THAT(refusal_of("[[stage]]\nid = \"a\"\n"), HasSubstr("needs is missing"));
}

TEST(Claims, ValuesAreWrittenAsTheOldOnesWere) {
  EXPECT_EQ(shown_like("19.5", {7.0}), "7.0");
  EXPECT_EQ(shown_like("734 700", {1234567.8}), "1 234 568");
  EXPECT_EQ(shown_like("734 700", {999.6}), "1 000");
  EXPECT_EQ(shown_like("−0.55", {-0.246}), "−0.25");
  EXPECT_EQ(shown_like("0.5", {-0.26}), "-0.3");
  EXPECT_EQ(shown_like("51 [34, 75.5]", {48.7, Interval{40.2, 60.0}}), "49 [40, 60.0]");
}

TEST(Claims, ValuesAreWrittenIntoDocumentsAndClaims) {
  const Papers papers;
  const Claims claims = read_claims(papers.file);
  const Claim& first = claims.stages.front().claims.front();
  write_values(claims, {{&first, {{7.4, Interval{5.0, 10.0}}, {1e6}, {0.25}}}});
  EXPECT_EQ(read_file(papers.folder / "page.md"),
            "# Page\n\nFV is 7 [5, 10] times sooner, with 1 000 000 samples and\n−0.2, so.\n");
  EXPECT_THAT(read_file(papers.file),
              HasSubstr("FV is {7 [5, 10]} times sooner, with {1 000 000} samples and −{0.2}, "));
  EXPECT_THAT(papers.faults(), IsEmpty());
  EXPECT_EQ(read_claims(papers.file).sha256, claims.sha256) << "results are of the same claims";
}

// Half a unit of the last digit is allowed beside each tolerance.
TEST(Claims, LieWithinTheirTolerances) {
  const ClaimedNumber number{
      .shown = "50 [40, 60]", .claimed = {50.0, Interval{40.0, 60.0}}, .figure = ""};
  EXPECT_TRUE(is_within({.absolute = 2.0}, number, {52.5}));
  EXPECT_FALSE(is_within({.absolute = 2.0}, number, {52.6}));
  EXPECT_FALSE(is_within({.absolute = 2.0}, number, {47.4}));
  EXPECT_TRUE(is_within({.relative = 0.1}, number, {55.5}));
  EXPECT_FALSE(is_within({.relative = 0.1}, number, {55.6}));
  // Both standard errors are 20 / 3.92; that of the difference is 7.215.
  EXPECT_TRUE(is_within({.standard_errors = 2.0}, number, {64.9, Interval{54.9, 74.9}}));
  EXPECT_FALSE(is_within({.standard_errors = 2.0}, number, {65.0, Interval{55.0, 75.0}}));
}

}  // namespace
}  // namespace foveola::analysis
