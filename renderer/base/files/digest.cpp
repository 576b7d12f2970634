#include "renderer/base/files/digest.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>
#include <openssl/evp.h>

#include "renderer/base/error.h"
#include "renderer/base/work/work_scope.h"

namespace foveola {
namespace {

void check(int ok) {
  if (ok != 1) {
    throw std::runtime_error("OpenSSL could not compute a SHA-256");
  }
}

}  // namespace

Sha256::Sha256() : context_(EVP_MD_CTX_new(), EVP_MD_CTX_free) {
  check(EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr));
}

void Sha256::update(std::span<const std::byte> bytes) {
  constexpr std::size_t slice = std::size_t{1} << 24;
  while (!bytes.empty()) {
    throw_if_work_stopped();
    const std::size_t count = std::min(slice, bytes.size());
    check(EVP_DigestUpdate(context_.get(), bytes.data(), count));
    bytes = bytes.subspan(count);
  }
}

std::string Sha256::hex() {
  std::array<unsigned char, 32> digest{};
  unsigned length = 0;
  check(EVP_DigestFinal_ex(context_.get(), digest.data(), &length));
  return fmt::format("{:02x}", fmt::join(digest, ""));
}

std::string sha256(std::span<const std::byte> bytes) {
  Sha256 digest;
  digest.update(bytes);
  return digest.hex();
}

std::string sha256(std::string_view text) { return sha256(std::as_bytes(std::span(text))); }

std::string sha256_of_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    throw Error(path.string(), "cannot be read", "check that the file exists and is readable");
  }
  Sha256 digest;
  std::vector<char> block(1 << 16);
  while (file.read(block.data(), static_cast<std::streamsize>(block.size())) || file.gcount() > 0) {
    digest.update(std::as_bytes(std::span(block.data(), static_cast<std::size_t>(file.gcount()))));
  }
  return digest.hex();
}

}  // namespace foveola
