#include "renderer/command_line/shell_text.h"

#include <algorithm>

namespace foveola {

std::string replaced_all(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
  return text;
}

std::string first_clause(const std::string& description) {
  std::size_t end = description.size();
  for (const char* detail : {" (", ": ", "; ", ". "}) {
    end = std::min(end, description.find(detail));
  }
  return description.substr(0, end);
}

}  // namespace foveola
