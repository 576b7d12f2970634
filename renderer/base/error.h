// The one exception for everything a user can get wrong.
#pragma once

#include <stdexcept>
#include <string>

namespace foveola {

/// A user's error. Its text is one line, "WHERE: WHAT; WHAT TO DO", which the command line prints
/// after "foveola: error: " before it exits with 1.
class Error : public std::runtime_error {
 public:
  /// where: a file, file:line:column, option or record. what: what is wrong with it. remedy: what
  /// the user can do about it; may be empty. Line breaks and tabs inside the parts become spaces,
  /// and other control characters, which a terminal would obey, question marks.
  Error(const std::string& where, const std::string& what, const std::string& remedy = {});
};

/// A command line that makes no sense by itself (as opposed to a file that is bad): exit code 2.
class UsageError : public Error {
 public:
  using Error::Error;
};

}  // namespace foveola
