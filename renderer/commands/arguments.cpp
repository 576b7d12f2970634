#include "renderer/commands/arguments.h"

#include <algorithm>
#include <charconv>
#include <vector>

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/view/view_sampler.h"

namespace foveola {
namespace {

template <typename Number>
std::optional<Number> parse_number(std::string_view text) {
  Number value{};
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failure != std::errc() || end != text.data() + text.size()) {
    return std::nullopt;
  }
  return value;
}

/// The numbers between `separator`s; nullopt unless there are exactly `count`.
template <typename Number>
std::vector<Number> parse_numbers(std::string_view text, char separator, std::size_t count) {
  std::vector<Number> numbers;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    const std::optional<Number> number = parse_number<Number>(text.substr(begin, end - begin));
    if (!number) {
      return {};
    }
    numbers.push_back(*number);
    begin = end + 1;
  }
  return numbers.size() == count ? numbers : std::vector<Number>{};
}

std::vector<double> parse_finite(std::string_view text, std::size_t count) {
  std::vector<double> numbers = parse_numbers<double>(text, ',', count);
  for (const double number : numbers) {
    if (!std::isfinite(static_cast<float>(number))) {
      return {};
    }
  }
  return numbers;
}

}  // namespace

std::optional<double> parse_finite_number(std::string_view text) {
  const std::vector<double> numbers = parse_finite(text, 1);
  return numbers.empty() ? std::nullopt : std::optional(numbers.front());
}

std::string size_text(const IVec2& size) { return fmt::format("{}x{}", size.x, size.y); }

IVec2 parse_size(const std::string& option, const std::string& text) {
  const std::vector<int> size = parse_numbers<int>(text, 'x', 2);
  constexpr int limit = 65536;
  if (size.empty() || size[0] < 1 || size[1] < 1 || size[0] > limit || size[1] > limit) {
    throw UsageError(option, fmt::format("'{}' is not an image size", text),
                     fmt::format("give WIDTHxHEIGHT in pixels, each from 1 to {}", limit));
  }
  return {size[0], size[1]};
}

FieldsOfView parse_fields_of_view(const std::string& option, const std::string& text) {
  const bool has_both = text.find('x') != std::string::npos;
  const std::vector<double> degrees = parse_numbers<double>(text, 'x', has_both ? 2 : 1);
  const bool is_seen =
      std::ranges::all_of(degrees, [](double angle) { return angle > 0.0 && angle < 180.0; });
  if (degrees.empty() || !is_seen) {
    throw UsageError(option, fmt::format("'{}' is not a field of view", text),
                     "give degrees between 0 and 180, or WIDTHxHEIGHT");
  }
  return {.horizontal_deg = degrees[0],
          .vertical_deg = has_both ? std::optional(degrees[1]) : std::nullopt};
}

RadialLens parse_lens(const std::string& option, const std::string& text) {
  const std::vector<double> values = parse_finite(text, 4);
  if (values.empty() || values[0] < 0.0 || values[0] > 1.0 || values[1] < 0.0 || values[1] > 1.0) {
    throw UsageError(option, fmt::format("'{}' is not a lens", text),
                     "give AXIS_X,AXIS_Y,K1,K2, the axis from 0,0 (top left) to 1,1");
  }
  return {.axis = {static_cast<float>(values[0]), static_cast<float>(values[1])},
          .k1 = static_cast<float>(values[2]),
          .k2 = static_cast<float>(values[3])};
}

DVec3 parse_vec3(const std::string& option, const std::string& text) {
  const std::vector<double> values = parse_finite(text, 3);
  if (values.empty()) {
    throw UsageError(option, fmt::format("'{}' is not three numbers", text),
                     "give x,y,z without spaces");
  }
  return {values[0], values[1], values[2]};
}

SunAndSky parse_sky(const std::string& option, const std::string& text) {
  SunAndSky sky;
  std::string sun = text;
  if (std::ranges::count(text, ',') == 2) {
    const std::size_t comma = text.rfind(',');
    const std::vector<double> turbidity = parse_finite(std::string_view(text).substr(comma + 1), 1);
    if (turbidity.empty()) {
      throw UsageError(option, fmt::format("'{}' is not a sky", text),
                       "give sky:azimuth,elevation,turbidity");
    }
    sky.turbidity = turbidity[0];
    sun.resize(comma);
  }
  sky.sun = parse_azimuth_elevation(option, sun);
  return sky;
}

SampleAddress parse_sample(const std::string& option, const std::string& text) {
  const std::vector<std::uint32_t> values = parse_numbers<std::uint32_t>(text, ',', 3);
  constexpr std::uint32_t largest = 65535;
  if (values.empty() || values[0] > largest || values[1] > largest) {
    throw UsageError(option, fmt::format("'{}' is not a sample of an image", text),
                     "give x,y,sample as render lists them");
  }
  return {.pixel = {values[0], values[1]}, .sample_number = values[2]};
}

AzimuthElevation parse_azimuth_elevation(const std::string& option, const std::string& text) {
  const std::vector<double> angles_deg = parse_finite(text, 2);
  if (angles_deg.empty() || std::abs(angles_deg[1]) > 90.0) {
    throw UsageError(option, fmt::format("'{}' is not a direction", text),
                     "give azimuth,elevation in degrees, elevation from -90 to 90");
  }
  return {.azimuth_rad = radians(angles_deg[0]), .elevation_rad = radians(angles_deg[1])};
}

void require_method(const std::string& method) {
  try {
    make_view_sampler(method);
  } catch (const Error& error) {
    throw UsageError("--method", error.what());
  }
}

}  // namespace foveola
