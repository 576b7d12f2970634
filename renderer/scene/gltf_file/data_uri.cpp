#include "renderer/scene/gltf_file/data_uri.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <utility>

#include "renderer/scene/references.h"

namespace foveola {
namespace {

constexpr std::string_view scheme = "data:";
constexpr std::string_view base64_marker = ";base64";

bool is_same_letter(char a, char b) {
  return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
}

bool ends_with_marker(std::string_view type) {
  return type.size() >= base64_marker.size() &&
         std::equal(base64_marker.rbegin(), base64_marker.rend(), type.rbegin(), is_same_letter);
}

constexpr std::uint8_t no_digit = 64;

/// The value of each character in base64 (RFC 4648, section 4).
constexpr std::array<std::uint8_t, 256> base64_values() {
  constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::array<std::uint8_t, 256> values{};
  values.fill(no_digit);
  for (std::size_t i = 0; i < digits.size(); ++i) {
    values[static_cast<unsigned char>(digits[i])] = static_cast<std::uint8_t>(i);
  }
  return values;
}

std::optional<std::string> decoded_base64(std::string_view text) {
  static constexpr std::array<std::uint8_t, 256> values = base64_values();
  const std::size_t end = text.find_last_not_of("= \r\n") + 1;  // npos + 1 is 0
  std::string bytes;
  bytes.reserve(end / 4 * 3 + 2);
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text.substr(0, end)) {
    const std::uint8_t value = values[static_cast<unsigned char>(c)];
    if (value == no_digit) {
      return std::nullopt;
    }
    bits = bits << 6U | value;
    count += 6;
    if (count >= 8) {
      count -= 8;
      bytes += static_cast<char>(bits >> static_cast<unsigned>(count) & 0xFFU);
    }
  }
  return bytes;
}

}  // namespace

bool is_data_uri(std::string_view uri) {
  return uri.size() >= scheme.size() &&
         std::equal(scheme.begin(), scheme.end(), uri.begin(), is_same_letter);
}

std::optional<std::string> bytes_of_data_uri(std::string_view uri) {
  const std::size_t comma = uri.find(',');
  if (!is_data_uri(uri) || comma == std::string_view::npos) {
    return std::nullopt;
  }
  const std::string_view data = uri.substr(comma + 1);
  const bool is_base64 = ends_with_marker(uri.substr(0, comma));
  if (is_base64 && data.find('%') == std::string_view::npos) {
    return decoded_base64(data);
  }
  std::string bytes = percent_decoded(data);
  return is_base64 ? decoded_base64(bytes) : std::move(bytes);
}

}  // namespace foveola
