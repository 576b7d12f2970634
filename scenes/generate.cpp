// The program foveola-scenes, which the laboratory runs: it makes a built-in scene and prints it.
//
//   foveola-scenes DIGEST NAME SEED
//
// DIGEST is that of the generators that are asked for. A line with the number of triangles and the
// number of bytes is followed by as many bytes of a .glb file. To standard output rather than into
// a file, since nothing can then be left half-written by whatever ends this program.
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "scenes/builtin.h"
#include "scenes/generators_digest.h"
#include "scenes/modelling/glb_writer.h"

namespace foveola::scenes {
namespace {

struct Arguments {
  std::string digest;
  std::string name;
  std::uint32_t seed = default_seed;
};

bool read(int argc, char** argv, Arguments& arguments) {
  if (argc != 4) {
    return false;
  }
  arguments.digest = argv[1];
  arguments.name = argv[2];
  const std::string_view seed = argv[3];
  const char* const end = seed.data() + seed.size();
  const auto [rest, failure] = std::from_chars(seed.data(), end, arguments.seed);
  return failure == std::errc() && rest == end;
}

int refuse(const std::string& reason) {
  fmt::print(stderr, "{}\n", reason);
  return refusal_exit_code;
}

int print_scene(const Arguments& arguments) {
  const Model model = make_builtin(arguments.name, arguments.seed);
  const std::string glb = glb_from(model);
  fmt::print("{} {}\n", model.triangle_count(), glb.size());
  const bool is_printed =
      std::fwrite(glb.data(), 1, glb.size(), stdout) == glb.size() && std::fflush(stdout) == 0;
  return is_printed ? 0 : 1;
}

int run(int argc, char** argv) {
  Arguments arguments;
  if (!read(argc, argv, arguments)) {
    return refuse("usage: foveola-scenes DIGEST NAME SEED; see 'foveola scene make --help'");
  }
  if (arguments.digest != generators_digest()) {
    return refuse(
        fmt::format("the generators here are {}, not {}", generators_digest(), arguments.digest));
  }
  try {
    return print_scene(arguments);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}

}  // namespace
}  // namespace foveola::scenes

int main(int argc, char** argv) { return foveola::scenes::run(argc, argv); }
