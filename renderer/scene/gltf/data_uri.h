// The bytes that a data: URI holds in itself, whatever type it gives them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace foveola {

/// Whether `uri` has the scheme "data", in letters of either case.
bool is_data_uri(std::string_view uri);

/// The decoded bytes of a data: URI (RFC 2397), in base64 or percent-encoded. Its type and the
/// type's parameters are not looked at: programs write any. Nothing if it has no comma or is no
/// base64 where it says so.
std::optional<std::string> bytes_of_data_uri(std::string_view uri);

}  // namespace foveola
