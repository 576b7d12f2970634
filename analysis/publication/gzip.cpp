#include "analysis/publication/gzip.h"

#include <limits>
#include <stdexcept>

#include <zlib.h>

namespace foveola::analysis {

std::string gzip(std::string_view text) {
  if (text.size() > std::numeric_limits<uInt>::max()) {
    throw std::length_error("a text of 4 GiB and more");
  }
  constexpr int largest_window_with_gzip_header = 15 + 16;
  constexpr int usual_memory = 8;
  z_stream stream{};
  if (::deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, largest_window_with_gzip_header,
                     usual_memory, Z_DEFAULT_STRATEGY) != Z_OK) {
    throw std::runtime_error("zlib could not start");
  }
  std::string bytes(::deflateBound(&stream, static_cast<uLong>(text.size())), '\0');
  // zlib's interface is older than const, and does not write there.
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_out = static_cast<uInt>(bytes.size());
  const int result = ::deflate(&stream, Z_FINISH);
  bytes.resize(stream.total_out);
  ::deflateEnd(&stream);
  if (result != Z_STREAM_END) {
    throw std::runtime_error("zlib could not compress");
  }
  return bytes;
}

}  // namespace foveola::analysis
