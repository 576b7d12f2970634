// Sanitises text from untrusted files for messages.
#pragma once

#include <string>
#include <string_view>

namespace foveola {

/// `text` made printable(), and cut at 120 bytes, at a character's border.
std::string sanitised(std::string_view text);

}  // namespace foveola
