// The content of a gzip file, for tests of compressed files.
#pragma once

#include <stdexcept>
#include <string>

#include <zlib.h>

namespace foveola::analysis {

inline std::string gunzip(std::string bytes) {
  z_stream stream{};
  constexpr int gzip_only = 15 + 16;
  if (::inflateInit2(&stream, gzip_only) != Z_OK) {
    throw std::runtime_error("zlib could not start");
  }
  stream.next_in = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_in = static_cast<uInt>(bytes.size());
  std::string text;
  int result = Z_OK;
  while (result == Z_OK) {
    std::string part(4096, '\0');
    stream.next_out = reinterpret_cast<Bytef*>(part.data());
    stream.avail_out = static_cast<uInt>(part.size());
    result = ::inflate(&stream, Z_NO_FLUSH);
    text.append(part, 0, part.size() - stream.avail_out);
  }
  ::inflateEnd(&stream);
  if (result != Z_STREAM_END) {
    throw std::runtime_error("not a whole gzip file");
  }
  return text;
}

}  // namespace foveola::analysis
