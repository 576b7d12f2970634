// That no page reveals which method a trial has.
#include <cctype>
#include <set>

#include "renderer/window/screens/screen_layout.h"
#include "study/person/forms/typed_answer.h"
#include "study/person/prompts/pages.h"
#include "tests/matchers.h"
#include "tests/study/person/prompts/prompt_session.h"

namespace foveola::study {
namespace {

using namespace std::chrono_literals;
using test::PromptSession;

/// The published study's words, with all parts that a session can have.
Protocol published_protocol() {
  Protocol protocol = load_protocol(find_protocol("koskela2018"));
  protocol.texts["consent"] = "You will look at pictures.";
  protocol.reaction = ReactionSettings{};
  protocol.tracker.validation = ValidationSettings{};
  return protocol;
}

/// In practice, in the first trial and in another scene; each waits for what `phase` does.
PromptSession session_with(const std::string& method, Phase phase, std::size_t step) {
  PromptSession session{.protocol = published_protocol(),
                        .plan = {{.scene = "hall", .method = method, .kind = TrialKind::practice},
                                 {.scene = "hall", .method = method},
                                 {.scene = "yard", .method = method}},
                        .procedure = {.agenda = {TrialStep{.trial = 0}, TrialStep{.trial = 1},
                                                 TrialStep{.trial = 2, .chooses_object = false}}}};
  session.seen = {.phase = phase, .step = step, .object = "Lamp", .resumes_at = Phase::ready};
  return session;
}

/// What leads to a phase.
std::optional<Effect> effect_before(Phase phase) {
  switch (phase) {
    case Phase::consent:
      return AskForConsent{};
    case Phase::reaction:
      return AskForPress{};
    case Phase::choosing_object:
      return AskForObject{};
    case Phase::ready:
      return AskWhetherReady{};
    case Phase::marking:
      return AcknowledgeMark{};
    case Phase::rating:
      return AskForRating{};
    default:
      return std::nullopt;
  }
}

/// The lines of pages as they are laid out on a monitor.
class Reader {
 public:
  /// Of the page that is seen now.
  void read(const PromptSession& session, Nanoseconds now = 0s) {
    if (const std::optional<ScreenPage> page = page_of(session.prompt, session.context(), now)) {
      for (const PlacedText& text : lay_out(*page, place_, width_).texts) {
        lines_.push_back(text.line);
      }
    }
  }

  /// Of a form, page by page, as it is filled in.
  void read_form(PromptSession& session) {
    while (!session.prompt.form->is_submitted()) {
      read(session);
      Form& form = *session.prompt.form;
      if (const Question* question = form.question()) {
        for (const FormInput& input : typed_answer(*question, {answer_to(*question)})) {
          form.follow(input);
        }
      }
      ASSERT_TRUE(form.follow(FormKey::enter));
    }
  }

  const std::vector<std::string>& lines() const { return lines_; }

 private:
  static Answer answer_to(const Question& question) {
    Answer answer{.question = question.id, .value = question.minimum};
    if (question.kind == QuestionKind::text) {
      answer.value = "nothing";
    } else if (question.kind == QuestionKind::choice) {
      const Option& option = question.options.front();
      answer.value = option.value ? std::variant<double, std::string>(*option.value) : option.label;
    }
    return answer;
  }

  ScreenPlace place_ = screen_place({.size = {1920, 1080}}, 1080, std::nullopt);
  TextWidth width_ = [](TextFace, std::string_view line) {
    return 12.0F * static_cast<float>(line.size());
  };
  std::vector<std::string> lines_;
};

void read_phase(Reader& reader, PromptSession session) {
  if (const std::optional<Effect> effect = effect_before(session.seen.phase)) {
    session.prepare(*effect);
  }
  for (; !session.prompt.notices.empty(); session.prompt.notices.pop_front()) {
    reader.read(session);
  }
  if (session.prompt.form) {
    reader.read_form(session);
    return;
  }
  if (session.seen.phase == Phase::questionnaire) {
    for (const Questionnaire& questionnaire : session.protocol.questionnaires) {
      session.prepare(AskQuestionnaire{questionnaire.id});
      reader.read_form(session);
    }
    return;
  }
  reader.read(session);
  if (session.seen.phase == Phase::rating) {
    session.prompt.wants_to_rate = true;
    reader.read(session, 3s);  // the mark is no longer acknowledged
    ASSERT_TRUE(begin_rating(session.prompt, session.protocol, 60s));
    reader.read_form(session);
  }
}

/// All that a participant reads in sessions whose trials have this method.
std::vector<std::string> lines_with(const std::string& method) {
  Reader reader;
  for (int phase = 0; phase <= static_cast<int>(Phase::refused); ++phase) {
    for (const std::size_t step : {0U, 1U, 2U}) {
      PromptSession session = session_with(method, static_cast<Phase>(phase), step);
      read_phase(reader, session);
      for (const Confirmed what : {Confirmed::timing_again, Confirmed::stopping}) {
        session.prompt.confirmation.emplace(what, session.protocol.texts);
        reader.read(session);
      }
    }
  }
  return reader.lines();
}

/// In small letters.
std::set<std::string> words_of(const std::vector<std::string>& lines) {
  std::set<std::string> words;
  for (const std::string& line : lines) {
    std::string word;
    for (const char character : line + " ") {
      if (std::isalnum(static_cast<unsigned char>(character)) != 0) {
        word += static_cast<char>(std::tolower(static_cast<unsigned char>(character)));
      } else if (!word.empty()) {
        words.insert(std::exchange(word, {}));
      }
    }
  }
  return words;
}

TEST(Blindness, NoPageTellsTheMethod) {
  const std::vector<std::string> with_od = lines_with("od");
  EXPECT_THAT(with_od, Contains("How old are you?"));
  EXPECT_EQ(lines_with("fv"), with_od);
  const std::set<std::string> words = words_of(with_od);
  for (const std::string& method : published_protocol().methods) {
    EXPECT_THAT(words, Not(Contains(method)));
  }
}

}  // namespace
}  // namespace foveola::study
