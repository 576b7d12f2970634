// The parameters of simulated participants from their files: numbers that say where they are from.
#pragma once

#include <string>
#include <vector>

#include "study/participant/population.h"

namespace foveola::study {

/// A parameter of people, as a file states it.
struct StatedNumber {
  std::string name;  ///< with its table and unit: "decision.integration_s"
  double value = 0.0;
  std::string source;  ///< of the value; begins with "assumed" if it has none
};

struct People {
  std::string name;  ///< the file's, without .toml
  std::string title;
  Population population;
  std::vector<StatedNumber> numbers;  ///< in the order of Population
  std::string toml;                   ///< the file's content, for the record
};

/// name_or_path: the name of a file in data/participants, without .toml, or a path, which has a
/// slash in it or ends with .toml. Throws Error, with file:line:column, for bad TOML, a number that
/// is missing, unknown, out of range or without a source, and a shortest fixation that is longer
/// than the longest.
People read_people(const std::string& name_or_path);

/// The program's own, in alphabetical order.
std::vector<std::string> people_names();

/// The content of a file of the same people, but for the number of this name, whose source says so.
/// Throws Error for a name that there is not and a value out of range.
std::string toml_with_number(const People& people, const std::string& name, double value);

}  // namespace foveola::study
