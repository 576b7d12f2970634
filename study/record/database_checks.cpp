#include "study/record/database_checks.h"

#include <array>
#include <fstream>

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include "renderer/base/error.h"
#include "study/record/schema.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

/// The first bytes of a database: https://www.sqlite.org/fileformat2.html, section 1.3.
class Header {
 public:
  explicit Header(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    is_whole_ = static_cast<bool>(
        file.read(reinterpret_cast<char*>(bytes_.data()), std::streamsize(bytes_.size())));
  }

  bool is_whole() const { return is_whole_; }
  std::uintmax_t page_size() const {
    const std::uintmax_t size = number_at(16, 2);
    return size == 1 ? 65536 : size;
  }
  /// 0 if whoever wrote the file last did not keep it up.
  std::uintmax_t pages() const {
    const bool is_kept_up = number_at(24, 4) == number_at(92, 4);
    return is_kept_up ? number_at(28, 4) : 0;
  }

 private:
  /// Big-endian.
  std::uintmax_t number_at(std::size_t offset, std::size_t size) const {
    std::uintmax_t number = 0;
    for (std::size_t i = offset; i < offset + size; ++i) {
      number = number << 8 | bytes_[i];
    }
    return number;
  }

  std::array<unsigned char, 100> bytes_{};
  bool is_whole_ = false;
};

struct SchemaObject {
  std::string type;
  std::string name;
  std::string table;
};

/// What the file has beside its schema, of these types, in SQL. SQLite's own indexes, which have
/// no SQL, go with their tables; its statistics, which ANALYZE makes, are no stranger's.
std::vector<SchemaObject> foreign_objects(SQLite::Database& study, const char* types) {
  SQLite::Database known(":memory:", SQLite::OPEN_READWRITE);
  known.exec(study_schema());
  SQLite::Statement same(known,
                         "SELECT 1 FROM sqlite_schema WHERE type = ? AND name = ? AND tbl_name = ?"
                         " AND sql = ?");
  SQLite::Statement objects(
      study, fmt::format("SELECT type, name, tbl_name, sql FROM sqlite_schema WHERE type IN ({})"
                         " AND sql IS NOT NULL AND name NOT GLOB 'sqlite_stat[1-4]'",
                         types));
  std::vector<SchemaObject> foreign;
  while (objects.executeStep()) {
    same.reset();
    for (int column = 0; column < 4; ++column) {
      same.bind(column + 1, objects.getColumn(column).getString());
    }
    if (!same.executeStep()) {
      foreign.push_back({.type = objects.getColumn(0).getString(),
                         .name = objects.getColumn(1).getString(),
                         .table = objects.getColumn(2).getString()});
    }
  }
  return foreign;
}

/// "trigger NAME on TABLE"; "view NAME".
std::string text_of(const SchemaObject& object) {
  const std::string name = fmt::format("{} {}", object.type, object.name);
  return object.table == object.name ? name : fmt::format("{} on {}", name, object.table);
}

}  // namespace

void require_schema(SQLite::Database& database, const fs::path& path) {
  SQLite::Database known(":memory:", SQLite::OPEN_READWRITE);
  known.exec(study_schema());
  SQLite::Statement objects(known, "SELECT type, name, sql FROM sqlite_schema");
  SQLite::Statement same(database,
                         "SELECT 1 FROM sqlite_schema WHERE type = ? AND name = ? AND sql IS ?");
  while (objects.executeStep()) {
    same.reset();
    same.clearBindings();
    same.bind(1, objects.getColumn(0).getString());
    same.bind(2, objects.getColumn(1).getString());
    if (!objects.isColumnNull(2)) {
      same.bind(3, objects.getColumn(2).getString());
    }
    if (!same.executeStep()) {
      throw Error(path.string(),
                  fmt::format("its {} {} is missing or was changed",
                              objects.getColumn(0).getString(), objects.getColumn(1).getString()),
                  damage_remedy);
    }
  }
}

std::vector<std::string> foreign_objects(SQLite::Database& study) {
  std::vector<std::string> texts;
  for (const SchemaObject& object : foreign_objects(study, "'table', 'view', 'index', 'trigger'")) {
    texts.push_back(text_of(object));
  }
  return texts;
}

void require_only_own_effects(SQLite::Database& study, const fs::path& path) {
  const std::vector<SchemaObject> foreign = foreign_objects(study, "'index', 'trigger'");
  if (!foreign.empty()) {
    const SchemaObject& first = foreign.front();
    throw Error(path.string(),
                fmt::format("has the {}, which is not Foveola's and could change what is recorded",
                            text_of(first)),
                fmt::format("remove it (DROP {} in sqlite3), or restore the file from a copy",
                            first.type == "index" ? "INDEX" : "TRIGGER"));
  }
}

std::optional<std::string> size_fault(const fs::path& path) {
  const Header header(path);
  if (!header.is_whole() || header.page_size() == 0) {
    return std::nullopt;
  }
  const fs::path file = fs::canonical(path);
  const std::uintmax_t size = fs::file_size(file);
  if (size % header.page_size() != 0) {
    return fmt::format("has {} bytes, which are no whole number of its pages of {} bytes", size,
                       header.page_size());
  }
  // With a log beside it, the number of pages may be that of another moment.
  const bool has_log = fs::exists(file.string() + "-wal");
  if (!has_log && header.pages() != 0 && size != header.pages() * header.page_size()) {
    return fmt::format("has {} bytes, and its {} pages of {} bytes have {}", size, header.pages(),
                       header.page_size(), header.pages() * header.page_size());
  }
  return std::nullopt;
}

void require_whole_pages(const fs::path& path) {
  if (const std::optional<std::string> fault = size_fault(path)) {
    throw Error(path.string(), fmt::format("is damaged ({})", *fault), damage_remedy);
  }
}

std::optional<std::string> page_fault(SQLite::Database& database) {
  const std::string finding = database.execAndGet("PRAGMA quick_check(1)").getString();
  return finding == "ok" ? std::nullopt : std::optional(finding);
}

void require_sound(SQLite::Database& database, const fs::path& path) {
  if (const std::optional<std::string> fault = page_fault(database)) {
    throw Error(path.string(), fmt::format("is damaged ({})", *fault), damage_remedy);
  }
}

void require_intact(SQLite::Database& database, const fs::path& path) {
  for (const char* check : {"integrity_check(1)", "foreign_key_check"}) {
    SQLite::Statement findings(database, fmt::format("PRAGMA {}", check));
    if (findings.executeStep() && findings.getColumn(0).getString() != "ok") {
      throw Error(
          path.string(),
          fmt::format("its copy is damaged ({}: {})", check, findings.getColumn(0).getString()),
          "check the disk");
    }
  }
}

}  // namespace foveola::study
