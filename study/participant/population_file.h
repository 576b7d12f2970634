// Reads the population of simulated participants from its file, in which each number states its
// source.
#pragma once

#include <string>
#include <vector>

#include "study/participant/population.h"

namespace foveola::study {

/// A parameter of people, as stated in a file.
struct StatedNumber {
  std::string name;  ///< With its table and unit: "decision.integration_s".
  double value = 0.0;
  std::string source;  ///< The source of the value; begins with "assumed" if it has none.
};

struct People {
  std::string name;  ///< The file's name without .toml.
  std::string title;
  Population population;
  std::vector<StatedNumber> numbers;  ///< In the order of Population.
  std::string toml;                   ///< The file's content, for the record.
};

/// Reads the file of this name in data/participants, without .toml, or at this path, which contains
/// a slash or ends with .toml. Throws Error, with file:line:column, for bad TOML, a number that is
/// missing, unknown, out of range or without a source, and a minimum fixation longer than the
/// maximum.
People read_people(const std::string& name_or_path);

/// Returns the names of the files in data/participants, in alphabetical order.
std::vector<std::string> people_names();

/// Returns the content of a file of the same people with another value of the named number, whose
/// source says that it was changed. Throws Error for an unknown name and a value out of range.
std::string toml_with_number(const People& people, const std::string& name, double value);

}  // namespace foveola::study
