// How long a participant looks around and takes to rate, and what the picture does meanwhile.
#include <chrono>
#include <string>
#include <thread>

#include <SQLiteCpp/Database.h>

#include "renderer/image/image_file.h"
#include "study/record/maintain/maintenance.h"
#include "study/record/read/recorded_frames.h"
#include "study/record/sqlite/database.h"
#include "tests/end_to_end/run/study_run.h"

namespace foveola::test {
namespace {

using namespace std::chrono_literals;

struct Rating {
  double looked_around_s = 0.0;
  double response_s = 0.0;
  std::uint64_t samples = 0;  ///< traced after the digit was pressed
  bool is_black = true;       ///< the picture around the question
};

class RatingTimes : public StudyRun {
 protected:
  double seconds(const std::string& sql) const {
    return 1e-9 * std::stod(participant_.ask(sql).at(0));
  }

  /// One trial of a study whose picture does so while it is rated, with bounds by its keys.
  Rating rate_with(const std::string& while_rating) {
    participant_.write_protocol(
        one_trial_keys, "[timing]\nrating_s = 0.2\nwhile_rating = \"" + while_rating + "\"\n");
    participant_.begin();
    participant_.begin_trials();
    const std::vector<KeyPress> marks = time_trial();
    std::this_thread::sleep_for(400ms);
    const KeyPress wants = participant_.type("Return");
    participant_.wait_for_page();
    const RgbImage page = read_film_image(participant_.picture()).color;
    std::this_thread::sleep_for(300ms);
    const KeyPress digit = participant_.type("3");
    std::this_thread::sleep_for(200ms);
    const KeyPress answers = participant_.type("Return");
    participant_.type("Return");
    end_by_enter();
    participant_.expect_no_fault();
    EXPECT_EQ(participant_.replay().exit_code, 0);

    const Rating rating{.looked_around_s = seconds("SELECT looked_around_ns FROM attempt"),
                        .response_s = seconds("SELECT response_ns FROM rating"),
                        .samples = samples_after(digit.taken_s),
                        .is_black = is_black_at_left(page)};
    constexpr double servers_resolution_s = 1e-3;
    EXPECT_GT(rating.looked_around_s, wants.asked_s - marks.back().taken_s - servers_resolution_s);
    EXPECT_LT(rating.looked_around_s, digit.asked_s - 0.3 - marks.back().asked_s);
    EXPECT_GT(rating.response_s, answers.asked_s - digit.asked_s + 0.3 - servers_resolution_s);
    EXPECT_LT(rating.response_s, answers.taken_s - wants.asked_s + servers_resolution_s);
    return rating;
  }

  std::uint64_t samples_after(double time_s) const {
    SQLite::Database study = study::open_study_to_read(participant_.database());
    std::uint64_t samples = 0;
    for (const study::FrameRow& frame : study::frames_of(study, 1, 0, 1)) {
      samples += foveola::seconds(frame.time) > time_s ? frame.samples : 0;
    }
    return samples;
  }

  static bool is_black_at_left(const RgbImage& page) {
    for (int y = page.height / 4; y < page.height / 2; ++y) {  // above the question
      const Rgb& pixel = page.at(2, y);
      if (pixel.r + pixel.g + pixel.b > 0.0F) {
        return false;
      }
    }
    return true;
  }
};

TEST_F(RatingTimes, AreThoseOfTheKeysWhileThePictureConverges) {
  const Rating rating = rate_with("converges");
  EXPECT_GT(rating.samples, 0U);
  EXPECT_FALSE(rating.is_black);
}

TEST_F(RatingTimes, AreTakenBeforeAPictureThatIsHeld) {
  const Rating rating = rate_with("held");
  EXPECT_EQ(rating.samples, 0U);
  EXPECT_FALSE(rating.is_black);
}

TEST_F(RatingTimes, AreTakenBeforeABlackOne) {
  const Rating rating = rate_with("blank");
  EXPECT_EQ(rating.samples, 0U);
  EXPECT_TRUE(rating.is_black);
}

}  // namespace
}  // namespace foveola::test
