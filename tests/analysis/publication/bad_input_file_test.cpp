// Damaged or incomplete files: each is refused in one line, and nothing is left behind, or is
// analysed as far as possible.
#include <string>

#include "analysis/publication/analyze_study.h"
#include "renderer/base/error.h"
#include "renderer/base/files/files.h"
#include "tests/matchers.h"
#include "tests/scenes/environment.h"
#include "tests/study/record/study_file.h"
#include "tests/unprivileged.h"

namespace foveola::analysis {
namespace {

namespace fs = std::filesystem;

using study::ms;

class BadInputFile : public study::StudyFile {
 protected:
  /// The single line by which the file is refused; fails if anything is left of the analysis.
  std::string refusal(const AnalysisOptions& options = {}) {
    const std::vector<std::string> before = folder_.entries();
    const std::string line = study::refusal([&] { (void)analyze_study(path_, results_, options); });
    EXPECT_THAT(line, Not(HasSubstr("\n")));
    EXPECT_EQ(folder_.entries(), before);
    return line;
  }

  /// A study whose sessions are complete, P01, P02, ...
  void write_study(int participants) {
    study::StudyStore store(path_, study::small_protocol());
    for (int i = 1; i <= participants; ++i) {
      study::PlayedSession session(store, study::facts_of("P0" + std::to_string(i)),
                                   study::small_plan());
      session.begin();
      run_trials(session, i, 4);
    }
  }

  static void run_trials(study::PlayedSession& session, int participant, int trials) {
    for (int trial = 0; trial < trials; ++trial) {
      const int outline_ms = 400 + 90 * participant + 700 * (trial % 2);
      session.run_trial(ms(1000 + 20'000 * trial), ms(outline_ms), ms(2 * outline_ms),
                        1 + (participant + trial) % 5);
    }
  }

  /// To 300 ms after the first frame, in P02's second trial.
  void change_a_mark() {
    study::tamper(path_,
                  "UPDATE event SET payload = json_object('time_ns', 300000000 + (SELECT"
                  " payload ->> 'time_ns' FROM event WHERE session = 2 AND trial = 1"
                  "  AND type = 'first_frame_presented'))"
                  " WHERE session = 2 AND trial = 1 AND type = 'marked'");
  }

  const fs::path results_ = folder_ / "results";
};

/// Whatever is flipped, the end is an analysis or a refusal.
TEST_F(BadInputFile, FlippedBytes) {
  write_study(2);
  const std::string whole = read_file(path_);
  int refused = 0;
  for (std::size_t at = 150; at < whole.size(); at += 4093) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x5a);
    write_file(path_, damaged);
    try {
      (void)tabulate_study(study::read_study(path_));
    } catch (const Error&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 0);
}

TEST_F(BadInputFile, ASessionThatIsNotOverIsLeftOutAndListed) {
  write_study(2);
  {
    study::StudyStore store(path_, study::small_protocol());
    study::PlayedSession session = study::begun_session(store, "P03");
    run_trials(session, 3, 3);
  }
  const AnalysisOutput output = analyze_study(path_, results_);
  EXPECT_EQ(output.tables.set.participants.size(), 2U);
  EXPECT_THAT(read_file(results_ / "exclusions.csv"), HasSubstr("P03,,,,session "));
  EXPECT_THAT(read_file(results_ / "report.html"), HasSubstr("<th scope=\"row\">P03</th>"));
  EXPECT_THAT(output.warnings, Contains(HasSubstr("left out")));
}

TEST_F(BadInputFile, ATimeThatWasChangedAfterwards) {
  write_study(2);
  change_a_mark();
  EXPECT_THAT(refusal(), HasSubstr("failed its verification (1 fault, the first: P02: "));
}

TEST_F(BadInputFile, ABrokenRecordIsAnalysedWhereThatIsAskedForAndTheReportSaysSo) {
  write_study(2);
  change_a_mark();
  const AnalysisOutput output = analyze_study(path_, results_, {.unverified = true});
  EXPECT_THAT(read_file(results_ / "times_by_scene.csv"), HasSubstr(",changed\r\n"));
  EXPECT_THAT(read_file(results_ / "trials_long.csv"), HasSubstr(",changed\r\n"));
  EXPECT_THAT(read_file(results_ / "geometric-means.tex"), HasSubstr("from a changed record"));
  EXPECT_THAT(output.warnings, Contains(HasSubstr("failed its verification (1 fault)")));
  const std::string report = read_file(results_ / "report.html");
  EXPECT_THAT(report, HasSubstr("⚑ The study’s file failed its verification (1 fault)"));
  EXPECT_THAT(report, HasSubstr("<li>P02: event 11 is not what was written</li>"));
}

TEST_F(BadInputFile, TheReportSaysThatAWholeRecordWasVerifiedAndWhatIsMissingInIt) {
  write_study(2);
  const AnalysisOutput output = analyze_study(path_, results_);
  ASSERT_TRUE(output.record);
  EXPECT_EQ(output.record->sessions, 2U);
  EXPECT_TRUE(output.record->faults.empty());
  const std::string report = read_file(results_ / "report.html");
  EXPECT_THAT(report, HasSubstr(" events of 2 sessions, "));
  EXPECT_THAT(report, HasSubstr("<p>It is unchanged since it was written.</p>"));
  EXPECT_THAT(report, HasSubstr("<li>P01: trial 0, attempt 1 has no frames</li>"));
}

TEST_F(BadInputFile, AFolderThatNothingMayBeWrittenInto) {
  write_study(2);
  test::open_to_all(folder_.path());
  test::open_to_all(path_);
  fs::create_directory(results_);
  write_file(results_ / "report.html", "of yesterday");
  const test::ReadOnly read_only(results_);
  // The source tree may lie where nobody can look.
  const fs::path resources = folder_ / "resources";
  fs::create_directories(resources / "protocols");
  fs::create_directory(resources / "data");
  fs::copy(resource_folder() / "data" / "koskela2018", resources / "data" / "koskela2018",
           fs::copy_options::recursive);
  const scenes::EnvironmentVariable chosen("FOVEOLA_RESOURCES", resources.string());
  const test::Unprivileged nobody;
  const std::string line = study::refusal([&] { (void)analyze_study(path_, results_); });
  EXPECT_THAT(line, HasSubstr("results: cannot be written: Permission denied"));
  EXPECT_EQ(read_file(results_ / "report.html"), "of yesterday");
}

TEST_F(BadInputFile, AResultThatCannotBeReplacedIsNamed) {
  write_study(2);
  fs::create_directories(results_ / "report.html" / "taken");
  const std::string line = study::refusal([&] { (void)analyze_study(path_, results_); });
  EXPECT_THAT(line, HasSubstr("results/report.html: cannot be written"));
  for (const fs::directory_entry& entry : fs::directory_iterator(results_)) {
    EXPECT_THAT(entry.path().filename().string(), Not(HasSubstr("unfinished")));
  }
}

}  // namespace
}  // namespace foveola::analysis
