// What users get wrong: one clear line, the right exit code, nothing half-written.
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include <sys/stat.h>

#include "renderer/base/files/files.h"
#include "renderer/glb/glb_document.h"
#include "tests/end_to_end/program.h"
#include "tests/matchers.h"

namespace fs = std::filesystem;

namespace foveola::test {
namespace {

class BadInput : public testing::Test {
 protected:
  void SetUp() override { write_file(folder_ / "room.gltf", room_gltf()); }
  ProgramResult render_to(const std::string& output) {
    return run_foveola({"render", (folder_ / "room.gltf").string(), "-o", output, "--size", "8x4"});
  }
  TemporaryFolder folder_;
};

TEST_F(BadInput, SceneFilesThatCannotBeReadAreRefused) {
  write_file(folder_ / "cut.glb",
             glb_container(R"({"asset":{"version":"2.0"}})", "").substr(0, 30));
  write_file(folder_ / "needs.gltf",
             R"({"asset":{"version":"2.0"},"extensionsUsed":["KHR_texture_basisu"],
                 "extensionsRequired":["KHR_texture_basisu"]})");
  write_file(folder_ / "outside.gltf",
             R"({"asset":{"version":"2.0"},
                 "buffers":[{"byteLength":4,"uri":"../../../etc/passwd"}]})");
  write_file(folder_ / "count.gltf",
             replaced(room_gltf(), R"("count":36)", R"("count":4000000000)"));
  const std::vector<std::string> before = folder_.entries();
  for (const std::string name :
       {"absent.glb", "cut.glb", "needs.gltf", "outside.gltf", "count.gltf"}) {
    expect_one_line(run_foveola({"render", (folder_ / name).string(), "-o",
                                 (folder_ / "out.exr").string(), "--size", "8x4"}),
                    1, name);
  }
  EXPECT_EQ(folder_.entries(), before);
}

TEST_F(BadInput, OptionsThatMakeNoSenseAreUsageErrors) {
  using Options = std::vector<std::string>;
  for (const Options& options : {Options{"--size", "-64x32"},
                                 {"--size", "0x32"},
                                 {"--size", "100000x100000"},
                                 {"--size", "big"},
                                 {"--gaze", "nan,0"},
                                 {"--gaze", "inf,0"},
                                 {"--gaze", "0,91"},
                                 {"--camera", "0,nan,0"},
                                 {"--samples", "0"},
                                 {"--samples", "-5"},
                                 {"--spp", "0"},
                                 {"--spp", "nan"},
                                 {"--spp", "1", "--seconds", "1"},
                                 {"--seconds", "-1"},
                                 {"--seconds", "nan"},
                                 {"--fov", "nan"},
                                 {"--max-depth", "0"},
                                 {"--threads", "-1"},
                                 {"--seed", "-1"},
                                 {"--method", "xx"},
                                 {"--environment", "-1,0,0"},
                                 {"--sizes", "8x4"}}) {
    const Options render = {"render", (folder_ / "room.gltf").string(), "-o",
                            (folder_ / "out.exr").string()};
    expect_one_line(run_foveola(joined(render, options)), 2, options.front());
  }
  EXPECT_THAT(folder_.entries(), ElementsAre("room.gltf"));
}

TEST_F(BadInput, OutputsThatCannotBeWrittenAreRefusedBeforeTheWork) {
  expect_one_line(render_to((folder_ / "absent" / "x.exr").string()), 1, "does not exist");
  expect_one_line(render_to((folder_ / "x.tga").string()), 2, ".tga");
  fs::create_directory(folder_ / "x.exr");
  expect_one_line(render_to((folder_ / "x.exr").string()), 1, "is a folder");
}

TEST_F(BadInput, NoCommandAndUnknownCommandsAreUsageErrors) {
  expect_one_line(run_foveola({}), 2, "--help");
  expect_one_line(run_foveola({"rendre"}), 2, "rendre");
  expect_one_line(run_foveola({"study", "simulate"}), 2, "see foveola study simulate --help");
}

TEST_F(BadInput, PipesDevicesAndFoldersEndACommandAtOnce) {
  ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  fs::create_symlink("pipe", folder_ / "pipe.glb");
  fs::create_symlink("pipe", folder_ / "pipe.toml");
  const auto path = [&](const std::string& name) { return (folder_ / name).string(); };
  const std::string folder = folder_.path().string();
  const std::string new_file = path("new");
  using Command = std::vector<std::string>;
  for (const auto& [name, what] : {std::pair(path("pipe"), "is not a regular file"),
                                   {path("pipe.toml"), "is not a regular"},
                                   {"/dev/zero", "is not a regular file"},
                                   {folder, "is a folder, not a file"}}) {
    for (const Command& command : std::initializer_list<Command>{
             {"study", "check", name},
             {"study", "plan", name, "--participants", "1"},
             {"study", "simulate", name, "--participants", "1", "--db", new_file},
             {"study", "simulate", "demo", "--participants", "1", "--db", new_file, "--people",
              name},
             {"tracker", "watch", name},
             {"tracker", "watch", "simulated", "--display", name}}) {
      expect_one_line(run_foveola(command), 1, name + ": " + what);
    }
    for (const Command& command :
         std::initializer_list<Command>{{"study", "status", name},
                                        {"study", "verify", name},
                                        {"analyze", name, "-o", new_file}}) {
      expect_one_line(run_foveola(command), 1, name + ": is not a regular file");
    }
    expect_one_line(run_foveola({"study", "simulate", "demo", "--participants", "1", "--db", name}),
                    1, name == folder ? "is a folder, not a file" : "is not a regular file");
  }
  for (const char* const name : {"pipe", "pipe.glb"}) {
    expect_one_line(run_foveola({"scene", "info", path(name)}), 1, "is not a regular file");
    expect_one_line(run_foveola({"render", path("room.gltf"), "-o", path("x.exr"), "--environment",
                                 path(name)}),
                    1, "is not a regular file");
    expect_one_line(run_foveola({"compare", path(name), path(name)}), 1, "is not a regular file");
  }
  EXPECT_THAT(folder_.entries(), ElementsAre("pipe", "pipe.glb", "pipe.toml", "room.gltf"));
}

}  // namespace
}  // namespace foveola::test
