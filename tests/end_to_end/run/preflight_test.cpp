// What is measured before a session: said, recorded, and refused where the protocol asks for more.
#include "tests/end_to_end/run/study_run.h"
#include "tests/matchers.h"

namespace foveola::test {
namespace {

TEST_F(StudyRun, AMachineThatIsTooSlowBeginsNothing) {
  participant_.write_protocol(
      one_trial_keys, std::string("[preflight]\nmin_samples_per_second = 1e12\n") + short_look);
  const ProgramResult result = participant_.run_besides("P1", {"--window", "320x240"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.output, HasSubstr("REFUSED"));
  EXPECT_THAT(result.errors, HasSubstr("preflight: fails the protocol's limits, so no session was "
                                       "begun: samples a second;"));
  EXPECT_THAT(participant_.ask("SELECT id FROM session"), IsEmpty());
}

TEST_F(StudyRun, PreflightsFiguresAreInTheRecord) {
  participant_.write_protocol(one_trial_keys, short_look);
  participant_.begin();
  EXPECT_THAT(participant_.program().said(),
              AllOf(Not(HasSubstr("HEADSET")), HasSubstr("128 x 64 pixels of 2.8 degrees")));
  participant_.quit();
  EXPECT_THAT(participant_.ask("SELECT devices ->> '$.preflight.speeds[0].scene',"
                               " devices ->> '$.preflight.speeds[0].frames' > 0,"
                               " devices ->> '$.preflight.speeds[0].samples_per_second' > 1,"
                               " devices ->> '$.preflight.free_bytes' > 1,"
                               " devices ->> '$.preflight.film_px',"
                               " json_array_length(devices, '$.preflight.checks') FROM session"),
              ElementsAre("hall|1|1|1|[128,64]|12"));
}

}  // namespace
}  // namespace foveola::test
