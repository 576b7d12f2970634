// What users get wrong: one clear line, the right exit code, nothing half-written.
#include <functional>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sqlite3.h>
#include <sys/stat.h>

#include "renderer/base/files.h"
#include "renderer/glb/glb_document.h"
#include "tests/end_to_end/program.h"

namespace fs = std::filesystem;

namespace foveola::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A scene file that cannot be rendered, and what the error must name.
struct BadScene {
  const char* name;
  std::string file;
  std::function<void(const fs::path&)> make;
  std::string says;
};

void PrintTo(const BadScene& scene, std::ostream* out) { *out << scene.name; }

class BadSceneFile : public testing::TestWithParam<BadScene> {};

TEST_P(BadSceneFile, IsRefused) {
  const TemporaryFolder folder;
  const fs::path file = folder / GetParam().file;
  GetParam().make(file);
  const std::vector<std::string> before = folder.entries();
  const ProgramResult result =
      run_foveola({"render", file.string(), "-o", (folder / "out.exr").string(), "--size", "8x4"});
  expect_one_line(result, 1, GetParam().says);
  EXPECT_EQ(folder.entries(), before);
}

const auto write = [](const std::string& content) {
  return [content](const fs::path& path) { write_file(path, content); };
};

INSTANTIATE_TEST_SUITE_P(
    Scenes, BadSceneFile,
    testing::Values(
        BadScene{"missing", "absent.glb", [](const fs::path&) {}, "absent.glb"},
        BadScene{"folder", "folder.glb", [](const fs::path& p) { fs::create_directory(p); },
                 "folder"},
        BadScene{"empty", "empty.glb", write(""), "empty.glb"},
        BadScene{"truncated", "cut.glb",
                 write(glb_container(R"({"asset":{"version":"2.0"}})", "").substr(0, 30)),
                 "cut.glb"},
        BadScene{"noise", "noise.glb", write(std::string(1000, '\x5a')), "noise.glb"},
        BadScene{"not_gltf", "data.gltf", write(R"({"name": "not a scene"})"), "data.gltf"},
        BadScene{"not_json", "text.gltf", write("{]"), "text.gltf"},
        BadScene{"required_extension", "needs.gltf",
                 write(R"({"asset":{"version":"2.0"},"extensionsUsed":["KHR_texture_basisu"],
                          "extensionsRequired":["KHR_texture_basisu"]})"),
                 "KHR_texture_basisu"},
        BadScene{"outside", "outside.gltf", write(R"({"asset":{"version":"2.0"},
                          "buffers":[{"byteLength":4,"uri":"../../../etc/passwd"}]})"),
                 "outside.gltf"},
        BadScene{"short_buffer", "short.gltf",
                 write(replaced(room_gltf(), R"("byteLength":84)", R"("byteLength":840000000)")),
                 "short.gltf"},
        BadScene{"wild_count", "count.gltf",
                 write(replaced(room_gltf(), R"("count":36)", R"("count":4000000000)")),
                 "count.gltf"}),
    [](const testing::TestParamInfo<BadScene>& test) { return test.param.name; });

/// Options of `render` that make no sense.
struct BadOptions {
  const char* name;
  std::vector<std::string> options;
  std::string says;
};

void PrintTo(const BadOptions& options, std::ostream* out) { *out << options.name; }

class BadRenderOptions : public testing::TestWithParam<BadOptions> {};

TEST_P(BadRenderOptions, AreUsageErrors) {
  const TemporaryFolder folder;
  write_file(folder / "room.gltf", room_gltf());
  std::vector<std::string> arguments = {"render", (folder / "room.gltf").string(), "-o",
                                        (folder / "out.exr").string()};
  arguments.insert(arguments.end(), GetParam().options.begin(), GetParam().options.end());
  expect_one_line(run_foveola(arguments), 2, GetParam().says);
  EXPECT_THAT(folder.entries(), ElementsAre("room.gltf"));
}

INSTANTIATE_TEST_SUITE_P(
    Options, BadRenderOptions,
    testing::Values(BadOptions{"negative_size", {"--size", "-64x32"}, "--size"},
                    BadOptions{"zero_size", {"--size", "0x32"}, "--size"},
                    BadOptions{"huge_size", {"--size", "100000x100000"}, "--size"},
                    BadOptions{"wordy_size", {"--size", "big"}, "--size"},
                    BadOptions{"nan_gaze", {"--gaze", "nan,0"}, "--gaze"},
                    BadOptions{"infinite_gaze", {"--gaze", "inf,0"}, "--gaze"},
                    BadOptions{"high_gaze", {"--gaze", "0,91"}, "--gaze"},
                    BadOptions{"half_a_head", {"--head", "10"}, "--head"},
                    BadOptions{"nan_camera", {"--camera", "0,nan,0"}, "--camera"},
                    BadOptions{"zero_samples", {"--samples", "0"}, "--samples"},
                    BadOptions{"negative_samples", {"--samples", "-5"}, "--samples"},
                    BadOptions{"zero_spp", {"--spp", "0"}, "--spp"},
                    BadOptions{"nan_spp", {"--spp", "nan"}, "--spp"},
                    BadOptions{"negative_seconds", {"--seconds", "-1"}, "--seconds"},
                    BadOptions{"nan_seconds", {"--seconds", "nan"}, "--seconds"},
                    BadOptions{"two_budgets", {"--spp", "1", "--seconds", "1"}, "--spp"},
                    BadOptions{"flat_view", {"--fov", "180"}, "--fov"},
                    BadOptions{"nan_fov", {"--fov", "nan"}, "--fov"},
                    BadOptions{"no_depth", {"--max-depth", "0"}, "--max-depth"},
                    BadOptions{"minus_threads", {"--threads", "-1"}, "--threads"},
                    BadOptions{"negative_seed", {"--seed", "-1"}, "--seed"},
                    BadOptions{"unknown_method", {"--method", "xx"}, "--method"},
                    BadOptions{"dark_sky", {"--environment", "-1,0,0"}, "--environment"},
                    BadOptions{"unknown_option", {"--sizes", "8x4"}, "--sizes"}),
    [](const testing::TestParamInfo<BadOptions>& test) { return test.param.name; });

class BadInput : public testing::Test {
 protected:
  void SetUp() override { write_file(folder_ / "room.gltf", room_gltf()); }
  ProgramResult render_to(const std::string& output) {
    return run_foveola({"render", (folder_ / "room.gltf").string(), "-o", output, "--size", "8x4"});
  }
  TemporaryFolder folder_;
};

TEST_F(BadInput, OutputsThatCannotBeWrittenAreRefusedBeforeTheWork) {
  expect_one_line(render_to((folder_ / "absent" / "x.exr").string()), 1, "does not exist");
  expect_one_line(render_to((folder_ / "x.tga").string()), 2, ".tga");
  fs::create_directory(folder_ / "x.exr");
  expect_one_line(render_to((folder_ / "x.exr").string()), 1, "is a folder");
}

TEST_F(BadInput, AnUnknownEnvironmentFileIsNamed) {
  expect_one_line(
      run_foveola({"render", (folder_ / "room.gltf").string(), "-o", (folder_ / "x.exr").string(),
                   "--environment", (folder_ / "sky.exr").string()}),
      1, "sky.exr");
}

TEST_F(BadInput, NoCommandAndUnknownCommandsAreUsageErrors) {
  expect_one_line(run_foveola({}), 2, "--help");
  expect_one_line(run_foveola({"rendre"}), 2, "rendre");
  expect_one_line(run_foveola({"study", "simulate"}), 2, "see foveola study simulate --help");
}

TEST_F(BadInput, ProtocolsAreRefusedWithLineAndColumn) {
  const std::string protocol = read_file(resource_folder() / "protocols" / "demo.toml");
  const auto check = [&](const std::string& text) {
    write_file(folder_ / "p.toml", text);
    return run_foveola({"study", "simulate", (folder_ / "p.toml").string(), "--db",
                        (folder_ / "study.sqlite").string(), "--participants", "1"});
  };
  expect_one_line(check("colour = 1\n" + protocol), 1, "p.toml:1:1");
  expect_one_line(check(replaced(protocol, "\"arcade\"", "\"no-such-scene\"")), 1, "no-such-scene");
  EXPECT_THAT(check(replaced(protocol, "\"arcade\"", "\"no-such-scene\"")).errors,
              testing::ContainsRegex("p\\.toml:[0-9]+:[0-9]+"));
  expect_one_line(check("= ["), 1, "p.toml:1:1");
  EXPECT_THAT(folder_.entries(), ElementsAre("p.toml", "room.gltf"));
}

TEST_F(BadInput, FilesThatNestOrListWithoutEndAreRefused) {
  std::string deep = "a";
  std::string scenes = "\"arcade\"";
  for (int i = 0; i < 50'000; ++i) {
    deep += ".a";
    scenes += ", \"scene-" + std::to_string(i) + "\"";
  }
  deep += " = 1\n";
  write_file(folder_ / "deep.toml", deep);
  const std::string protocol = read_file(resource_folder() / "protocols" / "demo.toml");
  write_file(folder_ / "long.toml", replaced(protocol, "\"arcade\"", scenes));
  write_file(folder_ / "asks.toml",
             protocol + "\n[[questionnaire]]\nid = \"q\"\nfile = \"./deep.toml\"\n");
  const auto path = [&](const char* name) { return (folder_ / name).string(); };
  expect_one_line(run_foveola({"study", "check", path("deep.toml")}), 1, "deep.toml:1:32");
  expect_one_line(run_foveola({"study", "check", path("asks.toml")}), 1, "deep.toml:1:32");
  expect_one_line(run_foveola({"study", "check", path("long.toml")}), 1,
                  "scenes has 50003 entries, and at most 1000 are read");
  expect_one_line(run_foveola({"study", "simulate", "demo", "--db", path("new.sqlite"),
                               "--participants", "1", "--people", path("deep.toml")}),
                  1, "deep.toml:1:32");
  EXPECT_THAT(folder_.entries(), ElementsAre("asks.toml", "deep.toml", "long.toml", "room.gltf"));
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
      expect_one_line(run_foveola(command), 1, name + ": is no file");
    }
    expect_one_line(run_foveola({"study", "simulate", "demo", "--participants", "1", "--db", name}),
                    1, name == folder ? "is a folder, not a file" : "is no file");
  }
  for (const char* const name : {"pipe", "pipe.glb"}) {
    expect_one_line(run_foveola({"scene", "info", path(name)}), 1, "is not a regular file");
    expect_one_line(run_foveola({"render", path("room.gltf"), "-o", path("x.exr"), "--environment",
                                 path(name)}),
                    1, "is not a regular file");
    expect_one_line(run_foveola({"compare", path(name), path(name)}), 1, "is no file");
  }
  EXPECT_THAT(folder_.entries(), ElementsAre("pipe", "pipe.glb", "pipe.toml", "room.gltf"));
}

TEST_F(BadInput, NamesInAProtocolDoNotControlTheTerminal) {
  const std::string protocol = read_file(resource_folder() / "protocols" / "demo.toml");
  const std::string file = (folder_ / "p.toml").string();
  const std::string title = "\"\\u001b]0;mine\\u0007\\u009b31m\\u202e\\u200b\\uFEFFA small ";
  write_file(file, replaced(protocol, "\"A small ", title));
  const ProgramResult checked = run_foveola({"study", "check", file});
  EXPECT_EQ(checked.exit_code, 0) << checked.errors;
  EXPECT_THAT(checked.output, HasSubstr("?]0;mine??31m???A small "));
  const ProgramResult in_json = run_foveola({"study", "check", file, "--json"});
  EXPECT_THAT(in_json.output, HasSubstr("\\u001b]0;mine\\u0007\\u009b31m\\u202e\\u200b\\ufeffA"));
  EXPECT_THAT(nlohmann::json::parse(in_json.output).at("title").get<std::string>(),
              testing::StartsWith("\x1b]0;mine\x07\u009b31m\u202e\u200b\uFEFFA small "));
  write_file(file, replaced(protocol, "\"arcade\"", "\"\\u001b[2J\\u2066arcade\""));
  expect_one_line(run_foveola({"study", "check", file}), 1, ": ?[2J?arcade: no such scene");
}

TEST_F(BadInput, WhatAProtocolHardlyMeansIsWarnedOf) {
  const std::string protocol = read_file(resource_folder() / "protocols" / "demo.toml");
  write_file(folder_ / "p.toml",
             "language = \"de\"\n" + replaced(protocol, "\"od\", \"vp\", \"fv\"",
                                              "\"od\", \"fv\", \"fv:acuity=reddy\""));
  const ProgramResult checked =
      run_foveola({"study", "check", (folder_ / "p.toml").string(), "--json"});
  EXPECT_EQ(checked.exit_code, 0) << checked.errors;
  EXPECT_THAT(checked.errors, HasSubstr("'fv:acuity=reddy' is the same method as 'fv'"));
  EXPECT_THAT(checked.errors, HasSubstr("p.toml:1:12: the language is de, and "));
  EXPECT_THAT(checked.output, HasSubstr("\"texts.welcome\""));
}

TEST_F(BadInput, DatabasesOfAnotherSchemaAreLeftAlone) {
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open((folder_ / "other.sqlite").c_str(), &database), SQLITE_OK);
  ASSERT_EQ(sqlite3_exec(database, "CREATE TABLE t (x); INSERT INTO t VALUES (1)", nullptr, nullptr,
                         nullptr),
            SQLITE_OK);
  sqlite3_close(database);
  write_file(folder_ / "text.sqlite", "not a database, only text that is long enough to be read");
  for (const std::string name : {"other.sqlite", "text.sqlite"}) {
    const std::string before = read_file(folder_ / name);
    const std::string path = (folder_ / name).string();
    expect_one_line(run_foveola({"analyze", path, "-o", (folder_ / "out").string()}), 1, name);
    expect_one_line(run_foveola({"study", "simulate", "demo", "--db", path, "--participants", "1"}),
                    1, name);
    EXPECT_EQ(read_file(folder_ / name), before);
  }
  expect_one_line(run_foveola({"analyze", (folder_ / "absent.sqlite").string(), "-o",
                               (folder_ / "out").string()}),
                  1, "absent.sqlite");
  EXPECT_THAT(folder_.entries(), ElementsAre("other.sqlite", "room.gltf", "text.sqlite"));
}

}  // namespace
}  // namespace foveola::test
