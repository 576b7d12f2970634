// Text from untrusted files, sanitised so that it can appear in a message.
#pragma once

#include <string>
#include <string_view>

namespace foveola {

/// `text` made printable(), and cut at 120 bytes or before the character that stands there.
std::string sanitised(std::string_view text);

}  // namespace foveola
