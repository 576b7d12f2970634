#include "renderer/trace/environment_light.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace foveola {
namespace {

constexpr float pi = std::numbers::pi_v<float>;
constexpr float uniform_sphere_pdf = 0.25F * std::numbers::inv_pi_v<float>;

/// Where the map shows a direction, which is in the map's own frame: in texels, counted from the
/// centre of texel (0, 0); x in [-1/2, W - 1/2], y in [-1/2, H - 1/2].
Vec2 map_position(const Environment& environment, const Vec3& direction) {
  const float horizontal = std::sqrt(direction.x * direction.x + direction.z * direction.z);
  const float azimuth = horizontal > 0.0F ? std::atan2(direction.x, -direction.z) : 0.0F;
  const float elevation = std::atan2(direction.y, horizontal);
  return {(azimuth / (2.0F * pi) + 0.5F) * static_cast<float>(environment.map_width) - 0.5F,
          (0.5F - elevation / pi) * static_cast<float>(environment.map_height) - 0.5F};
}

/// The cell between texel centres that holds a position. Its column is that of the texels to its
/// left, its row that of the texels below it: row 0 is the cap above the first centres.
struct Cell {
  std::size_t column;
  std::size_t row;
  Vec2 within;
};

Cell cell_at(const Environment& environment, const Vec2& position) {
  const auto width = static_cast<float>(environment.map_width);
  const float x = position.x < 0.0F ? position.x + width : position.x;
  const float column = std::min(std::floor(x), width - 1.0F);
  const float row =
      std::clamp(std::floor(position.y) + 1.0F, 0.0F, static_cast<float>(environment.map_height));
  return {static_cast<std::size_t>(column), static_cast<std::size_t>(row),
          Vec2(x - column, position.y + 1.0F - row)};
}

/// The texels at a cell's corners: top left, top right, bottom left, bottom right.
struct Corners {
  Rgb top_left, top_right, bottom_left, bottom_right;

  Corners(const Environment& environment, std::size_t column, std::size_t row) {
    const auto width = static_cast<std::size_t>(environment.map_width);
    const auto height = static_cast<std::size_t>(environment.map_height);
    const std::size_t right = column + 1 == width ? 0 : column + 1;
    const std::size_t top = row == 0 ? 0 : row - 1;
    const std::size_t bottom = std::min(row, height - 1);
    top_left = environment.map[top * width + column];
    top_right = environment.map[top * width + right];
    bottom_left = environment.map[bottom * width + column];
    bottom_right = environment.map[bottom * width + right];
  }
};

/// The sines of the elevations that border the rows of cells, from the top. In double: near the
/// poles they differ in their last few digits as floats.
std::vector<double> border_sines(const Environment& environment) {
  std::vector<double> sines;
  for (int row = 0; row <= environment.map_height + 1; ++row) {
    const double v = std::clamp((row - 0.5) / environment.map_height, 0.0, 1.0);
    sines.push_back(std::sin((0.5 - v) * std::numbers::pi));
  }
  return sines;
}

float mean_luminance(const Environment& environment, const Corners& c) {
  const Rgb mean = 0.25F * (c.top_left + c.top_right + c.bottom_left + c.bottom_right);
  const float value = luminance(environment.radiance * mean);
  return std::isfinite(value) ? std::max(value, 0.0F) : 0.0F;
}

Vec3 direction_at(double azimuth, double sine_elevation) {
  const double horizontal = std::sqrt(std::max(0.0, 1.0 - sine_elevation * sine_elevation));
  return {horizontal * std::sin(azimuth), sine_elevation, -horizontal * std::cos(azimuth)};
}

}  // namespace

EnvironmentLight::EnvironmentLight(const Environment& environment)
    : environment_(environment),
      rotation_cosine_(static_cast<float>(std::cos(environment.rotation_rad))),
      rotation_sine_(static_cast<float>(std::sin(environment.rotation_rad))),
      total_luminance_(4.0 * std::numbers::pi * luminance(environment.radiance)) {
  if (environment.map.empty()) {
    return;
  }
  border_sines_ = border_sines(environment);
  const auto width = static_cast<std::size_t>(environment.map_width);
  const auto rows = static_cast<std::size_t>(environment.map_height) + 1;
  std::vector<float> weights;
  weights.reserve(width * rows);
  for (std::size_t row = 0; row < rows; ++row) {
    const auto solid_angle = static_cast<float>(cell_solid_angle(row));
    for (std::size_t column = 0; column < width; ++column) {
      weights.push_back(solid_angle *
                        mean_luminance(environment, Corners(environment, column, row)));
    }
  }
  cells_.emplace(width, rows, weights);
  total_luminance_ = cells_->total();
}

double EnvironmentLight::cell_solid_angle(std::size_t row) const {
  return (border_sines_[row] - border_sines_[row + 1]) * 2.0 * std::numbers::pi /
         environment_.map_width;
}

Vec3 EnvironmentLight::map_from_world(const Vec3& direction) const {
  return {rotation_cosine_ * direction.x + rotation_sine_ * direction.z, direction.y,
          rotation_cosine_ * direction.z - rotation_sine_ * direction.x};
}

Rgb EnvironmentLight::radiance(const Vec3& direction) const {
  if (!cells_) {
    return environment_.radiance;
  }
  const Cell cell = cell_at(environment_, map_position(environment_, map_from_world(direction)));
  const Corners c(environment_, cell.column, cell.row);
  return environment_.radiance * glm::mix(glm::mix(c.top_left, c.top_right, cell.within.x),
                                          glm::mix(c.bottom_left, c.bottom_right, cell.within.x),
                                          cell.within.y);
}

EnvironmentLight::Sample EnvironmentLight::sample(const Vec2& u) const {
  if (!cells_) {
    return {.direction = direction_at(2.0 * std::numbers::pi * u.x, 1.0 - 2.0 * u.y),
            .pdf = uniform_sphere_pdf};
  }
  const PiecewiseConstant2D::Point point = cells_->sample(u);
  const double x = static_cast<double>(point.column) + 0.5 + point.within.x;
  const double azimuth =
      (x / environment_.map_width - 0.5) * 2.0 * std::numbers::pi + environment_.rotation_rad;
  const double upper = border_sines_[point.row];
  const double lower = border_sines_[point.row + 1];
  return {.direction = direction_at(azimuth, upper + point.within.y * (lower - upper)),
          .pdf = static_cast<float>(point.probability / cell_solid_angle(point.row))};
}

float EnvironmentLight::pdf(const Vec3& direction) const {
  if (!cells_) {
    return uniform_sphere_pdf;
  }
  const Cell cell = cell_at(environment_, map_position(environment_, map_from_world(direction)));
  return static_cast<float>(cells_->probability(cell.column, cell.row) /
                            cell_solid_angle(cell.row));
}

}  // namespace foveola
