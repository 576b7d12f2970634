// A study's file names every program that recorded a session of it.
#include "study/record/setup/session_programs.h"

#include <fmt/format.h>

#include "renderer/base/build_info.h"
#include "study/record/read/study_records.h"
#include "study/record/setup/session_devices.h"
#include "tests/study/record/study_file.h"

namespace foveola::study {
namespace {

constexpr const char* former = "Foveola 0.0.9 (GNU 12.2.0, Release, Embree 3.13.5)";
constexpr const char* later = "Foveola 0.1.0 (GNU 14.2.0, Release, Embree 4.3.3)";

TEST(ProgramNote, NamesBoth) {
  const std::string note = note_of_program(later, former);
  EXPECT_EQ(note,
            "goes on with Foveola 0.1.0 (GNU 14.2.0, Release, Embree 4.3.3) instead of Foveola "
            "0.0.9 (GNU 12.2.0, Release, Embree 3.13.5)");
  EXPECT_EQ(program_in_note(note), later);
}

TEST(ProgramNote, AnotherNoteIsNone) {
  for (const std::string& note :
       {std::string("the phone rang"), std::string("goes on with a lens instead of glasses"),
        std::string("goes on with ") + later, std::string("P1 goes on with Foveola instead of "),
        note_of_devices(R"({"tracker":{"profile":"camera"}})"), std::string()}) {
    EXPECT_FALSE(program_in_note(note)) << note;
  }
}

TEST(ProgramUses, NameASessionOnceThatWentBackToAProgram) {
  EXPECT_THAT(
      program_uses({{.participant = "P01", .programs = {former, later, former}}}),
      ElementsAre(FieldsAre(former, ElementsAre("P01")), FieldsAre(later, ElementsAre("P01"))));
}

/// P01's session is by the former program, P02's by the later one, and P03's by both.
class ProgramsOfAStudy : public StudyFile {
 protected:
  ProgramsOfAStudy() {
    StudyStore store(path_, small_protocol());
    begin(store, "P01", built_formerly());
    begin(store, "P02", built_later());
    PlayedSession third(store, facts_by("P03", built_formerly()), small_plan());
    third.begin();
    third.happen(ms(20), Interrupted{});
    third.happen(ms(20), NoteWritten{.text = note_of_program(later, former)});
    third.happen(ms(20), Resumed{});
  }

  static BuildInfo built_formerly() {
    return {.version = "0.0.9",
            .compiler = "GNU 12.2.0",
            .build_type = "Release",
            .ray_tracer = "Embree 3.13.5",
            .instruction_set = "x86-64-v3"};
  }
  static BuildInfo built_later() {
    return {.version = "0.1.0",
            .compiler = "GNU 14.2.0",
            .build_type = "Release",
            .ray_tracer = "Embree 4.3.3",
            .instruction_set = "x86-64-v4"};
  }
  static SessionFacts facts_by(const std::string& participant, const BuildInfo& build) {
    SessionFacts facts = facts_of(participant);
    facts.build = build;
    facts.devices = R"({"keys":{"time_source":"X server"}})";
    return facts;
  }
  static void begin(StudyStore& store, const std::string& participant, const BuildInfo& build) {
    PlayedSession(store, facts_by(participant, build), small_plan()).begin();
  }
};

TEST_F(ProgramsOfAStudy, StandInTheRecord) {
  const StudyRecords records = read_study(path_);
  EXPECT_THAT(records.programs, ElementsAre(FieldsAre("P01", ElementsAre(former)),
                                            FieldsAre("P02", ElementsAre(later)),
                                            FieldsAre("P03", ElementsAre(former, later))));
  EXPECT_THAT(program_uses(records.programs),
              ElementsAre(FieldsAre(former, ElementsAre("P01", "P03")),
                          FieldsAre(later, ElementsAre("P02", "P03"))));
  EXPECT_EQ(query(path_, "SELECT devices FROM session WHERE participant = 'P02'"),
            R"({"keys":{"time_source":"X server"},"renderer":)"
            R"({"ray_tracer":"Embree 4.3.3","instruction_set":"x86-64-v4"}})");
}

TEST_F(ProgramsOfAStudy, AreKnownToWhoeverGoesOn) {
  const StudyStore store(path_, small_protocol());
  const KnownSession third = store.sessions().at(2);
  EXPECT_EQ(program_name(third.build), former);
  EXPECT_THAT(programs_of(third, store.events_of(third.id)), ElementsAre(former, later));
}

TEST_F(ProgramsOfAStudy, AreWarnedOfAndNoFault) {
  const Verification found = verify_study(path_);
  EXPECT_THAT(found.faults, IsEmpty());
  EXPECT_THAT(
      found.warnings,
      ElementsAre(FieldsAre("P03", fmt::format("the session is by {}, then {}", former, later)),
                  FieldsAre("", fmt::format("was recorded by several programs, between which times "
                                            "may differ: {} in 2 sessions; {} in 2 sessions",
                                            former, later))));
}

TEST_F(ProgramsOfAStudy, AreMergedAsTheyAre) {
  const fs::path other = folder_ / "other.sqlite";
  {
    StudyStore store(other, small_protocol());
    begin(store, "P11", built_later());
  }
  EXPECT_THAT(verify_study(other).warnings, IsEmpty()) << "one program";
  const fs::path all = folder_ / "all.sqlite";
  EXPECT_EQ(merge_studies({path_, other}, all).sessions_added, 4U);
  EXPECT_THAT(program_uses(read_study(all).programs),
              ElementsAre(FieldsAre(former, ElementsAre("P01", "P03")),
                          FieldsAre(later, ElementsAre("P02", "P03", "P11"))));
}

TEST_F(ProgramsOfAStudy, MayHaveKeptNoRayTracer) {
  StudyStore store(folder_ / "old.sqlite", small_protocol());
  begin(store, "P01", {.version = "0.0.8", .compiler = "GNU 12.2.0", .build_type = "Release"});
  EXPECT_EQ(program_name(store.sessions().at(0).build), "Foveola 0.0.8 (GNU 12.2.0, Release)");
}

}  // namespace
}  // namespace foveola::study
