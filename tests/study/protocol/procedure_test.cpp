// What a protocol says of a session: orders, marks, ratings, phases, overrides, analysis.
#include <vector>

#include "tests/matchers.h"
#include "tests/study/protocol/protocol_folder.h"

namespace foveola::study {
namespace {

Protocol load(const std::string& text) { return read_protocol(text, "p.toml"); }

std::vector<std::string> phases_of(const Protocol& protocol) {
  std::vector<std::string> names;
  for (const PhaseEntry& phase : protocol.phases) {
    names.push_back(name_of(phase));
  }
  return names;
}

TEST(Procedure, EveryKeyIsRead) {
  const Protocol protocol = load(R"(language = "fi"
scene_order = "latin"
method_order = "williams"
object = "per method"
phases = ["after", "consent", "background", "reaction", "trials"]
)" + minimal + R"(
[texts]
consent = "Suostun."
ready_title = "Valmiina {trial}?"
[[mark]]
id = "shape"
instruction = "Press at its shape."
[[rating]]
id = "noise"
text = "How noisy?"
minimum = 0
maximum = 2
labels = ["not", "some", "very"]
[[rating]]
id = "liked"
text = "Did you like it?"
kind = "choice"
options = [{ label = "yes", value = 1 }, { label = "no" }]
[[practice]]
scene = "room"
method = "fv"
[catch_trials]
count = 4
timeout_s = 5.5
[reaction]
presses = 3
shortest_wait_s = 0.5
longest_wait_s = 0.75
[looking]
object_out_of_view = "retime"
[preflight]
max_late_percent = 2.5
min_samples_per_second = 100000
min_gaze_rate_hz = 100
max_gaze_loss = 0.25
max_gaze_age_s = 0.025
min_free_gb = 2
tracked_eye = true
stated_display = true
set_clock = true
[[questionnaire]]
id = "after"
title = "Afterwards"
intro = "Two more."
source = "Somebody 1999"
[[questionnaire.question]]
id = "years"
text = "For how long?"
kind = "number"
minimum = 0
maximum = 80.5
[[questionnaire.question]]
id = "words"
text = "What else?"
kind = "text"
required = false
[[questionnaire]]
id = "background"
title = "You"
[[questionnaire.question]]
id = "expertise"
text = "How much?"
minimum = 1
maximum = 7
[analysis]
participants = 12
alpha = 0.01
background = ["expertise"]
[[analysis.primary]]
measure = "shape"
method = "fv"
[[analysis.primary]]
measure = "noise"
method = "od"
baseline = "fv"
[analysis.equivalence_margins]
shape = 1.25
noise = 0.5
)");
  EXPECT_EQ(protocol.language, "fi");
  EXPECT_EQ(protocol.scene_order, Order::latin);
  EXPECT_EQ(protocol.method_order, Order::williams);
  EXPECT_EQ(protocol.object_choice, ObjectChoice::per_method);
  EXPECT_THAT(phases_of(protocol),
              ElementsAre("after", "consent", "background", "reaction", "trials"));
  EXPECT_EQ(text_of(protocol.texts, "consent"), "Suostun.");
  EXPECT_EQ(text_of(protocol.texts, "ready_title"), "Valmiina {trial}?");
  ASSERT_EQ(protocol.marks.size(), 1U);
  EXPECT_EQ(protocol.marks[0].id, "shape");
  EXPECT_EQ(protocol.marks[0].instruction, "Press at its shape.");
  ASSERT_EQ(protocol.ratings.size(), 2U);
  EXPECT_EQ(protocol.ratings[0].text, "How noisy?");
  EXPECT_EQ(protocol.ratings[0].maximum, 2.0);
  EXPECT_THAT(protocol.ratings[0].labels, ElementsAre("not", "some", "very"));
  EXPECT_EQ(protocol.ratings[1].kind, QuestionKind::choice);
  ASSERT_EQ(protocol.ratings[1].options.size(), 2U);
  EXPECT_EQ(protocol.ratings[1].options[0].value, 1.0);
  EXPECT_EQ(protocol.ratings[1].options[1].label, "no");
  EXPECT_FALSE(protocol.ratings[1].options[1].value);
  ASSERT_EQ(protocol.practice.size(), 1U);
  EXPECT_EQ(protocol.practice[0].scene, "room");
  EXPECT_EQ(protocol.practice[0].method, "fv");
  EXPECT_EQ(protocol.catch_trials.count, 4);
  EXPECT_EQ(protocol.catch_trials.timeout_s, 5.5);
  ASSERT_TRUE(protocol.reaction);
  EXPECT_EQ(protocol.reaction->presses, 3);
  EXPECT_EQ(protocol.reaction->shortest_wait_s, 0.5);
  EXPECT_EQ(protocol.reaction->longest_wait_s, 0.75);
  EXPECT_EQ(protocol.looking.object_out_of_view, Remedy::retime);
  EXPECT_EQ(protocol.looking.gaze_elsewhere, Remedy::flag);
  const PreflightGate& gate = protocol.preflight;
  EXPECT_EQ(gate.max_late_percent, 2.5);
  EXPECT_EQ(gate.min_samples_per_second, 1e5);
  EXPECT_EQ(gate.min_gaze_rate_hz, 100.0);
  EXPECT_EQ(gate.max_gaze_loss, 0.25);
  EXPECT_EQ(gate.max_gaze_age_s, 0.025);
  EXPECT_EQ(gate.min_free_gb, 2.0);
  EXPECT_TRUE(gate.tracked_eye && gate.stated_display && gate.set_clock);
  const Questionnaire& after = questionnaire_of(protocol, "after");
  EXPECT_EQ(after.title, "Afterwards");
  EXPECT_EQ(after.intro, "Two more.");
  EXPECT_EQ(after.source, "Somebody 1999");
  ASSERT_EQ(after.questions.size(), 2U);
  EXPECT_EQ(after.questions[0].kind, QuestionKind::number);
  EXPECT_EQ(after.questions[0].maximum, 80.5);
  EXPECT_TRUE(after.questions[0].required);
  EXPECT_EQ(after.questions[1].kind, QuestionKind::text);
  EXPECT_FALSE(after.questions[1].required);
  EXPECT_EQ(protocol.analysis.participants, 12);
  EXPECT_EQ(protocol.analysis.alpha, 0.01);
  EXPECT_THAT(protocol.analysis.background, ElementsAre("expertise"));
  ASSERT_EQ(protocol.analysis.primary.size(), 2U);
  EXPECT_EQ(protocol.analysis.primary[0].measure, "shape");
  EXPECT_EQ(protocol.analysis.primary[0].baseline, "od") << "the protocol's first";
  EXPECT_EQ(protocol.analysis.primary[1].method, "od");
  EXPECT_EQ(protocol.analysis.primary[1].baseline, "fv");
  EXPECT_THAT(protocol.analysis.equivalence_margins,
              ElementsAre(testing::Pair("noise", 0.5), testing::Pair("shape", 1.25)));
}

TEST(Procedure, PhasesHaveAnOrderOfTheirOwn) {
  const auto questionnaire = [](const std::string& id) {
    return "[[questionnaire]]\nid = \"" + id +
           "\"\ntitle = \"t\"\n[[questionnaire.question]]\nid = \"q\"\ntext = \"?\"\n";
  };
  EXPECT_THAT(
      phases_of(load(minimal + "[reaction]\n[texts]\nconsent = \"I agree\"\n" +
                     questionnaire("more") + questionnaire("debrief") +
                     questionnaire("background") + "[tracker.validation]\n")),
      ElementsAre("consent", "background", "validation", "reaction", "trials", "debrief", "more"));
}

// Settings cascade from the protocol to the scene to the method, key by key.
TEST(Procedure, OverridesHoldWhereTheySaySomething) {
  const Protocol protocol = load(minimal + R"(
[timing]
mark_timeout_s = 60
[film]
max_depth = 5
[[override]]
method = "fv"
timing.rating_s = 9
film.max_depth = 7
[[override]]
scene = "room"
method = "fv"
film.width = 100
[[override]]
scene = "room"
film = { max_depth = 6, height = 99 }
fill_unsampled = true
)");
  const TrialSettings plain = settings_of(protocol, "arcade", "od");
  EXPECT_EQ(plain.film.max_depth, 5);
  EXPECT_EQ(plain.film.height, FilmSettings{}.height);
  EXPECT_EQ(plain.timing.mark_timeout_s, 60.0);
  EXPECT_FALSE(plain.fill_unsampled);
  const TrialSettings scene = settings_of(protocol, "room", "od");
  EXPECT_EQ(scene.film.max_depth, 6);
  EXPECT_EQ(scene.film.height, 99);
  EXPECT_TRUE(scene.fill_unsampled);
  const TrialSettings method = settings_of(protocol, "arcade", "fv");
  EXPECT_EQ(method.film.max_depth, 7);
  EXPECT_EQ(method.timing.rating_s, 9.0);
  EXPECT_EQ(method.timing.mark_timeout_s, 60.0);
  const TrialSettings both = settings_of(protocol, "room", "fv");
  EXPECT_EQ(both.film.max_depth, 7) << "the method comes after the scene";
  EXPECT_EQ(both.film.height, 99);
  EXPECT_EQ(both.film.width, 100);
  EXPECT_TRUE(both.fill_unsampled);
}

TEST(Procedure, KeysOfEarlierVersionsAreReadWithANote) {
  const Protocol protocol = load(minimal + "[film]\nspare_done_contrast = 0.02\n");
  EXPECT_EQ(protocol.film.adaptive_contrast, 0.02);
  EXPECT_THAT(
      protocol.notes,
      ElementsAre(AllOf(HasSubstr(":6:23: "), HasSubstr("'film.spare_done_contrast' is now called "
                                                        "'film.adaptive_contrast'"))));
  EXPECT_THAT(load(minimal + "[film]\nadaptive_contrast = 0.02\n").notes, IsEmpty());
  EXPECT_THROW(load(minimal + "[film]\nadaptive_contrast = 0.02\nspare_done_contrast = 0.02\n"),
               Error);
}

// The settings of the published study (Koskela et al. 2018).
TEST(Procedure, ThePublishedStudyIsTheOneThatWasPublished) {
  const Protocol protocol = load_protocol(find_protocol("koskela2018"));
  EXPECT_EQ(protocol.scenes.size(), 5U);
  EXPECT_THAT(protocol.methods, ElementsAre("od", "vp", "fv"));
  EXPECT_EQ(protocol.scene_order, Order::random);
  EXPECT_EQ(protocol.method_order, Order::random);
  EXPECT_EQ(protocol.object_choice, ObjectChoice::per_scene);
  EXPECT_THAT(phases_of(protocol), ElementsAre("background", "trials", "debrief"));
  EXPECT_EQ(protocol.film.width, 4096);
  EXPECT_EQ(protocol.film.height, 2048);
  // The paper states no time-out; its longest mean is 137 s.
  EXPECT_GE(protocol.timing.mark_timeout_s, 900.0);
  EXPECT_EQ(protocol.display.profile->name, "fove0");
  EXPECT_EQ(protocol.tracker.profile->name, "fove0");
  EXPECT_EQ(protocol.analysis.participants, 16);
  const std::vector<Question>& background = questionnaire_of(protocol, "background").questions;
  ASSERT_EQ(background.size(), 6U);
  EXPECT_EQ(background[1].options[0].label, "female");
  EXPECT_EQ(background[1].options[0].value, 5.0);
  EXPECT_EQ(background[1].options[1].label, "male");
  EXPECT_EQ(background[1].options[1].value, 1.0);
  for (std::size_t i = 2; i < 6; ++i) {
    EXPECT_EQ(background[i].kind, QuestionKind::likert);
    EXPECT_EQ(background[i].maximum - background[i].minimum, 4.0) << "five points";
  }
}

}  // namespace
}  // namespace foveola::study
