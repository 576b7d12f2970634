// What `study check` and `study plan` print.
#include "study/tables/protocol_tables.h"

#include <nlohmann/json.hpp>

#include "study/tables/protocol_json.h"
#include "tests/matchers.h"

namespace foveola::study {
namespace {

Protocol protocol_with(const std::string& tables) {
  return read_protocol(
      "name = \"small\"\ntitle = \"A small one\"\nscenes = [\"arcade\", \"room\"]\n"
      "methods = [\"od\", \"fv\"]\nscene_order = \"fixed\"\nmethod_order = \"williams\"\n" +
          tables,
      "p.toml");
}

std::vector<Plan> two_plans(const Protocol& protocol) {
  return {make_plan(protocol, 1, 0), make_plan(protocol, 1, 1)};
}

TEST(PlanTable, HasALineForEachScene) {
  EXPECT_EQ(plan_table(two_plans(protocol_with(""))),
            "participant  position  scene   methods\n"
            "P001         1         arcade  od, fv\n"
            "P001         2         room    fv, od\n"
            "P002         1         arcade  fv, od\n"
            "P002         2         room    od, fv\n");
}

TEST(PlanTable, ShowsPracticeAndCatchTrials) {
  const Protocol protocol =
      protocol_with("[[practice]]\nscene = \"room\"\nmethod = \"fv\"\n[catch_trials]\ncount = 4\n");
  EXPECT_EQ(plan_table({make_plan(protocol, 1, 0)}),
            "participant  position  scene   methods\n"
            "P001         practice  room    fv\n"
            "P001         1         arcade  od, (catch), fv, (catch)\n"
            "P001         2         room    fv, (catch), od, (catch)\n");
}

TEST(BalanceTable, CountsWhatComesWhere) {
  const Protocol protocol = protocol_with("");
  EXPECT_EQ(balance_table(protocol, balance_of(protocol, two_plans(protocol))),
            "methods  at 1  at 2  after od  after fv\n"
            "od       2     2     -         2\n"
            "fv       2     2     2         -\n"
            "\n"
            "scenes  at 1  at 2  after arcade  after room\n"
            "arcade  2     0     -             0\n"
            "room    0     2     2             -\n"
            "\n"
            "largest difference  at positions  in one scene  after one another\n"
            "methods             0             0             0\n"
            "scenes              2                           2\n");
}

TEST(DurationTable, AddsItsPartsUp) {
  EXPECT_THAT(
      duration_table({{"reaction", 10, {60.0, 90.0}}, {"trials", 4, {120.0, 600.0}}}),
      AllOf(HasSubstr("reaction    10  1.0       1.5\n"),
            HasSubstr("trials      4   2.0       10.0\n"),
            HasSubstr("a session       3.0       11.5\n"), HasSubstr("choosing an object")));
}

TEST(ProtocolTable, SaysWhatTheProtocolSays) {
  const std::string table = protocol_table(protocol_with(R"(
[[override]]
scene = "room"
timing.mark_timeout_s = 7
[reaction]
presses = 6
[[questionnaire]]
id = "after"
file = "sus"
[analysis]
participants = 9
[[analysis.primary]]
measure = "outline"
method = "fv"
)"),
                                           {});
  EXPECT_THAT(table, HasSubstr("reaction, trials, after"));
  EXPECT_THAT(table, HasSubstr("williams, 2 rows within each scene"));
  EXPECT_THAT(table, HasSubstr("room with fv: "));
  EXPECT_THAT(table, HasSubstr("marks within 7 s"));
  EXPECT_THAT(table, HasSubstr("6 presses after 1 to 3 s"));
  EXPECT_THAT(table, HasSubstr("sus_10 (1 to 5)"));
  EXPECT_THAT(table, HasSubstr("9 participants"));
  EXPECT_THAT(table, HasSubstr("outline: fv against od\n"));
  EXPECT_THAT(table,
              HasSubstr("family        the 1 primary comparison, by Holm's method; alpha 0.05"));
}

TEST(ProtocolTable, SaysTheMemoryOfTheLargestFilm) {
  EXPECT_THAT(protocol_table(protocol_with("[film]\nwidth = 4096\nheight = 2048\n"), {}),
              HasSubstr("memory        up to 340 MB for the film"));
  EXPECT_THAT(protocol_table(protocol_with("[film]\nwidth = 4096\nheight = 2048\n[[override]]\n"
                                           "scene = \"room\"\nfilm.height = 4096\n"),
                             {}),
              HasSubstr("memory        up to 680 MB for the film"));
}

const char* const filtered = R"([tracker.filter]
one_euro.beta_per_deg = 0.5
extrapolate_s = 0.03
hold_s = 0.6
)";

TEST(ProtocolTable, SaysWhatFiltersTheGaze) {
  EXPECT_THAT(protocol_table(protocol_with(filtered), {}),
              HasSubstr("gaze filter   1-Euro (at least 1 Hz, 0.5 Hz more for each degree/s, "
                        "velocity 10 Hz), extrapolated by 0.03 s, held for 0.6 s\n"));
  EXPECT_THAT(protocol_table(protocol_with(""), {}), Not(HasSubstr("gaze filter")));
}

TEST(ProtocolJson, SaysWhatFiltersTheGaze) {
  EXPECT_EQ(json_of(protocol_with(filtered)).at("gaze_filter"), nlohmann::json::parse(R"({
    "one_euro": {"min_cutoff_hz": 1.0, "beta_per_deg": 0.5, "derivative_cutoff_hz": 10.0},
    "extrapolate_s": 0.03,
    "hold_s": 0.6})"));
  EXPECT_EQ(json_of(protocol_with("")).at("gaze_filter"), nlohmann::json::object());
}

TEST(ProtocolJson, HasTheSameForMachines) {
  const Protocol protocol = protocol_with("[[practice]]\nscene = \"room\"\nmethod = \"fv\"\n");
  const nlohmann::json json = json_of(protocol);
  EXPECT_EQ(json.at("design_rows"), 2);
  EXPECT_EQ(json.at("phases"), nlohmann::json::array({"trials"}));
  EXPECT_EQ(json.at("trials_per_participant"), 4);
  const nlohmann::json plan = json_of(make_plan(protocol, 1, 0));
  EXPECT_EQ(plan.size(), 5U);
  EXPECT_EQ(plan.at(0).at("kind"), "practice");
  const nlohmann::json balance = json_of(protocol, balance_of(protocol, two_plans(protocol)));
  EXPECT_EQ(balance.at("method_at"), nlohmann::json::parse("[[2, 2], [2, 2]]"));
  EXPECT_EQ(balance.at("largest_difference").at("scene_at"), 2);
  const nlohmann::json time = json_of({{"reaction", 10, {60.0, 90.0}}});
  EXPECT_EQ(time.at("least_s"), 60.0);
  EXPECT_EQ(time.at("parts").at(0).at("part"), "reaction");
}

}  // namespace
}  // namespace foveola::study
