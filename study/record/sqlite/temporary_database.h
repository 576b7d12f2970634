// New study files beside the names that they will have: there whole, or not at all.
#pragma once

#include <filesystem>
#include <string>

namespace foveola::study {

/// An empty, private file for a database beside its final path, on the same file system. What lies
/// there at the end of the scope goes, and what killed programs have left goes at the beginning:
/// a program that runs has its own locked (flock), on whatever machine it is.
class TemporaryDatabase {
 public:
  /// Throws Error if it cannot be made.
  explicit TemporaryDatabase(const std::filesystem::path& final_path);
  ~TemporaryDatabase();
  TemporaryDatabase(const TemporaryDatabase&) = delete;
  TemporaryDatabase& operator=(const TemporaryDatabase&) = delete;

  const std::filesystem::path& path() const { return path_; }

  /// Takes the place of whatever is at the final path, in one step that is on the disk when this
  /// returns, and whoever could read that can read this. The database must be closed. Throws Error
  /// if it cannot.
  void replace_final() const;

  /// Gives it its name, unless a file of that name is there: that stays. Returns whether there was
  /// none.
  bool take_free_name() const;

 private:
  void sync() const;
  void remove() const;

  std::filesystem::path final_path_;
  std::filesystem::path path_;
  int lock_ = -1;  ///< A descriptor; -1 where the file system has no locks.
};

/// Whether a file of this name is one that a killed program may have left of `final_path`.
bool is_temporary_of(const std::filesystem::path& final_path, const std::string& file_name);

/// Whether it is one of any database.
bool is_temporary(const std::string& file_name);

/// Renames a file, and leaves one that has that name. Returns false if there is one. Throws Error
/// if it cannot.
bool rename_to_free(const std::filesystem::path& from, const std::filesystem::path& to);

/// The current date in UTC for a file's name: "2026-11-21T09-30-00.123Z".
std::string date_in_file_name();

/// The folder that a file is in; "." for a bare name.
std::filesystem::path folder_of(const std::filesystem::path& path);

}  // namespace foveola::study
