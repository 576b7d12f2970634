// Whatever a scene's files name, and whichever library reads them, nothing outside the scene's
// folder is opened. The kernel is asked, so that a library that reads files by itself is seen, too.
#include <array>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <sys/inotify.h>
#include <unistd.h>

#include "renderer/base/error.h"
#include "renderer/base/files/files.h"
#include "renderer/scene/load_scene.h"
#include "tests/matchers.h"
#include "tests/renderer/scene/glb_builder.h"

namespace foveola::test {
namespace {

namespace fs = std::filesystem;

/// Which files of a folder have been opened since it was made.
class OpenedFiles {
 public:
  explicit OpenedFiles(const fs::path& folder)
      : events_(::inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {
    if (::inotify_add_watch(events_, folder.c_str(), IN_OPEN) < 0) {
      throw std::runtime_error("inotify does not watch " + folder.string());
    }
  }
  ~OpenedFiles() { ::close(events_); }
  OpenedFiles(const OpenedFiles&) = delete;
  OpenedFiles& operator=(const OpenedFiles&) = delete;

  std::vector<std::string> names() const {
    alignas(inotify_event) std::array<char, 65536> bytes{};
    std::vector<std::string> names;
    for (ssize_t size = 0; (size = ::read(events_, bytes.data(), bytes.size())) > 0;) {
      for (ssize_t at = 0; at < size;) {
        const auto* event = reinterpret_cast<const inotify_event*>(bytes.data() + at);
        if (event->len > 0) {
          names.emplace_back(event->name);
        }
        at += ssize_t(sizeof(inotify_event) + event->len);
      }
    }
    return names;
  }

 private:
  int events_;
};

/// The working folder until the end of the scope.
class WorkingFolder {
 public:
  explicit WorkingFolder(const fs::path& folder) : before_(fs::current_path()) {
    fs::current_path(folder);
  }
  ~WorkingFolder() { fs::current_path(before_); }
  WorkingFolder(const WorkingFolder&) = delete;
  WorkingFolder& operator=(const WorkingFolder&) = delete;

 private:
  fs::path before_;
};

const std::string red_mtl = "newmtl m\nKd 1 0 0\n";

std::string textured_obj(const std::string& library) {
  return "mtllib " + library + "\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl m\nf 1/1 2/1 3/1\n";
}

Scene load(const fs::path& file, const SceneReading& reading = {}) {
  return file.extension() == ".obj" ? load_obj(file, reading) : load_gltf(file, reading);
}

class Confinement : public InTemporaryFolder {
 protected:
  Confinement() {
    const std::string buffer = textured_triangle("", "").buffer;
    for (const fs::path& bait_folder : {outside(), working()}) {
      for (const char* const name : {"a.bin", "content", "data"}) {
        write(bait_folder / name, buffer);
      }
      write(bait_folder / "a.png", one_pixel(255, 0, 0));
      write(bait_folder / "a.mtl", red_mtl);
    }
    fs::create_directory(scene());
  }

  fs::path scene() const { return folder() / "scene"; }
  fs::path outside() const { return folder() / "outside"; }
  fs::path working() const { return folder() / "working"; }

  /// All names by which a file of outside() might be reached from the scene's folder.
  std::vector<std::string> ways_out(const std::string& name) const {
    const fs::path link = scene() / ("link to " + name);
    fs::remove(link);
    fs::create_symlink(outside() / name, link);
    fs::remove(scene() / "folder");
    fs::create_symlink(outside(), scene() / "folder");
    return {"../outside/" + name,
            "%2e%2e/outside/" + name,
            "..%2Foutside%2F" + name,
            "..\\outside\\" + name,
            "./x/../../outside/" + name,
            (outside() / name).string(),
            "file:" + (outside() / name).string(),
            "file://" + (outside() / name).string(),
            link.filename().string(),
            "link%20to%20" + name,
            "folder/" + name};
  }

  /// Loads it as a stranger's file may be: whatever is refused or warned of, nothing is opened.
  void expect_nothing_opened(const std::string& file, const std::string& text) const {
    write(scene() / file, text);
    const WorkingFolder working_folder(working());
    const OpenedFiles outside_files(outside());
    const OpenedFiles working_files(working());
    for (const bool strict : {false, true}) {
      try {
        load(scene() / file, {.strict = strict});
      } catch (const Error&) {
        // A refusal is what it may well end with.
      }
    }
    EXPECT_THAT(outside_files.names(), IsEmpty()) << text;
    EXPECT_THAT(working_files.names(), IsEmpty()) << text;
  }

  void write(const fs::path& file, const std::string& bytes) const {
    fs::create_directories(file.parent_path());
    write_file(file, bytes);
  }
};

TEST_F(Confinement, TheKernelSeesWhatIsOpened) {
  const OpenedFiles files(outside());
  EXPECT_THAT(files.names(), IsEmpty());
  read_file(outside() / "a.bin");
  EXPECT_THAT(files.names(), ElementsAre("a.bin"));
}

TEST_F(Confinement, BuffersOfAGltfOpenNothingElsewhere) {
  write(scene() / "a.png", one_pixel(0, 0, 255));
  for (const std::string& way : ways_out("a.bin")) {
    expect_nothing_opened("scene.gltf", textured_triangle(way, "a.png").document.dump());
  }
}

TEST_F(Confinement, ImagesOfAGltfOpenNothingElsewhere) {
  write(scene() / "a.bin", textured_triangle("", "").buffer);
  for (const std::string& way : ways_out("a.png")) {
    expect_nothing_opened("scene.gltf", textured_triangle("a.bin", way).document.dump());
  }
}

TEST_F(Confinement, LibrariesOfAnObjOpenNothingElsewhere) {
  for (const std::string& way : ways_out("a.mtl")) {
    expect_nothing_opened("scene.obj", textured_obj(way));
  }
}

TEST_F(Confinement, TexturesOfAnObjOpenNothingElsewhere) {
  for (const std::string& way : ways_out("a.png")) {
    write(scene() / "a.mtl", "newmtl m\nmap_Kd " + way + "\n");
    expect_nothing_opened("scene.obj", textured_obj("a.mtl"));
  }
}

/// A library that reads by itself looks in the working folder, by the name that it is given.
TEST_F(Confinement, FilesOfTheSameNamesInTheWorkingFolderAreNotTaken) {
  write(scene() / "a.bin", textured_triangle("", "").buffer);
  write(scene() / "a.png", one_pixel(0, 0, 255));
  write(scene() / "a.mtl", "newmtl m\nmap_Kd a.png\n");
  expect_nothing_opened("scene.gltf", textured_triangle("a.bin", "a.png").document.dump());
  expect_nothing_opened("scene.obj", textured_obj("a.mtl"));
  const WorkingFolder working_folder(working());
  for (const char* const file : {"scene.gltf", "scene.obj"}) {
    EXPECT_EQ(load(scene() / file).textures.at(0).sample({0, 0}), Vec4(0, 0, 1, 1)) << file;
  }
}

TEST_F(Confinement, WhatIsMissingBesideTheSceneIsNotTakenFromTheWorkingFolder) {
  expect_nothing_opened("scene.gltf", textured_triangle("a.bin", "a.png").document.dump());
  expect_nothing_opened("scene.obj", textured_obj("a.mtl"));
  write(scene() / "a.mtl", "newmtl m\nmap_Kd a.png\n");
  expect_nothing_opened("scene.obj", textured_obj("a.mtl"));
}

}  // namespace
}  // namespace foveola::test
