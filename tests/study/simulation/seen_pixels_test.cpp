// That a simulated session's times come from the pixels that its participant is shown, and from
// nothing else that the session knows.
#include <algorithm>
#include <span>

#include "study/participant/population_file.h"
#include "study/participant/simulated_participant.h"
#include "study/record/write/recorders.h"
#include "study/simulation/rendered_attempt.h"
#include "study/simulation/virtual_session.h"
#include "tests/matchers.h"
#include "tests/scenes/environment.h"
#include "tests/study/record/small_study.h"
#include "tests/study/simulation/small_wall.h"

namespace foveola::study {
namespace {

/// What a participant sees at the `glance`-th look in a trial, instead of what is presented.
using Glasses = std::function<RgbImage(std::size_t trial, std::size_t glance, RgbImage presented)>;

/// Somebody who wears glasses, and takes every trial as if it were the first one: all trials leave
/// the same to chance.
class WearsGlasses final : public SimulatedParticipant {
 public:
  WearsGlasses(const SimulatedParticipant& person, Glasses glasses)
      : SimulatedParticipant(person), glasses_(std::move(glasses)) {}

  void begin_attempt(const Attempt& attempt) override {
    trial_ = static_cast<std::size_t>(attempt.trials_before);
    glance_ = 0;
    SimulatedParticipant::begin_attempt({.conduct = 1});
  }
  std::optional<Nanoseconds> see(const Stimulus& stimulus) override {
    const RgbImage image = glasses_(trial_, glance_++, stimulus.image);
    return SimulatedParticipant::see({.image = image,
                                      .viewport = stimulus.viewport,
                                      .gaze = stimulus.gaze,
                                      .presented = stimulus.presented});
  }

 private:
  Glasses glasses_;
  std::size_t trial_ = 0;
  std::size_t glance_ = 0;
};

/// Without lapses and early presses, which come whatever is to be seen.
Population careful_adults() {
  Population population = read_people("adults").population;
  population.decision.lapse_part = 0.0;
  population.decision.early_part = 0.0;
  return population;
}

class SeenPixels : public testing::Test {
 protected:
  SeenPixels() {
    stages_["wall"] = std::make_unique<SceneStage>(wall_with_a_square(folder_), workers_);
    stages_["wall"]->render_reference(protocol_.film, protocol_.reference, workers_, [](double) {},
                                      {});
  }

  /// What came of the marks in the trials with od and fv, and their ratings.
  struct Results {
    std::vector<std::string> od;
    std::vector<std::string> fv;
    bool operator==(const Results&) const = default;
  };

  /// A session of its own, with what the participant is shown through these glasses.
  Results results_through(const Glasses& glasses) {
    const std::string code = "P" + std::to_string(++sessions_);
    SessionFacts facts = facts_of(code);
    facts.scenes.clear();
    const std::int64_t id = store_.begin_session(facts, plan_);
    StoreRecorder recorder(store_, id);
    const SceneKnowledge knowledge = [this](const std::string& scene) {
      return KnownScene{.panorama = &stages_.at(scene)->reference()};
    };
    WearsGlasses participant(SimulatedParticipant(careful_adults(), knowledge, 3), glasses);
    VirtualSession session({.protocol = protocol_,
                            .stages = stages_,
                            .recorder = recorder,
                            .make_attempt =
                                [&](const TrialAttemptSetting& setting) {
                                  return std::make_unique<RenderedAttempt>(setting, workers_);
                                },
                            .seed = {.seed = 5, .design_row = 0},
                            .on_trial = [](std::size_t) {},
                            .stop = {}},
                           plan_, participant, {});
    EXPECT_EQ(session.run().phase, Phase::completed);
    return {.od = results_of(id, 0), .fv = results_of(id, 1)};
  }

  std::vector<std::string> results_of(std::int64_t session, int trial) const {
    const std::string where =
        " WHERE session = " + std::to_string(session) + " AND trial = " + std::to_string(trial);
    return query_column(path_, "SELECT kind || ' ' || time_ns || ' ' || censored FROM mark" +
                                   where + " UNION ALL SELECT 'rated ' || value FROM rating" +
                                   where + " ORDER BY 1");
  }

  std::vector<std::string> column(const std::string& sql) const { return query_column(path_, sql); }

  TemporaryFolder folder_;
  scenes::EnvironmentVariable cache_{"XDG_CACHE_HOME", (folder_ / "cache").string()};
  std::filesystem::path path_ = folder_ / "study.sqlite";
  Protocol protocol_ = load_protocol(folder_.write("wall.toml", wall_protocol_text(20'000, 30.0)));
  Plan plan_ = {{.scene = "wall", .method = "od"},
                {.scene = "wall", .method = "fv", .method_position = 1}};
  Workers workers_{2};
  SceneStages stages_;
  StudyStore store_{path_, protocol_};
  int sessions_ = 0;
};

TEST_F(SeenPixels, SwappingTwoMethodsImagesSwapsTheirTimes) {
  std::array<std::vector<RgbImage>, 2> shown;
  const Results first = results_through([&](std::size_t trial, std::size_t, RgbImage presented) {
    return shown.at(trial).emplace_back(std::move(presented));
  });
  ASSERT_THAT(column("SELECT censored FROM mark"), Each("0"));
  ASSERT_NE(first.od, first.fv);
  const Results second = results_through([&](std::size_t trial, std::size_t glance, RgbImage) {
    return shown.at(1 - trial).at(glance);
  });
  EXPECT_EQ(second.od, first.fv);
  EXPECT_EQ(second.fv, first.od);
}

TEST_F(SeenPixels, ScramblingThemBreaksTheMarks) {
  results_through([](std::size_t, std::size_t, RgbImage presented) {
    Pcg32 random(23);
    shuffle(std::span(presented.pixels), random);
    return presented;
  });
  EXPECT_THAT(column("SELECT kind || ' ' || censored FROM mark ORDER BY trial, kind"),
              ElementsAre("material 1", "outline 1", "material 1", "outline 1"));
}

}  // namespace
}  // namespace foveola::study
