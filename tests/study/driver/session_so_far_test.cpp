// Whose session may be gone on with, and by which program.
#include "study/driver/session_so_far.h"

#include <fmt/format.h>

#include "renderer/base/build_info.h"
#include "study/record/setup/session_programs.h"
#include "tests/study/record/study_file.h"

namespace foveola::study {
namespace {

class SessionOfAPerson : public StudyFile {
 protected:
  /// P1's session by the program of `build`, which ended in it.
  void begin_by(const BuildInfo& build) {
    SessionFacts facts = facts_of("P1");
    facts.kind = SessionKind::human;
    facts.build = build;
    PlayedSession session(store_, facts, small_plan());
    session.begin();
    session.happen(ms(20), Interrupted{});
  }

  static BuildInfo former_version() {
    BuildInfo build = build_info();
    build.version = "0.0.9";
    return build;
  }

  /// The session's log says that it went on with this program.
  void go_on_by(const std::string& now, const std::string& before) {
    const KnownSession known = store_.sessions().front();
    const SessionState state = so_far_of(store_, small_protocol(), known).position.state;
    store_.record(known.id, EventEntry{.time = ms(30),
                                       .event = NoteWritten{.text = note_of_program(now, before)},
                                       .before = state,
                                       .after = state});
  }

  std::optional<SessionSoFar> so_far(bool accept_changes = false) const {
    return session_so_far(store_, small_protocol(), "P1",
                          {.resumes = true, .accept_changes = accept_changes});
  }

  StudyStore store_{path_, small_protocol()};
};

TEST_F(SessionOfAPerson, GoesOnByTheProgramThatBeganIt) {
  begin_by(build_info());
  const std::optional<SessionSoFar> found = so_far();
  ASSERT_TRUE(found);
  EXPECT_EQ(found->program, program_name(build_info()));
  EXPECT_EQ(found->position.state.phase, Phase::interrupted);
}

TEST_F(SessionOfAPerson, ByAFormerVersionGoesOnOnlyWhereThatIsSaid) {
  begin_by(former_version());
  EXPECT_THAT(refusal([&] { so_far(); }),
              AllOf(HasSubstr(program_name(former_version())),
                    HasSubstr(program_name(build_info())), HasSubstr("--despite-changes")));
  EXPECT_EQ(so_far(true).value().program, program_name(former_version()));
}

TEST_F(SessionOfAPerson, ByTheSameVersionBuiltWithOtherToolsIsRefused) {
  for (std::string BuildInfo::* const tool :
       {&BuildInfo::compiler, &BuildInfo::build_type, &BuildInfo::ray_tracer}) {
    SessionFacts facts = facts_of(fmt::format("P{}", 10 + store_.sessions().size()));
    facts.kind = SessionKind::human;
    facts.build = build_info();
    facts.build.*tool = "Another 99.1.0";
    PlayedSession(store_, facts, small_plan()).begin();
    EXPECT_THAT(refusal([&] {
                  session_so_far(store_, small_protocol(), facts.participant, {.resumes = true});
                }),
                HasSubstr("has a session of " + program_name(facts.build)));
  }
}

// Its simulated gaze would be taken for a person's.
TEST_F(SessionOfAPerson, DoesNotGoOnAsARehearsal) {
  begin_by(build_info());
  const auto as_rehearsal = [&] {
    session_so_far(store_, small_protocol(), "P1",
                   {.kind = SessionKind::pilot, .resumes = true, .accept_changes = true});
  };
  EXPECT_THAT(refusal(as_rehearsal), HasSubstr("has a session that counts"));
}

// Once it was said that another program may go on, that one is the session's.
TEST_F(SessionOfAPerson, GoesOnByTheProgramThatRecordedItLast) {
  const std::string now = program_name(build_info());
  begin_by(former_version());
  go_on_by(now, program_name(former_version()));
  EXPECT_EQ(so_far(true)->program, now);
}

TEST_F(SessionOfAPerson, BeginsInAStudyOfAFormerVersionWhereThatIsSaid) {
  begin_by(former_version());
  const auto begin = [&](bool accept_changes) {
    return session_so_far(store_, small_protocol(), "P2", {.accept_changes = accept_changes});
  };
  EXPECT_THAT(refusal([&] { begin(false); }),
              HasSubstr("has sessions by Foveola 0.0.9, and this is " + build_info().version));
  EXPECT_FALSE(begin(true));
}

TEST_F(SessionOfAPerson, DoesNotGoBackToAFormerProgramUnsaid) {
  begin_by(build_info());
  go_on_by(program_name(former_version()), program_name(build_info()));
  EXPECT_THAT(refusal([&] { so_far(); }),
              HasSubstr("has a session of " + program_name(former_version())));
}

}  // namespace
}  // namespace foveola::study
