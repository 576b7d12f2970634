#include "tests/end_to_end/program.h"

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdlib>
#include <stdexcept>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "renderer/base/files/files.h"
#include "tests/matchers.h"

namespace fs = std::filesystem;

namespace foveola::test {
namespace {

void write_into(const fs::path& output, const fs::path& errors) {
  constexpr mode_t mode = 0600;
  ::dup2(::open("/dev/null", O_RDONLY), STDIN_FILENO);
  ::dup2(::open(output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, mode), STDOUT_FILENO);
  ::dup2(::open(errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC, mode), STDERR_FILENO);
}

std::string base64(const std::vector<unsigned char>& bytes) {
  static constexpr char alphabet[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](std::size_t k) { return k < bytes.size() ? bytes[k] : 0U; };
    const unsigned group = byte(i) << 16 | byte(i + 1) << 8 | byte(i + 2);
    for (unsigned k = 0; k < 4; ++k) {
      text += i + k <= bytes.size() ? alphabet[group >> (18 - 6 * k) & 63U] : '=';
    }
  }
  return text;
}

}  // namespace

void become(const std::vector<std::string>& command, const Environment& environment) {
  for (const auto& [name, value] : environment) {
    ::setenv(name.c_str(), value.c_str(), 1);
  }
  std::vector<char*> arguments;
  for (const std::string& argument : command) {
    arguments.push_back(const_cast<char*>(argument.c_str()));
  }
  arguments.push_back(nullptr);
  ::signal(SIGHUP, SIG_DFL);  // nohup, which the tests may run under, has it ignored
  ::execvp(arguments[0], arguments.data());
  ::_exit(127);
}

ProgramResult run_program(const std::vector<std::string>& command, const Environment& environment) {
  const TemporaryFolder folder;
  const pid_t child = ::fork();
  if (child == 0) {
    write_into(folder / "output", folder / "errors");
    become(command, environment);
  }
  int status = 0;
  if (child < 0 || ::waitpid(child, &status, 0) != child) {
    throw std::runtime_error("cannot run " + command.front());
  }
  return {.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
          .output = read_file(folder / "output"),
          .errors = read_file(folder / "errors")};
}

ProgramResult run_foveola(std::vector<std::string> arguments, const Environment& environment) {
  arguments.insert(arguments.begin(), FOVEOLA_PROGRAM);
  return run_program(arguments, environment);
}

std::vector<std::string> joined(std::vector<std::string> words,
                                const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

ProgramResult succeeded(ProgramResult result, std::source_location place) {
  if (result.exit_code != 0) {
    ADD_FAILURE_AT(place.file_name(), static_cast<int>(place.line()))
        << "exit code " << result.exit_code << ": " << result.errors;
  }
  return result;
}

void expect_one_line(const ProgramResult& result, int exit_code, const std::string& says) {
  EXPECT_EQ(result.exit_code, exit_code) << result.errors;
  EXPECT_THAT(result.output, IsEmpty());
  EXPECT_THAT(result.errors, StartsWith("foveola: error: "));
  EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << result.errors;
  EXPECT_THAT(result.errors, HasSubstr(says));
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

std::string room_gltf() {
  // A cube of 4 m whose corners are numbered by the bits of their index (x, y, z), its walls facing
  // inwards, and a lamp of 1 m below the ceiling, facing down.
  std::vector<float> positions;
  for (unsigned corner = 0; corner < 8; ++corner) {
    for (unsigned axis = 0; axis < 3; ++axis) {
      positions.push_back((corner >> axis & 1U) != 0 ? 2.0F : -2.0F);
    }
  }
  positions.insert(positions.end(),
                   {-.5F, 1.9F, -.5F, .5F, 1.9F, -.5F, .5F, 1.9F, .5F, -.5F, 1.9F, .5F});
  const std::array<std::uint16_t, 42> indices = {0, 2, 4, 4, 2, 6, 1, 5, 3, 3, 5,  7, 0,  4,
                                                 1, 1, 4, 5, 2, 3, 6, 6, 3, 7, 0,  1, 2,  2,
                                                 1, 3, 4, 6, 5, 5, 6, 7, 8, 9, 10, 8, 10, 11};
  std::vector<unsigned char> bytes(positions.size() * sizeof(float) + sizeof(indices));
  std::copy_n(reinterpret_cast<const unsigned char*>(positions.data()),
              positions.size() * sizeof(float), bytes.begin());
  std::copy_n(reinterpret_cast<const unsigned char*>(indices.data()), sizeof(indices),
              bytes.begin() + static_cast<std::ptrdiff_t>(positions.size() * sizeof(float)));
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
"nodes":[{"name":"room","mesh":0}],
"meshes":[{"primitives":[
 {"attributes":{"POSITION":0},"indices":1,"material":0},
 {"attributes":{"POSITION":0},"indices":2,"material":1}]}],
"materials":[
 {"name":"wall","pbrMetallicRoughness":{"baseColorFactor":[0.6,0.6,0.6,1],"metallicFactor":0}},
 {"name":"lamp","emissiveFactor":[1,1,1],
  "extensions":{"KHR_materials_emissive_strength":{"emissiveStrength":10}}}],
"extensionsUsed":["KHR_materials_emissive_strength"],
"accessors":[
 {"bufferView":0,"componentType":5126,"count":12,"type":"VEC3","min":[-2,-2,-2],"max":[2,2,2]},
 {"bufferView":1,"componentType":5123,"count":36,"type":"SCALAR"},
 {"bufferView":1,"byteOffset":72,"componentType":5123,"count":6,"type":"SCALAR"}],
"bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":144},
 {"buffer":0,"byteOffset":144,"byteLength":84}],
"buffers":[{"byteLength":228,"uri":"data:application/octet-stream;base64,)" +
         base64(bytes) + R"("}]})";
}

}  // namespace foveola::test
