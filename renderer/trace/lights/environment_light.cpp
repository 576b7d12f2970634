#include "renderer/trace/lights/environment_light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/base/turns.h"

namespace foveola {
namespace {

constexpr float uniform_sphere_pdf = 0.25F * std::numbers::inv_pi_v<float>;
constexpr float bright_pdf = 16.0F * uniform_sphere_pdf;

/// The second coordinate of map_position().
float map_row(const Environment& environment, const Vec3& direction) {
  const float horizontal = std::sqrt(direction.x * direction.x + direction.z * direction.z);
  const float elevation = turns_of(direction.y, horizontal);
  return (0.5F - 2.0F * elevation) * static_cast<float>(environment.map_height) - 0.5F;
}

/// The map position of a direction in the map's own frame: in texels, from the centre of texel (0,
/// 0); x in [-1/2, W - 1/2], y in [-1/2, H - 1/2].
Vec2 map_position(const Environment& environment, const Vec3& direction) {
  const bool is_pole = direction.x == 0.0F && direction.z == 0.0F;
  const float azimuth = is_pole ? 0.0F : turns_of(direction.x, -direction.z);
  return {(azimuth + 0.5F) * static_cast<float>(environment.map_width) - 0.5F,
          map_row(environment, direction)};
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

/// The sines of the elevations at the borders of the rows of cells, from the top. In double: near
/// the poles floats would differ only in their last digits.
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

/// sine: of the elevation, in double: near the poles its square is nearly 1.
Vec3 direction_at(double azimuth_turns, double sine) {
  const auto horizontal = static_cast<float>(std::sqrt(std::max(0.0, 1.0 - sine * sine)));
  const SineCosine azimuth = sine_cosine_of_turns(static_cast<float>(azimuth_turns));
  return {horizontal * azimuth.sine, static_cast<float>(sine), -horizontal * azimuth.cosine};
}

}  // namespace

EnvironmentLight::EnvironmentLight(const Environment& environment)
    : environment_(environment),
      rotation_cosine_(static_cast<float>(std::cos(environment.rotation_rad))),
      rotation_sine_(static_cast<float>(std::sin(environment.rotation_rad))),
      rotation_turns_(environment.rotation_rad / (2.0 * std::numbers::pi)),
      total_luminance_(4.0 * std::numbers::pi * luminance(environment.radiance)) {
  if (environment.map.empty()) {
    return;
  }
  border_sines_ = border_sines(environment);
  const auto width = static_cast<std::size_t>(environment.map_width);
  const auto rows = static_cast<std::size_t>(environment.map_height) + 1;
  std::vector<float> weights;
  weights.reserve(width * rows);
  float brightest = 0.0F;
  for (std::size_t row = 0; row < rows; ++row) {
    const auto solid_angle = static_cast<float>(cell_solid_angle(row));
    for (std::size_t column = 0; column < width; ++column) {
      const float luminance = mean_luminance(environment, Corners(environment, column, row));
      weights.push_back(solid_angle * luminance);
      brightest = std::max(brightest, luminance);
    }
  }
  for (std::size_t row = 0; row < rows; ++row) {
    cells_per_sr_.push_back(static_cast<float>(1.0 / cell_solid_angle(row)));
  }
  cells_.emplace(width, rows, weights);
  total_luminance_ = cells_->total();
  has_bright_spots_ = brightest > 0.0F && brightest >= bright_pdf * total_luminance_;
}

double EnvironmentLight::cell_solid_angle(std::size_t row) const {
  return (border_sines_[row] - border_sines_[row + 1]) * 2.0 * std::numbers::pi /
         environment_.map_width;
}

Vec3 EnvironmentLight::map_from_world(const Vec3& direction) const {
  return {rotation_cosine_ * direction.x + rotation_sine_ * direction.z, direction.y,
          rotation_cosine_ * direction.z - rotation_sine_ * direction.x};
}

Rgb EnvironmentLight::radiance_in(std::size_t column, std::size_t row, const Vec2& within) const {
  const Corners c(environment_, column, row);
  return environment_.radiance * glm::mix(glm::mix(c.top_left, c.top_right, within.x),
                                          glm::mix(c.bottom_left, c.bottom_right, within.x),
                                          within.y);
}

float EnvironmentLight::pdf_in(std::size_t row, float probability) const {
  return probability * cells_per_sr_[row];
}

DistantLight EnvironmentLight::at(const Vec3& direction) const {
  if (!cells_) {
    return {.radiance = environment_.radiance, .pdf = uniform_sphere_pdf};
  }
  const Cell cell = cell_at(environment_, map_position(environment_, map_from_world(direction)));
  return {.radiance = radiance_in(cell.column, cell.row, cell.within),
          .pdf = pdf_in(cell.row, cells_->probability(cell.column, cell.row))};
}

bool EnvironmentLight::is_bright(const Vec3& direction) const {
  const DistantLight light = at(direction);
  const Rgb& radiance = light.radiance;
  return light.pdf >= bright_pdf && std::min({radiance.r, radiance.g, radiance.b}) > 0.0F;
}

Vec2 EnvironmentLight::place_of(const Vec3& direction) const {
  if (!cells_) {
    const float azimuth = turns_of(direction.x, -direction.z);
    return {azimuth < 0.0F ? azimuth + 1.0F : azimuth, 0.5F - 0.5F * direction.y};
  }
  const Cell cell = cell_at(environment_, map_position(environment_, map_from_world(direction)));
  const double upper = border_sines_[cell.row];
  const double lower = border_sines_[cell.row + 1];
  const auto within_row = static_cast<float>((upper - direction.y) / (upper - lower));
  return cells_->place_of({.column = cell.column,
                           .row = cell.row,
                           .within = {cell.within.x, std::clamp(within_row, 0.0F, 1.0F)}});
}

EnvironmentLight::Sample EnvironmentLight::sample(const Vec2& u) const {
  if (!cells_) {
    return {.direction = direction_at(u.x, 1.0 - 2.0 * u.y),
            .light = {.radiance = environment_.radiance, .pdf = uniform_sphere_pdf}};
  }
  const PiecewiseConstant2D::Point point = cells_->sample(u);
  const double x = static_cast<double>(point.column) + 0.5 + point.within.x;
  const double azimuth = x / environment_.map_width - 0.5 + rotation_turns_;
  const double upper = border_sines_[point.row];
  const double lower = border_sines_[point.row + 1];
  const Vec3 direction = direction_at(azimuth, upper + point.within.y * (lower - upper));
  const Cell cell = cell_at(environment_, {0.0F, map_row(environment_, direction)});
  // point.within is uniform in solid angle, but the radiance is interpolated in elevation.
  const float within_row = cell.row == point.row ? cell.within.y : std::round(point.within.y);
  return {.direction = direction,
          .light = {.radiance = radiance_in(point.column, point.row, {point.within.x, within_row}),
                    .pdf = pdf_in(point.row, point.probability)}};
}

}  // namespace foveola
