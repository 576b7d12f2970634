// TOML files: finding, reading and parsing them, from strangers too.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <toml++/toml.h>

namespace foveola {

/// The content of a TOML file, which is still to be parsed. Throws Error as read_file() does, and
/// for a file of over four million bytes, of which no more are read.
std::string read_toml_file(const std::filesystem::path& path);

/// Throws Error with the place of what is no TOML, of a key of over 16 parts, of lists or tables
/// nested over 16 deep, or if the text has over four million bytes: files are untrusted.
toml::table parse_toml(const std::string& file, const std::string& text, const std::string& remedy);

/// The names of the TOML files in one of Foveola's own folders, without .toml, in alphabetical
/// order. Throws Error if it cannot be read.
std::vector<std::string> toml_names_in(const std::filesystem::path& folder);

/// The same; none where there is no such folder.
std::vector<std::string> toml_names_if_any(const std::filesystem::path& folder);

/// "FILE:LINE:COLUMN" of a place in a TOML file.
std::string place_of(const std::string& file, const toml::source_region& source);

}  // namespace foveola
