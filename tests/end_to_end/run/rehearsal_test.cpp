// A rehearsal whose scene is worked on meanwhile.
#include <string>

#include "renderer/glb/glb_document.h"
#include "renderer/image/image_file.h"
#include "tests/end_to_end/run/study_run.h"
#include "tests/matchers.h"

namespace foveola::test {
namespace {

/// The hall with walls of this colour, as its glTF file writes it.
std::string hall_in(const std::string& color) {
  return glb_container(replaced(room_gltf(), "0.6,0.6,0.6", color), "");
}

/// How much of what shines in a page's picture is red.
double redness(const std::filesystem::path& picture) {
  Vec3 sum(0.0F);
  for (const Vec3& pixel : read_film_image(picture).color.pixels) {
    sum += pixel;
  }
  return sum.x / (sum.x + sum.y + sum.z);
}

class Rehearsal : public StudyRun {
 protected:
  /// Until the participant chooses an object of the hall, whose walls are gray.
  void begin(const std::vector<std::string>& options) {
    participant_.write_protocol(one_trial_keys, short_look);
    participant_.begin(options);
    participant_.answer_page("Return");  // welcome
    EXPECT_EQ(participant_.wait_for_page(), "choosing_object");
    EXPECT_NEAR(redness(participant_.picture()), 1.0 / 3.0, 0.05);
  }

  std::string wait_for_note(const std::string& words) {
    return participant_.program().wait_for("Note: the " + words);
  }
};

TEST_F(Rehearsal, ShowsTheSceneAsItChanges) {
  begin({"--pilot"});
  participant_.replace_scene(hall_in("0.6,0.0,0.0"));
  wait_for_note("scene hall has changed; from here on its SHA-256 is ");
  EXPECT_EQ(participant_.wait_for_page(), "choosing_object");
  EXPECT_GT(redness(participant_.picture()), 0.6);
  participant_.type("Return");
  EXPECT_EQ(participant_.wait_for_page(), "ready");
  participant_.type("space");
  EXPECT_EQ(participant_.wait_for_page(), "marking");
  participant_.replace_scene("not a scene");
  EXPECT_THAT(wait_for_note("changed scene hall cannot be shown: "), HasSubstr("hall.glb"));
  participant_.replace_scene(hall_in("0.0,0.6,0.0"));
  wait_for_note("scene hall has changed; from here on its SHA-256 is ");
  EXPECT_EQ(participant_.wait_for_page(), "marking");
  EXPECT_LT(redness(participant_.picture()), 0.2);
  participant_.type("space");
  EXPECT_EQ(participant_.wait_for_page(), "marking");
  participant_.type("space");
  EXPECT_EQ(participant_.wait_for_page(), "rating");
  EXPECT_THAT(participant_.ask("SELECT count(*) FROM event WHERE type = 'note_written'"),
              ElementsAre("3"));
}

TEST_F(Rehearsal, MayTryAnotherFilterOfTheGaze) {
  begin({"--pilot", "--gaze-filter", "extrapolate=0.03"});
  EXPECT_THAT(participant_.ask("SELECT devices -> '$.tracker' FROM session"),
              ElementsAre(R"({"profile":"pointer","filter":{"extrapolate_s":0.03}})"));
}

TEST_F(Rehearsal, WhoIsMeasuredSeesOneSceneOnly) {
  begin({});
  participant_.replace_scene(hall_in("0.6,0.0,0.0"));
  participant_.type("Return");
  time_trial();
  EXPECT_NEAR(redness(participant_.picture()), 1.0 / 3.0, 0.05);
}

}  // namespace
}  // namespace foveola::test
