#include "study/console/open_console.h"

#include <unistd.h>

#include "study/console/line_console.h"
#include "study/console/screen_console.h"

namespace foveola::study {
namespace {

std::unique_ptr<Console> lines(bool is_json, LineWriter& output, int input) {
  if (is_json) {
    return std::make_unique<JsonConsole>(output, input);
  }
  return std::make_unique<LineConsole>(output, input);
}

}  // namespace

std::unique_ptr<Console> open_console(bool is_json, LineWriter& output) {
  if (is_json) {
    return lines(is_json, output, STDIN_FILENO);
  }
  if (std::unique_ptr<Console> screen = ScreenConsole::open(output)) {
    return screen;
  }
  output.write("help says what can be typed here.");
  return lines(is_json, output, STDIN_FILENO);
}

std::unique_ptr<Console> open_output(bool is_json, LineWriter& output) {
  constexpr int no_input = -1;
  return lines(is_json, output, no_input);
}

}  // namespace foveola::study
