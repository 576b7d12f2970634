// What a film holds as one short text, by which a record recognises that a replay is the same.
#pragma once

#include <string>

#include "renderer/film/equirect_film.h"

namespace foveola {

/// The SHA-256, as 64 lower-case hexadecimal digits, of what fell on the film since it was cleared.
///
/// The bytes are the film's width and height, 4 bytes each, and then 32 bytes for each pixel with
/// samples, in the order of their numbers: the number, y * width + x, and the count of its samples,
/// 4 bytes each, and the sums of their red, green and blue, 8 bytes each. Integers are without
/// sign, sums are IEEE 754's double precision, all of them little-endian.
///
/// Neither the number of threads nor how samples were cut into batches changes it, nor whether the
/// film keeps variances.
std::string film_sha256(const EquirectFilm& film);

}  // namespace foveola
