#include "power_loss_disk.h"

#include <algorithm>
#include <atomic>
#include <iterator>
#include <string_view>

#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/stat.h>
#include <unistd.h>

#include "renderer/base/files/files.h"

namespace fs = std::filesystem;

namespace {

using foveola::study::DiskWatch;

/// The calls say no more than a descriptor, so the one who watches must be known here.
std::atomic<DiskWatch*> watch = nullptr;

int note_sync(int descriptor) {
  if (DiskWatch* const watching = watch) {
    watching->synced(descriptor);
  }
  return 0;
}

ssize_t note_write(int descriptor, const void* bytes, size_t size, off_t offset) {
  const ssize_t done = ::pwrite(descriptor, bytes, size, offset);
  if (DiskWatch* const watching = watch; watching != nullptr && done > 0) {
    watching->written(descriptor, static_cast<std::size_t>(offset),
                      {static_cast<const char*>(bytes), static_cast<std::size_t>(done)});
  }
  return done;
}

int note_resize(int descriptor, off_t size) {
  const int failure = ::ftruncate(descriptor, size);
  if (DiskWatch* const watching = watch; watching != nullptr && failure == 0) {
    watching->resized(descriptor, static_cast<std::size_t>(size));
  }
  return failure;
}

/// SQLite takes it for the system call of this name; null brings back the real one.
void set_system_call(const char* name, sqlite3_syscall_ptr function) {
  sqlite3_vfs* const files = ::sqlite3_vfs_find(nullptr);
  EXPECT_EQ(files->xSetSystemCall(files, name, function), SQLITE_OK) << name;
}

}  // namespace

// SQLite and the record's own code find these before the C library's.
extern "C" int fsync(int file) { return note_sync(file); }
extern "C" int fdatasync(int file) { return note_sync(file); }

namespace foveola::study {
namespace {

bool is_kept(const std::string& name) {
  return !name.ends_with("-shm") && !name.ends_with(".controller");
}

std::string folder_of_name(const std::string& name) {
  return fs::path(name).parent_path().string();
}

std::uint64_t inode_of(const fs::path& path) {
  struct stat about{};
  return ::stat(path.c_str(), &about) == 0 ? about.st_ino : 0;
}

bool happens(double chance, std::mt19937& random) {
  return std::bernoulli_distribution(chance)(random);
}

std::size_t drawn_below(std::size_t end, std::mt19937& random) {
  return std::uniform_int_distribution<std::size_t>(0, end - 1)(random);
}

void write_bytes(std::string& content, std::size_t offset, std::string_view bytes) {
  content.resize(std::max(content.size(), offset + bytes.size()));
  content.replace(offset, bytes.size(), bytes);
}

/// Each sector by itself. A file may have grown by sectors that did not come, which are then empty.
void write_sectors(std::string& content, const Written& write, std::size_t sector_bytes,
                   double kept_share, std::mt19937& random) {
  const std::size_t end = write.offset + write.bytes.size();
  if (happens(kept_share, random)) {
    content.resize(std::max(content.size(), end));
  }
  for (std::size_t at = write.offset; at < end;) {
    const std::size_t next = std::min(end, (at / sector_bytes + 1) * sector_bytes);
    if (happens(kept_share, random)) {
      write_bytes(content, at, std::string_view(write.bytes).substr(at - write.offset, next - at));
    }
    at = next;
  }
}

}  // namespace

DiskWatch::DiskWatch(fs::path folder) : folder_(std::move(folder)) {
  see_names();
  for (const auto& [name, file] : names_) {
    if (!file.is_folder) {
      calls_.emplace_back(Written{file.id, 0, read_file(folder_ / name)});
    }
    calls_.emplace_back(Synced{file.id});
  }
  calls_.emplace_back(Begun{});
  watch = this;
  set_system_call("pwrite64", reinterpret_cast<sqlite3_syscall_ptr>(&note_write));
  set_system_call("ftruncate", reinterpret_cast<sqlite3_syscall_ptr>(&note_resize));
}

DiskWatch::~DiskWatch() {
  set_system_call("pwrite64", nullptr);
  set_system_call("ftruncate", nullptr);
  watch = nullptr;
}

void DiskWatch::acknowledge() {
  const std::lock_guard hold(mutex_);
  see_names();
  calls_.emplace_back(Acknowledged{});
}

std::vector<DiskCall> DiskWatch::calls() {
  const std::lock_guard hold(mutex_);
  see_names();
  return calls_;
}

void DiskWatch::written(int descriptor, std::size_t offset, std::string bytes) {
  const std::lock_guard hold(mutex_);
  see_names();
  if (FileId file = 0; is_watched(descriptor, file)) {
    calls_.emplace_back(Written{file, offset, std::move(bytes)});
  }
}

void DiskWatch::resized(int descriptor, std::size_t size) {
  const std::lock_guard hold(mutex_);
  see_names();
  if (FileId file = 0; is_watched(descriptor, file)) {
    calls_.emplace_back(Resized{file, size});
  }
}

void DiskWatch::synced(int descriptor) {
  const std::lock_guard hold(mutex_);
  see_names();
  if (FileId file = 0; is_watched(descriptor, file)) {
    calls_.emplace_back(Synced{file});
  }
}

/// Nobody says when files are made, renamed and removed; that is seen at the next call.
void DiskWatch::see_names() {
  std::map<std::uint64_t, FileId> inodes;
  Names names;
  const auto see = [&](const std::string& name) {
    const std::uint64_t inode = inode_of(folder_ / name);
    const auto known = inodes_.find(inode);
    inodes[inode] = known != inodes_.end() ? known->second : ++last_;
    names[name] = {.id = inodes[inode], .is_folder = fs::is_directory(folder_ / name)};
  };
  see("");
  for (const auto& entry : fs::recursive_directory_iterator(folder_)) {
    if (const std::string name = entry.path().lexically_relative(folder_); is_kept(name)) {
      see(name);
    }
  }
  inodes_ = std::move(inodes);
  if (names != names_) {
    names_ = std::move(names);
    calls_.emplace_back(Named{names_});
  }
}

bool DiskWatch::is_watched(int descriptor, FileId& file) const {
  struct stat about{};
  if (::fstat(descriptor, &about) != 0) {
    return false;
  }
  const auto known = inodes_.find(about.st_ino);
  if (known == inodes_.end()) {
    return false;
  }
  file = known->second;
  return true;
}

void LosingDisk::go_through(const DiskCall& call) {
  ++calls_;
  if (const auto* write = std::get_if<Written>(&call)) {
    files_[write->file].changes.emplace_back(calls_, *write);
  } else if (const auto* resize = std::get_if<Resized>(&call)) {
    files_[resize->file].changes.emplace_back(calls_, *resize);
  } else if (const auto* sync = std::get_if<Synced>(&call)) {
    const auto named = std::find_if(names_.begin(), names_.end(), [&](const auto& entry) {
      return entry.second.id == sync->file;
    });
    const bool is_folder = named != names_.end() && named->second.is_folder;
    if (is_folder && syncs_ != Syncs::folders_ignored) {
      sync_folder(named->first);
    } else if (!is_folder && syncs_ != Syncs::files_ignored) {
      sync_file(sync->file);
    }
  } else if (const auto* named = std::get_if<Named>(&call)) {
    names_ = named->names;
  }
}

void LosingDisk::sync_file(FileId file) {
  File& content = files_[file];
  std::mt19937 unused;
  content.synced = content_after(content, {.loss = Loss::nothing}, unused);
  content.changes.clear();
}

void LosingDisk::sync_folder(const std::string& folder) {
  const auto is_in_it = [&](const auto& entry) { return folder_of_name(entry.first) == folder; };
  std::erase_if(synced_names_, is_in_it);
  std::copy_if(names_.begin(), names_.end(), std::inserter(synced_names_, synced_names_.end()),
               is_in_it);
}

std::size_t LosingDisk::drawn_call(std::mt19937& random) const {
  std::vector<std::size_t> open_calls;
  for (const auto& [id, file] : files_) {
    for (const auto& [number, change] : file.changes) {
      open_calls.push_back(number);
    }
  }
  return open_calls.empty() ? 0 : open_calls[drawn_below(open_calls.size(), random)];
}

std::map<std::string, std::string> LosingDisk::after(Loss loss, std::mt19937& random) const {
  Fate fate{.loss = loss, .last_call = drawn_call(random)};
  fate.kept_share = std::uniform_real_distribution<double>(0.05, 0.95)(random);
  fate.sector_bytes = happens(0.5, random) ? 512 : 4096;
  std::map<std::string, std::string> contents;
  for (const auto& [name, entry] : names_after(fate, random)) {
    if (!entry.is_folder) {
      const auto file = files_.find(entry.id);
      contents[name] =
          file != files_.end() ? content_after(file->second, fate, random) : std::string();
    }
  }
  return contents;
}

/// Whatever was made, renamed or removed without a sync of its folder may have come to the disk.
Names LosingDisk::names_after(const Fate& fate, std::mt19937& random) const {
  Names all = names_;
  all.insert(synced_names_.begin(), synced_names_.end());
  Names names;
  for (const auto& [name, file] : all) {
    const bool is_new = fate.loss == Loss::nothing ||
                        (fate.loss != Loss::everything && happens(fate.kept_share, random));
    const Names& side = is_new ? names_ : synced_names_;
    const std::string folder = folder_of_name(name);
    const bool has_folder = folder.empty() || names.contains(folder);
    if (const auto found = side.find(name); found != side.end() && has_folder) {
      names.insert(*found);
    }
  }
  return names;
}

std::string LosingDisk::content_after(const File& file, const Fate& fate, std::mt19937& random) {
  std::string content = file.synced;
  for (const auto& [number, change] : file.changes) {
    const bool is_torn =
        fate.loss == Loss::sectors || (fate.loss == Loss::the_last && number == fate.last_call);
    const bool comes = fate.loss == Loss::nothing || is_torn ||
                       (fate.loss == Loss::the_last && number < fate.last_call) ||
                       (fate.loss == Loss::some && happens(fate.kept_share, random));
    const auto* const write = std::get_if<Written>(&change);
    if (write != nullptr && is_torn) {
      write_sectors(content, *write, fate.sector_bytes, fate.kept_share, random);
    } else if (write != nullptr && comes) {
      write_bytes(content, write->offset, write->bytes);
    } else if (write == nullptr && comes && (!is_torn || happens(fate.kept_share, random))) {
      content.resize(std::get<Resized>(change).size);
    }
  }
  return content;
}

}  // namespace foveola::study
