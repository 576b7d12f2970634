// A text file to be written, as a value.
#pragma once

#include <string>

namespace foveola::analysis {

struct TextFile {
  std::string name;
  std::string content;
};

}  // namespace foveola::analysis
