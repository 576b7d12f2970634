// Plain text in columns.
#pragma once

#include <string>
#include <vector>

namespace foveola::study {

using Row = std::vector<std::string>;

/// Columns as wide as their widest cell, two spaces between them.
std::string aligned(const std::vector<Row>& rows);

}  // namespace foveola::study
