// The experimenter's console for machines, through a whole session.
#include <sstream>

#include <nlohmann/json.hpp>

#include "tests/end_to_end/study_run.h"
#include "tests/matchers.h"

namespace foveola::test {
namespace {

/// Of all lines but those of standard error.
std::vector<nlohmann::json> objects_in(const std::string& lines) {
  std::istringstream in(lines);
  std::vector<nlohmann::json> objects;
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with("foveola: ")) {
      objects.push_back(nlohmann::json::parse(line));
    }
  }
  return objects;
}

TEST_F(StudyRun, TellsMachinesAllOfIt) {
  participant_.write_protocol(one_trial_keys, short_look);
  participant_.begin({"--json"});
  participant_.begin_trials();
  time_trial();
  participant_.program().wait_for("\"last_mark\":\"material was marked after");
  participant_.program().type_line("note it rings");
  participant_.program().type_line("lunch");
  participant_.program().wait_for("help says what there is");
  rate("3");
  end_by_enter();

  std::vector<std::string> events;
  std::vector<std::string> texts;
  std::vector<nlohmann::json> statuses;
  const std::vector<nlohmann::json> objects = objects_in(participant_.program().said());
  for (const nlohmann::json& object : objects) {
    if (object["kind"] == "event") {
      events.push_back(std::string(object["event"]) + ", " + std::string(object["words"]));
    } else if (object["kind"] == "text") {
      texts.push_back(object["text"]);
    } else if (object["kind"] == "status") {
      statuses.push_back(object);
    }
  }
  EXPECT_THAT(events, AllOf(Contains(HasSubstr("marked, outline was marked after")),
                            Contains("note_written, Note: it rings")));
  EXPECT_THAT(texts, AllOf(Contains(HasSubstr("samples a second")), Contains(HasSubstr("lunch"))));
  ASSERT_FALSE(statuses.empty());
  EXPECT_EQ(statuses.back()["participant"], "P1");
  EXPECT_EQ(statuses.back()["gaze"]["eye"], "pointer");
  EXPECT_THAT(statuses.back()["last_mark"], HasSubstr("material was marked after"));
  EXPECT_GT(statuses.back()["frames"]["frames"], 0);
  EXPECT_EQ(objects.back()["kind"], "end");
  EXPECT_EQ(objects.back()["phase"], "completed");
}

}  // namespace
}  // namespace foveola::test
