#include "study/record/sqlite/journal_check.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/files/files.h"
#include "study/record/log/big_endian.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

// https://www.sqlite.org/fileformat2.html, section 3: a header that fills a sector, and then
// records of a page's number, the page as it was, and a checksum. SQLite also cuts the file to the
// number of pages in the header.
constexpr std::string_view journal_magic("\xd9\xd5\x05\xf9\x20\xa1\x63\xd7", 8);
constexpr std::size_t header_size = 28;
constexpr std::size_t number_size = 4;
constexpr std::size_t max_bytes = 1 << 20;

/// The file's versions, which say how it keeps its log; its change counter, and by which SQLite.
bool may_differ(std::size_t offset) {
  return (offset >= 18 && offset < 20) || (offset >= 24 && offset < 28) ||
         (offset >= 92 && offset < 100);
}

bool is_first_page_of(std::string_view page, const std::string& study) {
  for (std::size_t i = 0; i < page.size(); ++i) {
    if (!may_differ(i) && (i >= study.size() || page[i] != study[i])) {
      return false;
    }
  }
  return true;
}

/// Whether SQLite would restore no more than the first page.
bool is_own(std::string_view journal, const std::string& study) {
  if (!journal.starts_with(journal_magic)) {
    return true;  // SQLite plays nothing
  }
  if (journal.size() < header_size) {
    return false;
  }
  const std::size_t sector = big_endian(journal, 20);
  const std::size_t page = big_endian(journal, 24);
  const std::size_t record = number_size + page + number_size;
  if (sector > journal.size() || page > max_bytes || (journal.size() - sector) % record != 0 ||
      big_endian(journal, 16) * page != study.size()) {
    return false;
  }
  for (std::size_t at = sector; at < journal.size(); at += record) {
    if (big_endian(journal, at) != 1 ||
        !is_first_page_of(journal.substr(at + number_size, page), study)) {
      return false;
    }
  }
  return true;
}

}  // namespace

bool has_journal(const fs::path& study) { return fs::exists(study.string() + "-journal"); }

bool has_playable_journal(const fs::path& study) {
  std::ifstream journal(study.string() + "-journal", std::ios::binary);
  std::array<char, journal_magic.size()> beginning{};
  journal.read(beginning.data(), beginning.size());
  return journal && std::ranges::equal(beginning, journal_magic);
}

void require_own_journal(const fs::path& study) {
  if (!has_journal(study)) {
    return;
  }
  const std::string path = study.string() + "-journal";
  const std::string remedy =
      fmt::format("move it to another folder, then run: foveola study verify {}", study.string());
  if (!is_own(read_file(path, max_bytes, remedy), read_file(study))) {
    throw Error(path,
                "is not a journal that Foveola wrote; SQLite would apply it and alter the study",
                remedy);
  }
}

}  // namespace foveola::study
