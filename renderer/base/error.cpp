#include "renderer/base/error.h"

#include "renderer/base/text/utf8.h"

namespace foveola {
namespace {

std::string one_line(const std::string& where, const std::string& what, const std::string& remedy) {
  std::string text = where + ": " + what;
  if (!remedy.empty()) {
    text += "; " + remedy;
  }
  return printable(text);
}

}  // namespace

Error::Error(const std::string& where, const std::string& what, const std::string& remedy)
    : std::runtime_error(one_line(where, what, remedy)) {}

}  // namespace foveola
