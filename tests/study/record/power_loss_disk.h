// What a disk may hold after the power was lost.
//
// A DiskWatch writes down, call by call, what a program does to the files of a folder. A LosingDisk
// goes through the calls and says, wherever it stands, what of them may have come to the disk:
// what was synced, and of the rest anything.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <random>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace foveola::study {

/// Of a file or a folder, under whatever name.
using FileId = std::uint64_t;
struct NamedFile {
  FileId id = 0;
  bool is_folder = false;

  friend bool operator==(const NamedFile&, const NamedFile&) = default;
};
/// What lies in a folder, by paths from it on; the folder itself is "".
using Names = std::map<std::string, NamedFile>;

struct Written {
  FileId file = 0;
  std::size_t offset = 0;
  std::string bytes;
};
struct Resized {
  FileId file = 0;
  std::size_t size = 0;
};
/// Of a file: its content. Of a folder: the names in it.
struct Synced {
  FileId file = 0;
};
/// Files were made, renamed or removed.
struct Named {
  Names names;
};
/// The record acknowledged to the program that something is on the disk.
struct Acknowledged {};
/// Whatever comes before was on the disk before anybody watched.
struct Begun {};
using DiskCall = std::variant<Begun, Written, Resized, Synced, Named, Acknowledged>;

/// Writes down what SQLite and the syncs of this process do to a folder, for the length of a scope;
/// there can be one at a time. What is there at its beginning is on the disk. Syncs only are
/// written down and cost nothing. Shared memory (-shm) and locks are left out: they mean nothing
/// once no program runs.
class DiskWatch {
 public:
  explicit DiskWatch(std::filesystem::path folder);
  ~DiskWatch();
  DiskWatch(const DiskWatch&) = delete;
  DiskWatch& operator=(const DiskWatch&) = delete;

  void acknowledge();
  /// So far.
  std::vector<DiskCall> calls();

  // --- For the calls themselves, of any descriptor ---

  void written(int descriptor, std::size_t offset, std::string bytes);
  void resized(int descriptor, std::size_t size);
  void synced(int descriptor);

 private:
  void see_names();
  bool is_watched(int descriptor, FileId& file) const;

  std::filesystem::path folder_;
  std::mutex mutex_;
  std::map<std::uint64_t, FileId> inodes_;
  Names names_;
  FileId last_ = 0;
  std::vector<DiskCall> calls_;
};

/// Which syncs a disk keeps to.
enum class Syncs { kept, files_ignored, folders_ignored };

/// What becomes of the calls that were not synced.
enum class Loss {
  nothing,     ///< all of them came to the disk
  everything,  ///< none
  the_last,    ///< all until one that is torn
  some,        ///< each by itself, whole or not, in any order
  sectors,     ///< each sector of each, of 512 or 4096 bytes
};
inline constexpr Loss all_losses[] = {Loss::nothing, Loss::everything, Loss::the_last, Loss::some,
                                      Loss::sectors};

/// A disk that stands at a moment between two calls.
class LosingDisk {
 public:
  explicit LosingDisk(Syncs syncs = Syncs::kept) : syncs_(syncs) {}

  /// Goes on by one call.
  void go_through(const DiskCall& call);

  /// The content of the files that are there once the power is back, by their paths.
  std::map<std::string, std::string> after(Loss loss, std::mt19937& random) const;

 private:
  using Change = std::variant<Written, Resized>;
  struct File {
    std::string synced;
    std::vector<std::pair<std::size_t, Change>> changes;  ///< since; with the number of the call
  };
  /// How a loss goes: what of the calls comes to the disk.
  struct Fate {
    Loss loss = Loss::nothing;
    std::size_t last_call = 0;
    double kept_share = 0.5;
    std::size_t sector_bytes = 512;
  };

  void sync_file(FileId file);
  void sync_folder(const std::string& folder);
  std::size_t drawn_call(std::mt19937& random) const;
  Names names_after(const Fate& fate, std::mt19937& random) const;
  static std::string content_after(const File& file, const Fate& fate, std::mt19937& random);

  Syncs syncs_;
  std::size_t calls_ = 0;
  std::map<FileId, File> files_;
  Names names_;         ///< as the program sees them
  Names synced_names_;  ///< as they are on the disk
};

}  // namespace foveola::study
