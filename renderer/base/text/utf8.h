// Characters of UTF-8 text: counting, cutting and escaping.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace foveola {

/// Appends one character (RFC 3629). Surrogates and numbers beyond U+10FFFF are not characters:
/// nothing is appended.
void append_character(std::string& text, char32_t character);

/// Removes the last character; an empty text stays empty.
void erase_last_character(std::string& text);

/// Number of characters (code points) in valid UTF-8.
std::size_t count_characters(std::string_view text);

/// The text as part of an output line, for names and texts from files. Line breaks and tabs become
/// spaces; other characters that a terminal would obey become question marks. These are control
/// characters (U+0000 to U+001F, U+007F to U+009F), changes of writing direction, and characters
/// without width.
std::string printable(std::string_view text);

/// Replaces each such character, except line feeds and tabs, by a backslash, u and four hexadecimal
/// digits. JSON keeps its meaning.
std::string escaped(std::string_view text);

/// Number of bytes of the first `characters` characters, or of the whole text if it has fewer.
std::size_t bytes_of_first(std::string_view text, std::size_t characters);

/// The first line of a text, printable, cut to `characters` characters. Ends with " …" if anything
/// was cut.
std::string beginning_of(std::string_view text, std::size_t characters);

}  // namespace foveola
