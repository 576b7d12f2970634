#include "analysis/publication/gnuplot.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "renderer/base/error.h"

namespace foveola::analysis {
namespace {

// The streams are unnamed temporary files rather than pipes, so that neither side can block.
struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

File temporary_file(std::string_view content = "") {
  File file(std::tmpfile());
  if (!file || std::fwrite(content.data(), 1, content.size(), file.get()) != content.size() ||
      std::fflush(file.get()) != 0) {
    throw Error("gnuplot", "its script cannot be written to a temporary file",
                "check the free space and permissions of the folder for temporary files");
  }
  std::rewind(file.get());
  return file;
}

std::string content_of(const File& file) {
  std::rewind(file.get());
  std::string content;
  std::array<char, 65536> buffer{};
  std::size_t count = 0;
  while ((count = std::fread(buffer.data(), 1, buffer.size(), file.get())) > 0) {
    content.append(buffer.data(), count);
  }
  return content;
}

/// The exit status of the started gnuplot, as wait() gives it.
int run_with(const File& input, const File& output, const File& errors) {
  posix_spawn_file_actions_t streams;
  posix_spawn_file_actions_init(&streams);
  posix_spawn_file_actions_adddup2(&streams, ::fileno(input.get()), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&streams, ::fileno(output.get()), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&streams, ::fileno(errors.get()), STDERR_FILENO);
  std::string program = "gnuplot";
  std::string without_user_settings = "-d";
  const std::array<char*, 3> arguments = {program.data(), without_user_settings.data(), nullptr};
  pid_t process = 0;
  const int failure =
      ::posix_spawnp(&process, program.c_str(), &streams, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&streams);
  if (failure != 0) {
    throw Error("gnuplot", "cannot be started, and it draws the figures",
                "install it: apt-get install gnuplot-nox");
  }
  int status = 0;
  while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

}  // namespace

std::string run_gnuplot(const std::string& script) {
  const File input = temporary_file(script);
  const File output = temporary_file();
  const File errors = temporary_file();
  const int status = run_with(input, output, errors);
  if (status != 0) {
    throw Error("gnuplot", "stopped with an error: " + content_of(errors),
                "check that gnuplot 5.4 or newer is installed");
  }
  return content_of(output);
}

std::string gnuplot_quoted(std::string_view text) {
  std::string quoted = "'";
  for (const char c : text) {
    if (c == '\'') {
      quoted += "''";
    } else {
      quoted += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? ' ' : c;
    }
  }
  return quoted + "'";
}

}  // namespace foveola::analysis
