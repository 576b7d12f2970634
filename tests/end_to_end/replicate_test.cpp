// Claims made again as a user does it, by commands that take no time.
#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "renderer/base/files/files.h"
#include "tests/end_to_end/program.h"
#include "tests/matchers.h"

namespace foveola::test {
namespace {

constexpr const char* film_claims = R"(
[[stage]]
id = "film"
run = ["study check demo --json"]
minutes = 1
quick = true

[[stage.claim]]
id = "film-bytes"
document = "page.md"
text = "The film has {518 400} bytes."
figures = ["film_bytes"]
relative = 0.01

[[stage]]
id = "plan"
run = ["study plan demo --participants 4 --json"]
minutes = 1

[[stage.claim]]
id = "balance"
document = "page.md"
text = "differ by {4} at most"
figures = ["balance.largest_difference.method_after"]
absolute = 0

[[stage]]
id = "by-hand"
needs = "a person"

[[stage.claim]]
id = "hands"
document = "page.md"
text = "people have {2} hands"
)";

class Replicate : public testing::Test {
 protected:
  Replicate() {
    claims(film_claims);
    folder_.write(
        "page.md",
        "The film has 518 400 bytes. Methods differ by 4 at most; people have 2 hands.\n");
  }

  void claims(const std::string& text) const { folder_.write("data/claims.toml", text); }

  ProgramResult run(const std::string& name, const std::vector<std::string>& options = {}) const {
    return run_foveola(joined({"replicate", (folder_ / name).string(), "--claims",
                               (folder_ / "data/claims.toml").string()},
                              options));
  }

  std::string kept(const std::string& name) const { return read_file(folder_ / name); }

  const TemporaryFolder folder_;
};

TEST_F(Replicate, PutsWhatIsMadeBesideWhatIsClaimed) {
  const auto page = nlohmann::json::parse(succeeded(run("made", {"--json"})).output);
  EXPECT_EQ(page["Claims"][0]["made"], "518 400");
  EXPECT_EQ(page["Claims"][0]["verdict"], "within");
  EXPECT_EQ(page["Claims"][2]["verdict"], "not made here");
  EXPECT_EQ(page["Claims"][2]["remark"], "a person");
  EXPECT_EQ(page["Stages"][0]["program_sha256"].get<std::string>().size(), 64U);
  EXPECT_THAT(kept("made/replication.html"), HasSubstr(">film-bytes</th>"));
}

TEST_F(Replicate, MakesNoStageAgain) {
  succeeded(run("made", {"--quick"}));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "made/stages/plan.json"));
  const std::string film = kept("made/stages/film.json");
  succeeded(run("made"));
  EXPECT_EQ(kept("made/stages/film.json"), film) << "it has the time that it took";
  EXPECT_THAT(kept("made/stages/plan.json"), HasSubstr("largest_difference"));
}

TEST_F(Replicate, EndsWithOneOutsideATolerance) {
  claims(replaced(film_claims, "{518 400}", "{500 000}"));
  folder_.write("page.md", replaced(kept("page.md"), "518 400", "500 000"));
  const ProgramResult result = run("made", {"--write"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.errors,
              HasSubstr("lists 1 number outside the tolerance and 0 faults of documents"));
  EXPECT_THAT(kept("page.md"), StartsWith("The film has 518 400 bytes."));
  succeeded(run("made"));
}

TEST_F(Replicate, EndsWithOneForAChangedDocument) {
  folder_.write("page.md", replaced(kept("page.md"), "518 400", "518 401"));
  const ProgramResult result = run("made");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.errors,
              HasSubstr("page.md:1: does not state the 518 400 of claim 'film-bytes'"));
}

TEST_F(Replicate, TakesWhatOtherMachinesMade) {
  succeeded(run("here", {"--only", "film-bytes"}));
  succeeded(run("there", {"--only", "plan"}));
  succeeded(run("both", {"--from", (folder_ / "here").string(), (folder_ / "there").string()}));
  EXPECT_EQ(kept("both/stages/film.json"), kept("here/stages/film.json"));
  EXPECT_EQ(kept("both/stages/plan.json"), kept("there/stages/plan.json"));
}

TEST_F(Replicate, RefusesInOneLine) {
  expect_one_line(run("made", {"--only", "film-byte"}), 1, "did you mean 'film-bytes'?");
  succeeded(run("made", {"--quick"}));
  claims(replaced(film_claims, "relative = 0.01", "relative = 0.02"));
  expect_one_line(run("made"), 1,
                  "film.json: is damaged, or was made by another version or for other claims");
  for (const char* const kept : {R"({"version": 1, "result": 2})", "[]", "no JSON"}) {
    folder_.write("made/stages/film.json", kept);
    expect_one_line(run("made"), 1,
                    "film.json: is damaged, or was made by another version or for other claims");
  }
  claims(replaced(film_claims, "relative = 0.01", ""));
  expect_one_line(run("made"), 1, "claims.toml:8:1: claim 'film-bytes' has no tolerance");
}

TEST_F(Replicate, AStageThatMakesNothingSaysWhy) {
  claims(replaced(film_claims, "check demo", "check demmo"));
  const auto failed = nlohmann::json::parse(run("made", {"--json"}).output);
  EXPECT_THAT(failed["Claims"][0]["remark"], HasSubstr("demmo"));
  EXPECT_EQ(run("made").exit_code, 1);
  claims(replaced(replaced(film_claims, "check demo", "check demmo"), "quick = true",
                  "needs = \"luck\""));
  succeeded(run("elsewhere"));
}

}  // namespace
}  // namespace foveola::test
