// Getting a file from the web, in pieces if the line is bad.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>

namespace foveola::scenes {

/// Downloads `address` (http or https; redirections are followed) to the end of `file`: what is
/// there already is taken for the beginning, and asked for no more if the server can do that. When
/// it returns, the file has exactly `size_bytes`. Throws Error if there is no such document, if it
/// is of another size, if the connection breaks or nothing comes for half a minute, if the disk is
/// full, or if `stop` is requested; where it makes sense to continue, the file keeps what came, and
/// is empty otherwise.
void download(const std::string& address, const std::filesystem::path& file,
              std::uint64_t size_bytes, const std::function<void(double fraction)>& progress,
              const std::stop_token& stop);

}  // namespace foveola::scenes
