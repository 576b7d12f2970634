// Keeps tinyobjloader, which takes whatever it cannot read for 0, from making up coordinates.
#pragma once

#include <string>

namespace foveola {

/// The text of an OBJ file with "1e999", which tinyobjloader reads as infinite, in place of each
/// coordinate of a v, vn or vt statement that is not a decimal number, such as "nan", "1.#INF" or
/// "0,5". Coordinates that are left out stay so.
std::string with_infinities_for_no_numbers(std::string text);

}  // namespace foveola
