// Downloads a file from the web, in pieces if the connection breaks.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>

namespace foveola::scenes {

/// Downloads `address` (http or https; redirections are followed) to the end of `file`. Existing
/// content is taken for the beginning, and not requested again if the server can continue. On
/// return, the file has exactly `size_bytes`. Throws Error if there is no such document, if it is
/// of another size, if the connection breaks or stalls for half a minute, if the disk is full, or
/// if `stop` is requested. If continuing is possible, the file keeps its content; else it is
/// emptied.
void download(const std::string& address, const std::filesystem::path& file,
              std::uint64_t size_bytes, const std::function<void(double fraction)>& progress,
              const std::stop_token& stop);

}  // namespace foveola::scenes
