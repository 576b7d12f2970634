#include "study/simulation/prepare_study.h"

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/files/files.h"
#include "study/record/maintain/maintenance.h"
#include "tests/matchers.h"
#include "tests/scenes/environment.h"
#include "tests/study/record/small_study.h"
#include "tests/study/simulation/small_wall.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

/// Every file below a folder, with its content and when it was written.
using Files = std::map<std::string, std::pair<std::string, fs::file_time_type>>;

Files files_below(const fs::path& folder) {
  Files files;
  if (fs::exists(folder)) {
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      if (entry.is_regular_file()) {
        files[fs::relative(entry.path(), folder)] = {read_file(entry.path()),
                                                     entry.last_write_time()};
      }
    }
  }
  return files;
}

std::map<std::string, std::string> contents(const Files& files) {
  std::map<std::string, std::string> contents;
  for (const auto& [name, file] : files) {
    contents[name] = file.first;
  }
  return contents;
}

/// Of walls with two objects, in two scenes, whose samples fall alike whatever is looked at.
class PrepareStudy : public testing::TestWithParam<bool> {
 protected:
  PrepareStudy() {
    std::string protocol = wall_protocol_text(20'000, 8.0);
    const std::string scenes = "[\"wall\"]";
    protocol.replace(protocol.find(scenes), scenes.size(), "[\"wall\", \"other\"]");
    folder_.write("wall.toml", protocol);
  }

  SimulateSettings settings() const {
    return {.protocol = folder_ / "wall.toml",
            .database = {},
            .participants = 4,
            .seed = 5,
            .threads = 2,
            .scale = 4.0,
            .predicted = GetParam()};
  }

  SceneFinderBeside find_scene() const {
    return [this](const std::string& name, const auto& /*folder*/) {
      SceneSource wall = wall_with_a_square(folder_);
      wall.name = name;
      wall.objects.push_back(
          {.name = "corner", .position = {1.5F, 0.8F, -2.0F}, .radius_deg = 10.0F});
      if (name == "other") {
        wall.environment_radiance = Rgb(0.4F);
      }
      return wall;
    };
  }

  PrepareReport prepare(const SimulateSettings& settings) const {
    return prepare_study(settings, find_scene(), {});
  }

  PrepareReport prepare(std::int64_t number, std::int64_t count) const {
    SimulateSettings of_shard = settings();
    of_shard.shard = {.number = number, .count = count};
    return prepare(of_shard);
  }

  /// The bytes of the study.
  std::string simulate(const std::string& database) const {
    SimulateSettings all = settings();
    all.database = folder_ / (database + ".sqlite");
    EXPECT_EQ(simulate_study(all, find_scene(), {}).sessions_completed, 4);
    const fs::path merged = folder_ / (database + "-merged.sqlite");
    merge_studies({all.database}, merged);
    return read_file(merged);
  }

  /// The caches of a machine.
  class Machine {
   public:
    Files files() const { return files_below(folder_.path()); }

   private:
    TemporaryFolder folder_;
    scenes::EnvironmentVariable home_{"XDG_CACHE_HOME", folder_.path().string()};
  };

  TemporaryFolder folder_;
};

TEST_P(PrepareStudy, WhatIsPreparedIsNotRenderedAgain) {
  std::string unprepared;
  Files rendered;
  {
    const Machine machine;
    unprepared = simulate("unprepared");
    rendered = machine.files();
  }
  const Machine machine;
  const PrepareReport report = prepare(settings());
  EXPECT_EQ(report.items, GetParam() ? 2 + 3 : 2)
      << "two surrounds and the three objects that anybody looks at, or two references";
  EXPECT_EQ(report.rendered, report.items);
  const Files prepared = machine.files();
  EXPECT_EQ(contents(prepared), contents(rendered));
  EXPECT_EQ(prepare(settings()).rendered, 0);
  EXPECT_EQ(simulate("prepared"), unprepared);
  EXPECT_EQ(machine.files(), prepared) << "nothing new, nothing written again";
}

TEST_P(PrepareStudy, ShardsPrepareItByThemselves) {
  std::map<std::string, std::string> whole;
  {
    const Machine machine;
    prepare(settings());
    whole = contents(machine.files());
  }
  for (const std::int64_t count : {2, 5, 7}) {
    std::map<std::string, std::string> together;
    std::size_t files = 0;
    for (std::int64_t number = 1; number <= count; ++number) {
      const Machine machine;
      const PrepareReport report = prepare(number, count);
      EXPECT_EQ(report.rendered, report.items);
      const std::map<std::string, std::string> own = contents(machine.files());
      files += own.size();
      together.insert(own.begin(), own.end());
    }
    EXPECT_EQ(together, whole) << count;
    EXPECT_EQ(files, whole.size()) << "none was made twice by " << count;
  }
}

TEST_P(PrepareStudy, DamagedFilesAreMadeAgain) {
  const Machine machine;
  prepare(settings());
  const Files whole = machine.files();
  const fs::path caches = cache_folder().parent_path();
  const std::string damaged = whole.begin()->first;
  write_file(caches / damaged, whole.begin()->second.first.substr(0, 100));
  EXPECT_EQ(prepare(settings()).rendered, 1);
  EXPECT_EQ(contents(machine.files()), contents(whole));
}

TEST_P(PrepareStudy, NothingIsPreparedForPeopleWhoDoNotLook) {
  const Machine machine;
  SimulateSettings injected = settings();
  injected.injected = "faster:fv:3";
  const PrepareReport report = prepare(injected);
  EXPECT_FALSE(report.simulates_viewing);
  EXPECT_EQ(report.items, 0);
  EXPECT_TRUE(machine.files().empty());
}

TEST_P(PrepareStudy, WhatIsStoppedIsNoFault) {
  const Machine machine;
  std::stop_source stop;
  stop.request_stop();
  EXPECT_TRUE(prepare_study(settings(), find_scene(), stop.get_token()).stopped);
  SimulateSettings nobody = settings();
  nobody.participants = 0;
  EXPECT_THAT([&] { prepare(nobody); }, ThrowsMessage<UsageError>(HasSubstr("--participants")));
}

INSTANTIATE_TEST_SUITE_P(Rendered, PrepareStudy, testing::Values(false));
INSTANTIATE_TEST_SUITE_P(Predicted, PrepareStudy, testing::Values(true));

}  // namespace
}  // namespace foveola::study
