// Counts the features of a scene file that are not supported, so that each kind is reported once.
#pragma once

#include <cstddef>
#include <string>
#include <unordered_map>
#include <vector>

namespace foveola {

/// Warnings by kind; those with one text are of one kind.
class Warnings {
 public:
  /// what: the text of the kind. where: the place of the first of these `count` cases; may be
  /// empty.
  void add(const std::string& what, const std::string& where = {}, std::size_t count = 1);

  /// Number of cases of all kinds.
  std::size_t count() const { return cases_; }

  /// One line for each kind, in the order of their first occurrence: "WHAT", "WHAT (PLACE)" or
  /// "WHAT (3 times, first at PLACE)".
  std::vector<std::string> lines() const;

 private:
  struct Kind {
    std::string what;
    std::string first_place;
    std::size_t count;
  };
  std::size_t cases_ = 0;
  std::vector<Kind> kinds_;
  std::unordered_map<std::string, std::size_t> index_of_;  ///< index of each kind, by its text
};

}  // namespace foveola
