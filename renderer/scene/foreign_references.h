// References as other machines write them: paths that mean nothing here.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "renderer/scene/warnings.h"

namespace foveola {

/// Whether a decoded reference is a path of another machine: absolute, of a drive ("C:\maps"), or
/// of the scheme "file:".
bool is_foreign_reference(std::string_view name);

/// What the decoded reference `name` is looked for as, in the folder of the file that has it: with
/// slashes between folders, and of a path of another machine the name of its file alone.
std::string local_reference(std::string_view name);

/// Warns where files of two folders of another machine have one name, and so become one here.
class ForeignReferences {
 public:
  void add(std::string_view name, Warnings& warnings);

 private:
  std::map<std::string, std::string, std::less<>> foreign_by_local_;
};

}  // namespace foveola
