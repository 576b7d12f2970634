// Decodes data: URIs.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace foveola {

/// Whether `uri` has the scheme "data", in either case.
bool is_data_uri(std::string_view uri);

/// The decoded bytes of a data: URI (RFC 2397), in base64 or percent-encoded. Its type and
/// parameters are ignored, since programs write any. nullopt if it has no comma, or is declared
/// base64 but is not.
std::optional<std::string> bytes_of_data_uri(std::string_view uri);

}  // namespace foveola
