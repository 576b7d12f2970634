// Text as characters: what a byte-wise string of UTF-8 does not know of itself.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace foveola {

/// Appends one character (RFC 3629). Surrogates and numbers beyond U+10FFFF are none: nothing is
/// appended.
void append_character(std::string& text, char32_t character);

/// Nothing happens to an empty text.
void erase_last_character(std::string& text);

/// How many characters (code points) valid UTF-8 has.
std::size_t count_characters(std::string_view text);

/// The text as part of a line of output, for what a file says or is called: line breaks and tabs
/// become spaces, and other characters that a terminal would obey question marks. These are control
/// characters (U+0000 to U+001F, U+007F to U+009F), those that turn the direction of writing, and
/// those without width.
std::string printable(std::string_view text);

/// The text with each such character, but for line feeds and tabs, as a backslash, u and four
/// hexadecimal digits: JSON stays the same JSON.
std::string escaped(std::string_view text);

/// The bytes of the first `characters` of a text, or of all of it if it has fewer.
std::size_t bytes_of_first(std::string_view text, std::size_t characters);

/// The first line of a text, printable, of no more than its first `characters`; " …" behind it if
/// there is more of the text.
std::string beginning_of(std::string_view text, std::size_t characters);

}  // namespace foveola
