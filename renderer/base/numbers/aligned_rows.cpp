#include "renderer/base/numbers/aligned_rows.h"

#include <algorithm>

#include "renderer/base/text/utf8.h"

namespace foveola {
namespace {

std::vector<TextRow> printable_rows(std::vector<TextRow> rows) {
  for (TextRow& row : rows) {
    std::transform(row.begin(), row.end(), row.begin(), printable);
  }
  return rows;
}

}  // namespace

std::string aligned(const std::vector<TextRow>& cells, const ColumnLayout& layout) {
  const std::vector<TextRow> rows = printable_rows(cells);
  std::vector<std::size_t> widths;
  for (const TextRow& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t column = 0; column < row.size(); ++column) {
      widths[column] = std::max(widths[column], count_characters(row[column]));
    }
  }
  std::string text;
  for (const TextRow& row : rows) {
    std::string line;
    for (std::size_t column = 0; column < row.size(); ++column) {
      const std::string filler(widths[column] - count_characters(row[column]), ' ');
      line.append(column == 0 ? layout.indent : layout.gap, ' ');
      line +=
          column > 0 && layout.numbers_to_the_right ? filler + row[column] : row[column] + filler;
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

}  // namespace foveola
