#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/view/foveated_sampler.h"
#include "renderer/view/image_samplers.h"
#include "renderer/view/method_text.h"
#include "renderer/view/mixture_sampler.h"
#include "renderer/view/radial_distribution.h"
#include "renderer/view/view_sampler.h"

namespace foveola {
namespace {

AcuityModel read_acuity(MethodText& method, const std::string& name) {
  if (name == "guenter") {
    return linear_resolution_model(method.number("slope", 0.022, 1e-4, 10.0));
  }
  if (name == "linear") {
    const double inner = method.number("inner", 10.0, 0.0, 170.0);
    const double outer = method.number("outer", 20.0, 0.1, 180.0);
    if (inner >= outer) {
      method.fail("inner is not below outer", "let the acuity fall from inner to outer");
    }
    return linear_fall_off_model(inner, outer, method.number("least", 0.05, 1e-6, 1.0));
  }
  // Weier et al. 2016, from memory: the three settings of their study.
  if (name == "weier1") {
    return linear_fall_off_model(5.0, 10.0, 0.01);
  }
  if (name == "weier2") {
    return linear_fall_off_model(10.0, 20.0, 0.05);
  }
  if (name == "weier3") {
    return linear_fall_off_model(15.0, 30.0, 0.1);
  }
  return reddy_model();
}

std::unique_ptr<ViewSampler> make_foveated(MethodText& method) {
  const std::string acuity =
      method.word("acuity", "reddy", {"reddy", "guenter", "linear", "weier1", "weier2", "weier3"});
  AcuityModel model = read_acuity(method, acuity);
  const double exponent = method.number("exponent", model.default_exponent, 0.01, 10.0);
  const double cutoff_deg = method.number("cutoff", 80.0, 0.1, 179.0);
  const bool is_planar = method.word("measure", "planar", {"planar", "solid-angle"}) == "planar";
  if (acuity == "reddy" && exponent == 1.0 && is_planar) {
    return std::make_unique<FoveatedSampler>(std::make_unique<ReddyDistribution>(cutoff_deg));
  }
  const EccentricityMeasure measure =
      is_planar ? EccentricityMeasure::planar : EccentricityMeasure::solid_angle;
  return std::make_unique<FoveatedSampler>(
      std::make_unique<AcuityDistribution>(std::move(model), exponent, cutoff_deg, measure));
}

std::unique_ptr<ViewSampler> make_crop(MethodText& method) {
  constexpr double full_turn_deg = 360.0;
  constexpr double half_turn_deg = 180.0;
  const double azimuth = method.number("azimuth", 0.0, -half_turn_deg, half_turn_deg);
  const double elevation = method.number("elevation", 0.0, -90.0, 90.0);
  const double width = method.number("width", 30.0, 0.01, full_turn_deg);
  const double height = method.number("height", 30.0, 0.01, half_turn_deg);
  const double u = 0.5 + (azimuth - 0.5 * width) / full_turn_deg;
  const double v = 0.5 - (elevation + 0.5 * height) / half_turn_deg;
  return make_rectangle_sampler({.u_begin = u - std::floor(u),
                                 .width = width / full_turn_deg,
                                 .v_begin = std::max(v, 0.0),
                                 .v_end = std::min(v + height / half_turn_deg, 1.0)});
}

constexpr std::string_view hybrid_prefix = "hybrid:";

/// parts: "WEIGHT*METHOD+WEIGHT*METHOD".
std::unique_ptr<ViewSampler> make_hybrid(std::string_view method) {
  const auto fail = [&](const std::string& what) -> Error {
    return {fmt::format("method '{}'", method), what, "write for instance hybrid:0.9*fv+0.1*od"};
  };
  std::vector<MixtureSampler::Part> parts;
  std::string_view rest = method.substr(hybrid_prefix.size());
  while (!rest.empty()) {
    const std::string_view part = rest.substr(0, rest.find('+'));
    rest.remove_prefix(std::min(part.size() + 1, rest.size()));
    const std::size_t star = part.find('*');
    if (star == std::string_view::npos) {
      throw fail(fmt::format("'{}' is no WEIGHT*METHOD", part));
    }
    double weight = 0.0;
    const auto [stop, failure] = std::from_chars(part.data(), part.data() + star, weight);
    if (failure != std::errc() || stop != part.data() + star || !(weight > 0.0) ||
        !std::isfinite(weight)) {
      throw fail(fmt::format("'{}' is no positive weight", part.substr(0, star)));
    }
    parts.push_back({weight, make_view_sampler(part.substr(star + 1))});
  }
  if (parts.empty()) {
    throw fail("there are no parts");
  }
  return std::make_unique<MixtureSampler>(std::move(parts));
}

std::unique_ptr<ViewSampler> make_plain(MethodText& method) {
  if (method.name() == "od") {
    return make_rectangle_sampler({});
  }
  if (method.name() == "vp") {
    return make_viewport_sampler();
  }
  if (method.name() == "vp-rect") {
    return make_viewport_rectangle_sampler();
  }
  if (method.name() == "fv") {
    return make_foveated(method);
  }
  if (method.name() == "crop") {
    return make_crop(method);
  }
  method.fail("there is no such method", "choose one of od, vp, vp-rect, fv, crop, hybrid:...");
}

}  // namespace

const std::vector<std::string>& published_methods() {
  static const std::vector<std::string> names = {"od", "vp", "fv"};
  return names;
}

std::unique_ptr<ViewSampler> make_view_sampler(std::string_view method) {
  if (method.starts_with(hybrid_prefix)) {
    return make_hybrid(method);
  }
  MethodText text(method);
  std::unique_ptr<ViewSampler> sampler = make_plain(text);
  text.reject_unknown_settings();
  return sampler;
}

}  // namespace foveola
