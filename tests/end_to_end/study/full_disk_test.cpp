// A full disk: the error names what could not be written, and nothing is left half-written.
#include <filesystem>
#include <string>
#include <vector>

#include "renderer/base/files/files.h"
#include "tests/end_to_end/small_disk.h"
#include "tests/end_to_end/study/study_of_a_hall.h"
#include "tests/matchers.h"

namespace foveola::test {
namespace {

using FullDisk = StudyOfAHall;

TEST_F(FullDisk, IsThatOfTheFileThatIsWritten) {
  if (const std::string refusal = refusal_of_own_mounts(); !refusal.empty()) {
    GTEST_SKIP() << refusal;
  }
  const auto source = [&](const std::string& name) { return (folder / name).string(); };
  write_file(folder / "room.gltf", room_gltf());
  copy_published_numbers();
  succeeded(simulate("study.sqlite"));
  const SmallDisk disk(folder / "disk");
  const auto target = [&](const std::string& name) { return (disk.folder() / name).string(); };
  std::filesystem::create_directory_symlink(disk.folder(), folder / "study.sqlite.backups");
  disk.fill();
  struct Case {
    std::vector<std::string> command;
    std::string named;  ///< what the error begins with
  };
  for (const auto& [command, named] : std::vector<Case>{
           {{"analyze", source("study.sqlite"), "-o", target("out")}, target("out/.unfinished-")},
           {{"render", source("room.gltf"), "-o", target("x.exr"), "--size", "64x64", "--spp", "1"},
            target("x.exr")},
           {{"render", source("room.gltf"), "-o", target("x.png"), "--size", "64x64", "--spp", "1"},
            target("x.png")},
           {{"render", source("room.gltf"), "-o", target("x.film"), "--size", "64x64", "--spp", "1",
             "--shard", "1/2"},
            target("x.film")},
           {{"study", "backup", source("study.sqlite")}, source("study.sqlite.backups/")},
           {{"study", "gaze", source("study.sqlite"), "--participant", "P001", "--trial", "0", "-o",
             target("gaze.csv")},
            target("gaze.csv")},
           {{"study", "merge", source("study.sqlite"), "-o", target("all.sqlite")},
            target("all.sqlite")}}) {
    const ProgramResult result = run(command);
    EXPECT_EQ(result.exit_code, 1) << result.output;
    EXPECT_THAT(result.errors,
                AllOf(HasSubstr("foveola: error: " + named),
                      Not(HasSubstr("foveola: error: " + source("study.sqlite") + ":"))));
  }
  EXPECT_THAT(run_program({"ls", "-A", disk.folder().string()}).output, "filling\n");
}

}  // namespace
}  // namespace foveola::test
