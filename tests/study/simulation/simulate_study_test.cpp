#include "study/simulation/simulate_study.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <thread>

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/files/files.h"
#include "study/record/maintain/maintenance.h"
#include "study/simulation/prediction_agreement.h"
#include "tests/matchers.h"
#include "tests/scenes/environment.h"
#include "tests/study/record/small_study.h"
#include "tests/study/simulation/small_wall.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

class SimulateStudyTest : public testing::Test {
 protected:
  SimulateStudyTest() { folder_.write("wall.toml", wall_protocol_text(20'000, 8.0)); }

  SimulateSettings settings(const std::string& database) const {
    return {.protocol = folder_ / "wall.toml",
            .database = folder_ / database,
            .participants = 3,
            .seed = 5,
            .threads = 2,
            .scale = 4.0};
  }

  SimulateReport simulate(const SimulateSettings& settings) const {
    return simulate_study(
        settings,
        [this](const std::string&, const auto& /*folder*/) { return wall_with_a_square(folder_); },
        stop_.get_token());
  }

  /// All of a study but dates, identifiers and the hashes that they are in.
  std::vector<std::string> content(const std::string& database) const {
    std::vector<std::string> rows;
    for (const char* sql :
         {"SELECT id || participant || kind || seed || design_row || state || devices FROM session"
          " ORDER BY id",
          "SELECT session || ' ' || sequence || ' ' || time_ns || type || payload FROM event"
          " ORDER BY session, sequence",
          "SELECT session || ' ' || trial || ' ' || attempt || kind || time_ns || censored FROM"
          " mark ORDER BY session, trial, attempt, kind",
          "SELECT session || trial || attempt || value FROM rating ORDER BY session, trial",
          "SELECT session || trial || attempt || data_sha256 FROM frame_chunk ORDER BY session,"
          " trial, attempt, first_frame",
          "SELECT session || trial || attempt || data_sha256 FROM gaze_chunk ORDER BY session,"
          " trial, attempt, first_sample",
          "SELECT session || trial || attempt || film_sha256 FROM film_hash ORDER BY session,"
          " trial, attempt"}) {
      for (const std::string& row : query_column(folder_ / database, sql)) {
        rows.push_back(row);
      }
    }
    return rows;
  }

  /// One for all tests, which need the same pilots.
  static const TemporaryFolder& cache() {
    static const TemporaryFolder folder;
    return folder;
  }

  TemporaryFolder folder_;
  scenes::EnvironmentVariable cache_home_{"XDG_CACHE_HOME", cache().path().string()};
  mutable std::stop_source stop_;
};

TEST_F(SimulateStudyTest, ARenderedStudyIsTheSameOnAnyNumberOfJobs) {
  SimulateSettings two = settings("two.sqlite");
  two.jobs = 2;
  EXPECT_EQ(simulate(settings("one.sqlite")).sessions_completed, 3);
  EXPECT_EQ(simulate(two).sessions_completed, 3);
  const std::vector<std::string> one = content("one.sqlite");
  EXPECT_GT(one.size(), 60U);
  EXPECT_EQ(content("two.sqlite"), one);
}

TEST_F(SimulateStudyTest, ItsRecordSaysWhatFilteredTheGaze) {
  folder_.write("wall.toml", wall_protocol_text(20'000, 8.0) + "[tracker.filter]\nhold_s = 0.3\n");
  SimulateSettings one = settings("one.sqlite");
  one.participants = 1;
  simulate(one);
  EXPECT_EQ(query(folder_ / "one.sqlite", "SELECT devices -> '$.tracker' FROM session"),
            R"({"filter":{"hold_s":0.3}})");
  SimulateSettings predicted = one;
  predicted.database = folder_ / "predicted.sqlite";
  predicted.predicted = true;
  simulate(predicted);
  EXPECT_EQ(
      query(folder_ / "predicted.sqlite", "SELECT devices -> '$.tracker' IS NULL FROM session"),
      "1");
}

TEST_F(SimulateStudyTest, APredictedStudyIsTheSameOnAnyNumberOfJobs) {
  SimulateSettings one = settings("one.sqlite");
  one.predicted = true;
  one.participants = 12;
  SimulateSettings three = one;
  three.database = folder_ / "three.sqlite";
  three.jobs = 3;
  EXPECT_EQ(simulate(one).sessions_completed, 12);
  EXPECT_EQ(simulate(three).sessions_completed, 12);
  EXPECT_EQ(content("three.sqlite"), content("one.sqlite"));
  EXPECT_EQ(query(folder_ / "one.sqlite", "SELECT count(*) FROM frame_chunk"), "0");
}

class SimulatedShards : public SimulateStudyTest, public testing::WithParamInterface<bool> {
 protected:
  SimulateSettings settings_of(const std::string& database) const {
    SimulateSettings some = settings(database);
    some.predicted = GetParam();
    some.participants = 5;
    return some;
  }

  SimulateSettings shard(std::int64_t number, std::int64_t count) const {
    SimulateSettings some = settings_of(fmt::format("{}-of-{}.sqlite", number, count));
    some.shard = {.number = number, .count = count};
    return some;
  }

  /// The bytes of one study made of those files.
  std::string merged(const std::vector<std::string>& databases,
                     MissingParts missing = MissingParts::refuse) const {
    std::vector<fs::path> sources;
    for (const std::string& database : databases) {
      sources.push_back(folder_ / database);
    }
    const fs::path all = folder_ / "merged.sqlite";
    fs::remove(all);
    merge_studies(sources, all, {.missing = missing});
    return read_file(all);
  }
};

TEST_P(SimulatedShards, MergedAreTheWholeStudyByteForByte) {
  simulate(settings_of("whole.sqlite"));
  for (const auto& [number, count] :
       std::vector<std::pair<int, int>>{{1, 2}, {2, 2}, {1, 3}, {2, 3}, {3, 3}}) {
    simulate(shard(number, count));
  }
  const std::string whole = merged({"whole.sqlite"});
  EXPECT_EQ(merged({"1-of-2.sqlite", "2-of-2.sqlite"}), whole);
  EXPECT_EQ(merged({"2-of-3.sqlite", "3-of-3.sqlite", "1-of-3.sqlite"}), whole);
  EXPECT_EQ(merged({"2-of-3.sqlite", "1-of-2.sqlite", "3-of-3.sqlite"}), whole)
      << "one of them is in two files";
  EXPECT_THAT([&] { merged({"1-of-3.sqlite", "3-of-3.sqlite"}); },
              ThrowsMessage<Error>(HasSubstr("would lack 2 of 5 simulated participants")));
  EXPECT_EQ(merged({"1-of-3.sqlite", "2-of-3.sqlite", "3-of-3.sqlite"}), whole);
  EXPECT_EQ(content("merged.sqlite"), content("whole.sqlite"));
  const char* const hashes = "SELECT hash FROM event ORDER BY session, sequence";
  EXPECT_EQ(query_column(folder_ / "merged.sqlite", hashes),
            query_column(folder_ / "whole.sqlite", hashes))
      << "of dates and identifiers, too";
}

TEST_P(SimulatedShards, StoppedAndRunAgainAreTheSameFile) {
  simulate(shard(2, 2));
  const std::string once = merged({"2-of-2.sqlite"}, MissingParts::note);
  fs::remove(folder_ / "2-of-2.sqlite");
  SimulateSettings some = shard(2, 2);
  some.participants = 4;  // of which the shard has the last two
  some.shard = {.number = 3, .count = 4};
  simulate(some);  // the third
  some.participants = 5;
  some.shard = {.number = 2, .count = 2};
  EXPECT_THAT([&] { simulate(some); },
              ThrowsMessage<Error>(HasSubstr("a shard needs a file of its own")));
  some.resume = true;
  simulate(some);
  EXPECT_EQ(merged({"2-of-2.sqlite"}, MissingParts::note), once);
}

INSTANTIATE_TEST_SUITE_P(Rendered, SimulatedShards, testing::Values(false));
INSTANTIATE_TEST_SUITE_P(Predicted, SimulatedShards, testing::Values(true));

TEST_F(SimulateStudyTest, WhatWasMissingIsAddedAsIfNothingHadBeen) {
  SimulateSettings whole = settings("whole.sqlite");
  whole.predicted = true;
  simulate(whole);
  SimulateSettings first = whole;
  first.database = folder_ / "parts.sqlite";
  first.participants = 1;
  simulate(first);
  SimulateSettings rest = first;
  rest.participants = 3;
  rest.resume = true;
  rest.jobs = 2;
  const SimulateReport report = simulate(rest);
  EXPECT_EQ(report.sessions_before, 1);
  EXPECT_EQ(report.sessions_completed, 2);
  EXPECT_EQ(content("parts.sqlite"), content("whole.sqlite"));
}

TEST_F(SimulateStudyTest, AStopLeavesWholeSessions) {
  SimulateSettings stopped = settings("stopped.sqlite");
  stopped.jobs = 2;
  simulate(settings("whole.sqlite"));  // and the reference, which a stop would keep from being made
  std::jthread stopping([this] {
    while (!fs::exists(folder_ / "stopped.sqlite")) {
      std::this_thread::yield();
    }
    stop_.request_stop();
  });
  simulate(stopped);
  stopping.join();
  EXPECT_EQ(
      query(folder_ / "stopped.sqlite", "SELECT count(*) FROM session WHERE state <> 'completed'"),
      "0");
  stop_ = std::stop_source();
  stopped.resume = true;
  simulate(stopped);
  EXPECT_EQ(content("stopped.sqlite"), content("whole.sqlite"));
}

TEST_F(SimulateStudyTest, OnASlowerMachineAllWaitLonger) {
  SimulateSettings usual = settings("usual.sqlite");
  usual.predicted = true;
  simulate(usual);
  SimulateSettings slow = usual;
  slow.database = folder_ / "slow.sqlite";
  slow.samples_per_second = 10'000.0;  // half of the protocol's
  simulate(slow);
  const auto mean_time = [&](const std::string& database) {
    return std::stod(query(folder_ / database, "SELECT avg(time_ns) FROM mark"));
  };
  EXPECT_GT(mean_time("slow.sqlite"), 1.3 * mean_time("usual.sqlite"));
  EXPECT_THAT(query(folder_ / "slow.sqlite", "SELECT devices FROM session LIMIT 1"),
              HasSubstr(R"("samples_per_second":10000.0)"));
}

TEST_F(SimulateStudyTest, WhatWasSimulatedInAnotherWayIsNotMixedIn) {
  SimulateSettings predicted = settings("study.sqlite");
  predicted.predicted = true;
  predicted.participants = 1;
  simulate(predicted);
  const auto refused = [&](const std::string& says, const auto& change) {
    SimulateSettings other = predicted;
    change(other);
    EXPECT_THAT([&] { simulate(other); }, testing::ThrowsMessage<Error>(HasSubstr(says)));
  };
  refused("simulation/scale: 4", [](SimulateSettings& other) { other.scale = 1.0; });
  refused("simulation/predicted: true", [](SimulateSettings& other) { other.predicted = false; });
  refused("simulation/injected", [](SimulateSettings& other) { other.injected = "order:1.2"; });
  EXPECT_EQ(query(folder_ / "study.sqlite", "SELECT count(*) FROM session"), "1");
}

TEST_F(SimulateStudyTest, DrawnTimesComeWithoutPilotsAndWithoutPictures) {
  const scenes::EnvironmentVariable empty_cache("XDG_CACHE_HOME", (folder_ / "cache").string());
  SimulateSettings injected = settings("injected.sqlite");
  injected.predicted = true;
  injected.injected = "faster:fv:3,tracker-loss:0.2";
  injected.participants = 40;
  EXPECT_EQ(simulate(injected).sessions_completed, 40);
  EXPECT_FALSE(fs::exists(folder_ / "cache/foveola/pilots"));
  const std::string logs = query(
      folder_ / "injected.sqlite",
      "SELECT avg(ln(o.time_ns) - ln(f.time_ns)) FROM mark AS o JOIN planned_trial AS po USING"
      " (session, trial) JOIN mark AS f ON f.session = o.session AND f.kind = o.kind JOIN"
      " planned_trial AS pf ON pf.session = f.session AND pf.trial = f.trial WHERE"
      " po.method = 'od' AND pf.method = 'fv' AND o.censored + f.censored = 0");
  // Of one trial's logarithm of time the deviation is 0.25 in each of two methods.
  EXPECT_NEAR(std::stod(logs), std::log(3.0), 4.0 * 0.25 * std::sqrt(2.0 / 40.0));
}

// Eight seeds gave ratios of 0.97 to 1.00 for all methods, of 0.93 to 1.00 for od alone, whose
// times are far above the reaction time, and correlations of 0.90 to 1.00.
TEST_F(SimulateStudyTest, PredictedTimesAreThoseOfRenderedSessions) {
  SimulateSettings rendered = settings("rendered.sqlite");
  rendered.scale = 1.0;
  rendered.participants = 6;
  SimulateSettings predicted = rendered;
  predicted.database = folder_ / "predicted.sqlite";
  predicted.predicted = true;
  simulate(rendered);
  simulate(predicted);
  for (const MarkAgreement& agreement :
       prediction_agreement(read_study(rendered.database), read_study(predicted.database))) {
    EXPECT_EQ(agreement.trials, agreement.method.empty() ? 12 : 6) << agreement.mark;
    EXPECT_NEAR(agreement.median_ratio, 1.0, 0.15) << agreement.mark << " " << agreement.method;
    if (agreement.method.empty()) {
      EXPECT_GT(agreement.rank_correlation, 0.8) << agreement.mark;
    }
  }
}

TEST_F(SimulateStudyTest, RefusesNumbersThatMakeNoSense) {
  const std::vector<std::function<void(SimulateSettings&)>> mistakes = {
      [](SimulateSettings& some) { some.participants = 0; },
      [](SimulateSettings& some) { some.jobs = 0; },
      [](SimulateSettings& some) { some.samples_per_second = 0.0; },
      [](SimulateSettings& some) { some.shard = {.number = 1, .count = 4}; },
      [](SimulateSettings& some) { some.injected = "faster:vp:2"; }};
  const std::vector<std::function<void(SimulateSettings&)>> not_in_real_time = {
      [](SimulateSettings& some) { some.predicted = true; },
      [](SimulateSettings& some) { some.jobs = 2; },
      [](SimulateSettings& some) { some.samples_per_second = 1e4; },
      [](SimulateSettings& some) { some.shard = {.number = 1, .count = 2}; }};
  const auto refused = [this](const auto& mistake, bool real_time) {
    SimulateSettings some = settings("study.sqlite");
    some.real_time = real_time;
    mistake(some);
    EXPECT_THROW(simulate(some), UsageError);
  };
  for (const auto& mistake : mistakes) {
    SCOPED_TRACE(&mistake - mistakes.data());
    refused(mistake, false);
  }
  for (const auto& mistake : not_in_real_time) {
    SCOPED_TRACE(&mistake - not_in_real_time.data());
    refused(mistake, true);
  }
  EXPECT_FALSE(fs::exists(folder_ / "study.sqlite"));
}

}  // namespace
}  // namespace foveola::study
