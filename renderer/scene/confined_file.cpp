#include "renderer/scene/confined_file.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include "renderer/scene/disarmed.h"

namespace foveola {
namespace fs = std::filesystem;
namespace {

std::string percent_decoded(std::string_view uri) {
  std::string decoded;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    unsigned char byte = 0;
    const char* digits = uri.data() + i + 1;
    if (uri[i] == '%' && i + 2 < uri.size() &&
        std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2) {
      decoded += static_cast<char>(byte);
      i += 2;
    } else {
      decoded += uri[i];
    }
  }
  return decoded;
}

/// RFC 3986, section 3.1: a letter, then letters, digits, "+", "-" and ".", up to a colon.
bool has_scheme(std::string_view uri) {
  const std::size_t colon = uri.find(':');
  if (colon == std::string_view::npos || colon == 0) {
    return false;
  }
  const std::string_view scheme = uri.substr(0, colon);
  return std::isalpha(static_cast<unsigned char>(scheme.front())) != 0 &&
         std::all_of(scheme.begin(), scheme.end(), [](unsigned char c) {
           return std::isalnum(c) != 0 || c == '+' || c == '-' || c == '.';
         });
}

bool lies_inside(const fs::path& file, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first ==
         folder.end();
}

}  // namespace

fs::path confined_file(const fs::path& folder, std::string_view uri) {
  const std::string name = percent_decoded(uri);
  const auto refuse = [&](const std::string& why) {
    throw std::runtime_error(fmt::format("refers to \"{}\", {}", disarmed(name), why));
  };
  if (has_scheme(uri)) {
    refuse("which is not a relative path (only data: and relative references are read)");
  }
  const fs::path relative(name);
  if (name.empty() || name.find('\0') != std::string::npos) {
    refuse("which is not the name of a file");
  }
  if (relative.is_absolute()) {
    refuse("which is an absolute path");
  }
  if (std::find(relative.begin(), relative.end(), "..") != relative.end()) {
    refuse("which leads out of the scene's folder");
  }
  std::error_code failure;
  const fs::path home = fs::canonical(folder, failure);
  const fs::path file = fs::canonical(home / relative, failure);
  if (failure) {
    refuse("which does not exist");
  }
  if (!lies_inside(file, home)) {
    refuse("a symbolic link that leads out of the scene's folder");
  }
  if (!fs::is_regular_file(file, failure)) {
    refuse("which is not a regular file");
  }
  return file;
}

}  // namespace foveola
