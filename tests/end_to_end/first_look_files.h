// Scene files as people have them, without a camera or without light, for tests of the first look.
#pragma once

#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace foveola::test {

struct FirstLookFile {
  std::string name;
  std::string file_name;                 ///< its ending says the format
  std::function<std::string()> content;  ///< made when it is asked for: each case is a process
  bool has_light = false;
  bool is_empty = false;     ///< nothing to show
  bool is_enclosed = false;  ///< no light enters from around
  /// The share of the picture that what is shown has to cover.
  double least_covered = 0.1;
  double most_covered = 0.9;
};

/// By its name, in messages of tests.
inline void PrintTo(const FirstLookFile& file, std::ostream* stream) { *stream << file.name; }

/// Twelve of them: an open mesh with an inside, a head, a closed room, one without a ceiling,
/// terrain, a table-top, a single triangle, a thing modelled in millimetres, two things far apart,
/// lights without a camera, a camera without lights, and an empty file.
std::vector<FirstLookFile> first_look_files();

}  // namespace foveola::test
