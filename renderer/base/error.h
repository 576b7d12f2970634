// Exceptions for errors that a user can mend.
#pragma once

#include <stdexcept>
#include <string>

namespace foveola {

/// A user's error. Its text is one line, "WHERE: WHAT; WHAT TO DO", which the command line prints
/// after "foveola: error: " before it exits with 1.
class Error : public std::runtime_error {
 public:
  /// where: a file, file:line:column, option or record. what: the fault. remedy: the user's remedy;
  /// may be empty. Line breaks and tabs in the parts become spaces. Other control characters, which
  /// a terminal would obey, become question marks.
  Error(const std::string& where, const std::string& what, const std::string& remedy = {});
};

/// A command line that makes no sense by itself (unlike a bad file): exit code 2.
class UsageError : public Error {
 public:
  using Error::Error;
};

}  // namespace foveola
