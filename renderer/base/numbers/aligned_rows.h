// Formats rows of text as aligned columns.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace foveola {

using TextRow = std::vector<std::string>;

struct ColumnLayout {
  std::size_t indent = 0;             ///< spaces before the first column
  std::size_t gap = 2;                ///< spaces between columns
  bool numbers_to_the_right = false;  ///< aligns all columns but the first to the right
};

/// One line per row, columns as wide as their widest cell. Cells are valid UTF-8; printable() is
/// applied to them.
std::string aligned(const std::vector<TextRow>& rows, const ColumnLayout& layout = {});

}  // namespace foveola
