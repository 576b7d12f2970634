// Finds, reads and parses TOML files, which are untrusted.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <toml++/toml.h>

namespace foveola {

/// Returns the unparsed content of a TOML file. Throws Error as read_file() does, and for a file of
/// over four million bytes, after reading no more than that.
std::string read_toml_file(const std::filesystem::path& path);

/// Parses `text`. Throws Error with the place of a syntax error, of a key of over 16 parts, or of
/// lists or tables nested over 16 deep. Throws Error if the text has over four million bytes. file:
/// its name in errors. remedy: their text after the fault.
toml::table parse_toml(const std::string& file, const std::string& text, const std::string& remedy);

/// Returns the names of the TOML files in one of Foveola's own folders, without .toml, in
/// alphabetical order. Throws Error if it cannot be read.
std::vector<std::string> toml_names_in(const std::filesystem::path& folder);

/// As toml_names_in; returns an empty list if the folder does not exist.
std::vector<std::string> toml_names_or_none(const std::filesystem::path& folder);

/// Returns "FILE:LINE:COLUMN" of a place in a TOML file.
std::string place_of(const std::string& file, const toml::source_region& source);

}  // namespace foveola
