// The published study's Tables 1 and 2, as far as their numbers are at hand.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace foveola::analysis {

struct PublishedBackground {
  std::string question;  ///< The question's id in protocols/koskela2018.toml.
  std::optional<double> mean;
  std::optional<double> standard_deviation;
};

/// A cell of Table 2: the baseline "od" in seconds, the others in per cent of it and percentage
/// points.
struct PublishedTime {
  std::string scene;        ///< The published study's scene.
  std::string counterpart;  ///< Foveola's own scene in its place.
  std::string mark;         ///< "outline" or "material".
  std::string method;
  std::optional<double> mean;
  std::optional<double> standard_deviation;
};

struct PublishedTables {
  std::vector<PublishedBackground> background;
  std::vector<PublishedTime> times;
};

/// Reads table1.csv and table2.csv of `folder`; an empty field is a number that is not at hand.
/// Throws Error if one is missing or malformed.
PublishedTables read_published_tables(const std::filesystem::path& folder);

}  // namespace foveola::analysis
