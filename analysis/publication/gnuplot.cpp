#include "analysis/publication/gnuplot.h"

#include <system_error>

#include "renderer/base/error.h"
#include "renderer/base/programs.h"

namespace foveola::analysis {
namespace {

ProgramEnd end_of_gnuplot(const std::string& script) {
  const std::string without_user_settings = "-d";
  try {
    // By its name, gnuplot reads it in large pieces; what it takes as its input, byte by byte.
    return run_to_end({.words = {"gnuplot", without_user_settings, "/dev/stdin"}, .input = script});
  } catch (const std::system_error&) {
    throw Error("gnuplot", "cannot be started, and it draws the figures",
                "install it: apt-get install gnuplot-nox");
  }
}

}  // namespace

std::string run_gnuplot(const std::string& script) {
  const ProgramEnd end = end_of_gnuplot(script);
  if (end.status != 0) {
    throw Error("gnuplot", "stopped with an error: " + end.errors,
                "check that gnuplot 5.4 or newer is installed");
  }
  return end.output;
}

bool has_font() {
  try {
    // Of fontconfig, which gnuplot asks for fonts through Pango.
    return !run_to_end({.words = {"fc-match", "--format=%{file}", "sans-serif"}}).output.empty();
  } catch (const std::system_error&) {
    return true;  // Nobody knows.
  }
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

std::string gnuplot_tick_label(std::string_view text) {
  std::string format;
  for (const char c : text) {
    format += c == '%' ? "%%" : std::string(1, c);
  }
  return gnuplot_quoted(format);
}

}  // namespace foveola::analysis
