#include "study/record/sqlite/database_checks.h"

#include <algorithm>
#include <array>
#include <compare>
#include <iterator>
#include <string_view>

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>
#include <sqlite3.h>

#include "renderer/base/error.h"
#include "study/record/log/big_endian.h"
#include "study/record/schema.h"
#include "study/record/setup/simulated_part.h"
#include "study/record/sqlite/damage_remedy.h"
#include "study/record/sqlite/database.h"
#include "study/record/sqlite/open_file.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

/// The first bytes of a database: https://www.sqlite.org/fileformat2.html, section 1.3.
class Header {
 public:
  explicit Header(const OpenFile& file) : is_whole_(file.read(0, bytes_)) {}

  bool is_whole() const { return is_whole_; }
  std::uintmax_t page_size() const {
    const std::uintmax_t size = number_at(16, 2);
    return size == 1 ? 65536 : size;
  }
  /// 0 if whoever wrote the file last did not keep it up.
  std::uintmax_t pages() const { return is_kept_up() ? number_at(28, 4) : 0; }
  bool is_kept_up() const { return number_at(24, 4) == number_at(92, 4); }
  /// The first of the free pages that list the others; 0 if there is none.
  std::uintmax_t first_free_page() const { return number_at(32, 4); }
  bool is_of_a_log() const {
    constexpr std::uintmax_t log_version = 2;
    return number_at(18, 1) == log_version;
  }
  bool is_reserve_empty() const {
    return std::all_of(bytes_.begin() + 72, bytes_.begin() + 92,
                       [](char byte) { return byte == 0; });
  }

 private:
  std::uintmax_t number_at(std::size_t offset, std::size_t size) const {
    return big_endian({bytes_.data(), bytes_.size()}, offset, size);
  }

  std::array<char, 100> bytes_{};
  bool is_whole_;
};

/// Where the file cannot be read, a page is of zeros.
std::string page_at(const OpenFile& file, std::uintmax_t page_size, std::uintmax_t number) {
  std::string page(page_size, '\0');
  file.read((number - 1) * page_size, page);
  return page;
}

/// Whether free pages hold anything but their list: section 1.5 of the same page. A list may have
/// numbers of pages behind its end, which were in it.
bool have_free_pages_content(const OpenFile& file, const Header& header) {
  const std::uintmax_t size = header.page_size();
  const std::uintmax_t pages = file.size() / size;
  std::uintmax_t lists_left = pages;
  for (std::uintmax_t list = header.first_free_page(); list != 0 && lists_left > 0; --lists_left) {
    const std::string page = page_at(file, size, list);
    const std::uintmax_t count = big_endian(page, 4);
    for (std::uintmax_t entry = 0; entry < size / 4 - 2; ++entry) {
      const std::uintmax_t number = big_endian(page, 8 + 4 * entry);
      const bool is_page = number > 0 && number <= pages;
      if (entry < count ? !is_page || page_at(file, size, number) != std::string(size, '\0')
                        : number > pages) {
        return true;
      }
    }
    list = big_endian(page, 0);
  }
  return false;
}

/// With a log beside it, the file's own pages are those of another moment.
bool has_write_ahead_log(SQLite::Database& database) {
  return has_log(::sqlite3_db_filename(database.getHandle(), "main"));
}

struct SchemaObject {
  std::string type;
  std::string name;
  std::string table;
  std::string sql;  ///< empty for an index that goes with its table

  friend auto operator<=>(const SchemaObject&, const SchemaObject&) = default;
};

/// All that a database has, sorted.
std::vector<SchemaObject> objects_of(SQLite::Database& database) {
  std::vector<SchemaObject> objects;
  SQLite::Statement rows(database, "SELECT type, name, tbl_name, sql FROM sqlite_schema");
  while (rows.executeStep()) {
    objects.push_back({.type = rows.getColumn(0).getString(),
                       .name = rows.getColumn(1).getString(),
                       .table = rows.getColumn(2).getString(),
                       .sql = rows.getColumn(3).getString()});
  }
  std::ranges::sort(objects);
  return objects;
}

std::vector<SchemaObject> objects_of_schema(int version) {
  SQLite::Database known(":memory:", SQLite::OPEN_READWRITE);
  known.exec(study_schema(version));
  return objects_of(known);
}

/// What the schema of this study has. SQLite takes longer to make a schema than to open a study.
const std::vector<SchemaObject>& known_objects(SQLite::Database& study) {
  static const std::vector<SchemaObject> current = objects_of_schema(study_schema_version);
  static const std::vector<SchemaObject> oldest = objects_of_schema(oldest_schema_version);
  return schema_version_of(study) == study_schema_version ? current : oldest;
}

/// What is only in the first.
std::vector<SchemaObject> only_in_first(const std::vector<SchemaObject>& of,
                                        const std::vector<SchemaObject>& without) {
  std::vector<SchemaObject> rest;
  std::ranges::set_difference(of, without, std::back_inserter(rest));
  return rest;
}

/// Statistics, which ANALYZE makes in whoever's program: a planner's numbers.
bool is_of_analyze(const SchemaObject& object) {
  constexpr std::string_view name = "sqlite_stat1";
  return object.type == "table" && object.name == name && object.table == name &&
         object.sql == "CREATE TABLE sqlite_stat1(tbl,idx,stat)";
}

/// What the file has beside its schema.
std::vector<SchemaObject> foreign_parts(SQLite::Database& study) {
  const std::vector<SchemaObject>& known = known_objects(study);
  std::vector<SchemaObject> foreign = only_in_first(objects_of(study), known);
  std::erase_if(foreign, [&](const SchemaObject& object) {
    const bool is_of_part = object.type == "table" && object.sql == simulated_part_sql;
    const bool goes_with_foreign_table =
        object.type == "index" && object.sql.empty() &&
        std::ranges::find(known, object.table, &SchemaObject::name) == known.end();
    return goes_with_foreign_table || is_of_part || is_of_analyze(object);
  });
  return foreign;
}

/// "trigger NAME on TABLE"; "view NAME".
std::string object_text(const SchemaObject& object) {
  const std::string name = fmt::format("{} {}", object.type, object.name);
  return object.table == object.name ? name : fmt::format("{} on {}", name, object.table);
}

}  // namespace

void require_schema(SQLite::Database& database, const fs::path& path) {
  const std::vector<SchemaObject> missing =
      only_in_first(known_objects(database), objects_of(database));
  if (!missing.empty()) {
    throw Error(path.string(),
                fmt::format("its {} {} is missing or was changed", missing.front().type,
                            missing.front().name),
                damage_remedy);
  }
}

std::vector<std::string> foreign_objects(SQLite::Database& study) {
  std::vector<std::string> texts;
  for (const SchemaObject& object : foreign_parts(study)) {
    texts.push_back(object_text(object));
  }
  return texts;
}

void require_only_own_effects(SQLite::Database& study, const fs::path& path) {
  for (const SchemaObject& object : foreign_parts(study)) {
    if (object.type != "table" && object.type != "view") {
      throw Error(
          path.string(),
          fmt::format("has the {}, which is not Foveola's and could change what is recorded",
                      object_text(object)),
          fmt::format("remove it (DROP {} in sqlite3), or {}",
                      object.type == "index" ? "INDEX" : "TRIGGER", damage_remedy));
    }
  }
}

std::optional<std::string> statistics_fault(SQLite::Database& study) {
  if (std::ranges::none_of(objects_of(study), is_of_analyze)) {
    return std::nullopt;
  }
  SQLite::Statement odd(study,
                        "SELECT coalesce(tbl, '') || ' ' || coalesce(stat, '') FROM sqlite_stat1"
                        " WHERE NOT EXISTS (SELECT 1 FROM sqlite_schema WHERE tbl_name = tbl"
                        "  AND (idx IS NULL OR (type = 'index' AND name = idx) OR idx = tbl))"
                        " OR stat GLOB '*[^0-9 ]*' OR typeof(stat) <> 'text'");
  return odd.executeStep()
             ? std::optional("its table sqlite_stat1 holds what ANALYZE does not write: " +
                             odd.getColumn(0).getString())
             : std::nullopt;
}

bool is_written_with_log(SQLite::Database& study) {
  return Header(OpenFile::database(study)).is_of_a_log();
}

std::optional<std::string> size_fault(SQLite::Database& database) {
  const OpenFile file = OpenFile::database(database);
  const Header header(file);
  // A log has the pages that a loss of power left half-written in the file.
  if (!header.is_whole() || header.page_size() == 0 || has_write_ahead_log(database)) {
    return std::nullopt;
  }
  const std::uintmax_t size = file.size();
  if (size % header.page_size() != 0) {
    return fmt::format("has {} bytes, which are no whole number of its pages of {} bytes", size,
                       header.page_size());
  }
  if (header.pages() != 0 && size != header.pages() * header.page_size()) {
    return fmt::format("has {} bytes, and its {} pages of {} bytes have {}", size, header.pages(),
                       header.page_size(), header.pages() * header.page_size());
  }
  return std::nullopt;
}

std::optional<std::string> unused_bytes_fault(SQLite::Database& database) {
  const OpenFile file = OpenFile::database(database);
  const Header header(file);
  if (!header.is_whole() || header.page_size() == 0 || has_write_ahead_log(database)) {
    return std::nullopt;
  }
  if (!header.is_reserve_empty() || !header.is_kept_up()) {
    return "its header holds what SQLite does not write";
  }
  return have_free_pages_content(file, header)
             ? std::optional("its free pages hold what no table has")
             : std::nullopt;
}

void require_whole_pages(SQLite::Database& database, const fs::path& path) {
  if (const std::optional<std::string> fault = size_fault(database)) {
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
