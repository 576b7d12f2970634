// Text as a gzip file (RFC 1952): what BIDS keeps continuous recordings in.
#pragma once

#include <string>
#include <string_view>

namespace foveola::analysis {

/// The whole file. The same text gives the same bytes: it holds no name and no time.
std::string gzip(std::string_view text);

}  // namespace foveola::analysis
