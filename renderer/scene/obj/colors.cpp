#include "renderer/scene/obj/colors.h"

#include <array>
#include <charconv>
#include <cstdint>
#include <optional>

#include "renderer/scene/obj/text_lines.h"
#include "renderer/scene/textures/srgb.h"

namespace foveola {
namespace {

/// Colours out of range are kept, for their users to repair.
float linear(float encoded) {
  return encoded >= 0.0F && encoded <= 1.0F ? static_cast<float>(linear_from_srgb(encoded))
                                            : encoded;
}

/// The number in the whole of `word`.
std::optional<float> number_in(std::string_view word) {
  float number = 0.0F;
  const char* const end = word.data() + word.size();
  const auto [rest, failure] = std::from_chars(word.data(), end, number);
  return failure == std::errc() && rest == end ? std::optional(number) : std::nullopt;
}

/// The colour after the three coordinates of a "v" statement; nullopt without three numbers.
std::optional<Rgb> color_after_position(std::string_view coordinates) {
  constexpr std::size_t position_size = 3;
  std::array<float, 6> numbers{};
  Statement left{.keyword = {}, .rest = coordinates};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    left = statement_in(left.rest);
    if (i < position_size) {
      continue;
    }
    const std::optional<float> number = number_in(left.keyword);
    if (!number) {
      return std::nullopt;
    }
    numbers[i] = *number;
  }
  return Rgb(linear(numbers[3]), linear(numbers[4]), linear(numbers[5]));
}

/// The colours of a "#MRGB" comment.
void append_painted(std::string_view digits, std::vector<Rgb>& colors) {
  constexpr std::size_t digits_per_vertex = 8;
  const std::array<float, 256>& linear_from_code = linear_from_byte(true);
  for (; digits.size() >= digits_per_vertex; digits.remove_prefix(digits_per_vertex)) {
    std::uint32_t code = 0;
    const char* const end = digits.data() + digits_per_vertex;
    if (std::from_chars(digits.data(), end, code, 16).ptr != end) {
      return;
    }
    colors.emplace_back(linear_from_code[code >> 16U & 0xFFU], linear_from_code[code >> 8U & 0xFFU],
                        linear_from_code[code & 0xFFU]);
  }
}

}  // namespace

std::vector<Rgb> vertex_colors_in(std::string_view text) {
  std::vector<Rgb> colors;
  std::vector<Rgb> painted;
  std::size_t vertices = 0;
  for_each_line(text, [&](std::string_view line) {
    const Statement statement = statement_in(line);
    if (statement.keyword == "#MRGB") {
      append_painted(statement.rest, painted);
    } else if (statement.keyword == "v") {
      ++vertices;
      if (const std::optional<Rgb> color = color_after_position(statement.rest)) {
        colors.resize(vertices - 1, Rgb(1.0F));
        colors.push_back(*color);
      }
    }
  });
  std::vector<Rgb>& result = colors.empty() ? painted : colors;
  if (!result.empty()) {
    result.resize(vertices, Rgb(1.0F));
  }
  return std::move(result);
}

}  // namespace foveola
