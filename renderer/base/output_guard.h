// No output is an input: refuses to read the files that a command is to write.
#pragma once

#include <filesystem>
#include <string>

#include "renderer/base/error.h"

namespace foveola {

class OutputIsInput : public Error {
 public:
  using Error::Error;
};

/// From now on the file that `path` names, if it is there, is refused by require_no_output(),
/// whatever other name it has. option: the one that names it, "--output". To be called before there
/// are other threads.
void guard_output(const std::string& option, const std::filesystem::path& path);

/// To be called where a command opens an input. Throws OutputIsInput for a guarded file. A file
/// that has taken its place since, which the command wrote, may be read.
void require_no_output(const std::filesystem::path& input);

}  // namespace foveola
