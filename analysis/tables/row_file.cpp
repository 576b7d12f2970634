#include "analysis/tables/row_file.h"

#include <utility>

#include "analysis/tables/table_formats.h"
#include "renderer/base/error.h"
#include "renderer/base/files/files.h"

namespace foveola::analysis {

RowFile::RowFile(std::filesystem::path path, const std::vector<Column>& columns, CsvTexts texts)
    : path_(std::move(path)), texts_(texts), text_(csv_heading(columns)) {
  std::filesystem::create_directories(path_.parent_path());
  stream_.open(path_, std::ios::binary);
}

void RowFile::add(const Row& row) {
  constexpr std::size_t max_bytes = 1 << 20;
  text_ += csv_row(row, texts_);
  if (text_.size() > max_bytes) {
    flush();
  }
}

void RowFile::close() {
  flush();
  stream_.close();
  if (!stream_) {
    throw Error(path_.string(), "cannot be written", "free space on the disk, or choose another");
  }
  sync_to_disk(path_);
}

void RowFile::flush() {
  stream_.write(text_.data(), static_cast<std::streamsize>(text_.size()));
  text_.clear();
}

}  // namespace foveola::analysis
