#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <numeric>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/base/angles.h"
#include "renderer/base/text/similar_word.h"
#include "renderer/base/transformed.h"
#include "renderer/view/foveated_samplers.h"
#include "renderer/view/image_samplers.h"
#include "renderer/view/mask_sampler.h"
#include "renderer/view/method_text.h"
#include "renderer/view/mixture_sampler.h"
#include "renderer/view/radial_distribution.h"
#include "renderer/view/view_sampler.h"
#include "renderer/view/weight_image.h"

namespace foveola {
namespace {

constexpr std::string_view pointer_name = "pointer";

AcuityModel read_linear_fall_off(MethodText& method) {
  const double inner = method.number("inner", 10.0, 0.0, 170.0);
  const double outer = method.number("outer", 20.0, 0.1, 180.0);
  if (inner >= outer) {
    method.fail("inner is not below outer", "give inner < outer");
  }
  return linear_fall_off_model(inner, outer, method.number("least", 0.05, 0.0, 1.0));
}

constexpr std::string_view reddy_name = "reddy";
constexpr std::string_view watson_name = "watson";

/// The models of acuity, each with the reader of its settings.
constexpr auto acuity_models = std::to_array<Word<AcuityModel (*)(MethodText&)>>({
    {reddy_name, [](MethodText&) { return reddy_model(); }},
    {"guenter",
     [](MethodText& method) {
       return linear_resolution_model(method.number("slope", 0.022, 1e-4, 10.0));
     }},
    {"linear", read_linear_fall_off},
    // Weier et al. 2016, the three settings of their study: from memory, unchecked, since the
    // paper's text is not public.
    {"weier1", [](MethodText&) { return linear_fall_off_model(5.0, 10.0, 0.01); }},
    {"weier2", [](MethodText&) { return linear_fall_off_model(10.0, 20.0, 0.05); }},
    {"weier3", [](MethodText&) { return linear_fall_off_model(15.0, 30.0, 0.1); }},
    // Its acuity depends on the meridian, too: WatsonSampler has it.
    {watson_name, [](MethodText&) { return AcuityModel{}; }},
});

constexpr auto eyes =
    std::to_array<Word<Eyes>>({{"left", Eyes::left}, {"right", Eyes::right}, {"both", Eyes::both}});
constexpr auto measures = std::to_array<Word<EccentricityMeasure>>(
    {{"planar", EccentricityMeasure::planar}, {"solid-angle", EccentricityMeasure::solid_angle}});

std::unique_ptr<ViewSampler> make_foveated(MethodText& method) {
  const std::string acuity = method.word("acuity", reddy_name, texts_of(acuity_models));
  AcuityModel model = value_of(acuity_models, acuity)(method);
  const double exponent = method.number("exponent", model.default_exponent, 0.01, 10.0);
  const double cutoff_deg = std::min(method.number("cutoff", 80.0, 0.1, 179.0), model.reach_deg);
  const EccentricityMeasure measure = method.word("measure", "planar", measures);
  if (acuity == watson_name) {
    return std::make_unique<WatsonSampler>(method.word("eye", "both", eyes), exponent, cutoff_deg,
                                           measure);
  }
  if (acuity == reddy_name && exponent == 1.0 && measure == EccentricityMeasure::planar) {
    return std::make_unique<FoveatedSampler>(std::make_unique<ReddyDistribution>(cutoff_deg));
  }
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

/// find_weights: empty to read files.
std::unique_ptr<ViewSampler> make_map(MethodText& method, const FindWeights& find_weights) {
  const std::string file = method.required("file", "the image of the map");
  WeightImage image = find_weights ? find_weights(file) : read_weights(file);
  return std::make_unique<MapSampler>(std::move(image), method.number("extent", 80.0, 0.1, 179.0));
}

/// find_weights: empty to read files.
std::unique_ptr<ViewSampler> make_mask(MethodText& method, const FindWeights& find_weights) {
  const std::string file = method.required("file", "the image of the mask");
  const double floor = method.number("floor", 0.0, 0.0, 1e6);
  if (find_weights) {
    return std::make_unique<MaskSampler>(find_weights(file), floor);
  }
  return std::make_unique<MaskSampler>(std::filesystem::path(file), floor);
}

/// The place in the world where the text fixes the pointer; nullopt if it does not.
std::optional<Vec3> fixed_pointer(MethodText& method) {
  const std::optional<double> azimuth_deg = method.number("azimuth", -180.0, 180.0);
  const std::optional<double> elevation_deg = method.number("elevation", -90.0, 90.0);
  if (!azimuth_deg && !elevation_deg) {
    return std::nullopt;
  }
  return direction_from({.azimuth_rad = radians(azimuth_deg.value_or(0.0)),
                         .elevation_rad = radians(elevation_deg.value_or(0.0))});
}

std::unique_ptr<ViewSampler> make_pointer(MethodText& method) {
  const double radius_deg = method.number("radius", 10.0, 0.01, 180.0);
  const double cutoff_deg = method.number("cutoff", 80.0, 0.1, 179.0);
  return std::make_unique<PointerSampler>(radius_deg, cutoff_deg, fixed_pointer(method));
}

std::unique_ptr<ViewSampler> make_hybrid(std::string_view method, const FindWeights& find_weights) {
  std::vector<MixtureSampler::Part> parts =
      transformed(hybrid_parts(method), [&](const HybridPart& part) {
        return MixtureSampler::Part{part.weight, make_view_sampler(part.method, find_weights)};
      });
  return std::make_unique<MixtureSampler>(std::move(parts));
}

double sum_of_weights(const std::vector<HybridPart>& parts) {
  return std::accumulate(parts.begin(), parts.end(), 0.0,
                         [](double sum, const HybridPart& part) { return sum + part.weight; });
}

struct NamedMaker {
  std::string_view name;
  bool follows_gaze;
  std::unique_ptr<ViewSampler> (*make)(MethodText& settings, const FindWeights& find_weights);
};

constexpr NamedMaker makers[] = {
    {"od", false, [](MethodText&, const FindWeights&) { return make_rectangle_sampler({}); }},
    {"vp", false, [](MethodText&, const FindWeights&) { return make_viewport_sampler(); }},
    {"vp-rect", false,
     [](MethodText&, const FindWeights&) { return make_viewport_rectangle_sampler(); }},
    {"fv", true, [](MethodText& settings, const FindWeights&) { return make_foveated(settings); }},
    {"fv-paper", true,
     [](MethodText&, const FindWeights&) -> std::unique_ptr<ViewSampler> {
       return std::make_unique<FoveatedSampler>(std::make_unique<Equation7Distribution>());
     }},
    {"fv-map", true, make_map},
    {"mask", false, make_mask},
    {pointer_name, false,  // but see follows_pointer()
     [](MethodText& settings, const FindWeights&) { return make_pointer(settings); }},
    {"crop", false, [](MethodText& settings, const FindWeights&) { return make_crop(settings); }},
};

const NamedMaker& maker_of(const MethodText& method) {
  const auto* const found =
      std::find_if(std::begin(makers), std::end(makers),
                   [&](const NamedMaker& maker) { return maker.name == method.name(); });
  if (found == std::end(makers)) {
    std::vector<std::string> names = transformed<std::string>(makers, &NamedMaker::name);
    names.emplace_back("hybrid");
    method.fail("there is no such method",
                did_you_mean(method.name(), names,
                             fmt::format("choose one of {}:...", fmt::join(names, ", "))));
  }
  return *found;
}

}  // namespace

const std::vector<std::string>& published_methods() {
  static const std::vector<std::string> names = {"od", "vp", "fv"};
  return names;
}

std::unique_ptr<ViewSampler> make_view_sampler(std::string_view method) {
  return make_view_sampler(method, {});
}

std::unique_ptr<ViewSampler> make_view_sampler(std::string_view method,
                                               const FindWeights& find_weights) {
  if (is_hybrid(method)) {
    return make_hybrid(method, find_weights);
  }
  MethodText text(method);
  std::unique_ptr<ViewSampler> sampler = maker_of(text).make(text, find_weights);
  text.reject_unknown_settings();
  return sampler;
}

bool follows_pointer(std::string_view method) {
  if (is_hybrid(method)) {
    const std::vector<HybridPart> parts = hybrid_parts(method);
    return std::ranges::any_of(parts,
                               [](const HybridPart& part) { return follows_pointer(part.method); });
  }
  MethodText text(method);
  return text.name() == pointer_name && !fixed_pointer(text);
}

bool follows_gaze(std::string_view method) {
  if (is_hybrid(method)) {
    const std::vector<HybridPart> parts = hybrid_parts(method);
    return std::ranges::any_of(parts,
                               [](const HybridPart& part) { return follows_gaze(part.method); });
  }
  return maker_of(MethodText(method)).follows_gaze || follows_pointer(method);
}

std::vector<std::string> method_notes(std::string_view method) {
  if (!is_hybrid(method)) {
    return {};
  }
  constexpr double tolerance = 1e-6;
  const std::vector<HybridPart> parts = hybrid_parts(method);
  const double sum = sum_of_weights(parts);
  std::vector<std::string> notes;
  if (!(std::abs(sum - 1.0) <= tolerance)) {
    const std::vector<std::string> shares = transformed(parts, [&](const HybridPart& part) {
      return fmt::format("{} {:.4g} %", part.method, 100.0 * (part.weight / sum));
    });
    notes.push_back(
        fmt::format("the weights of '{}' add up to {:.4g}, not to 1: of the samples, {}", method,
                    sum, fmt::join(shares, ", ")));
  }
  for (const HybridPart& part : parts) {
    const std::vector<std::string> inner = method_notes(part.method);
    notes.insert(notes.end(), inner.begin(), inner.end());
  }
  return notes;
}

std::string with_pointer(std::string_view method, const AzimuthElevation& pointer) {
  if (is_hybrid(method)) {
    std::string result;
    const char* copied = method.data();
    for (const HybridPart& part : hybrid_parts(method)) {
      result.append(copied, part.method.data());
      result += with_pointer(part.method, pointer);
      copied = part.method.data() + part.method.size();
    }
    return result.append(copied, method.data() + method.size());
  }
  if (MethodText(method).name() != pointer_name) {
    return std::string(method);
  }
  constexpr double full_turn_deg = 360.0;
  return fmt::format("{}{}azimuth={},elevation={}", method, method == pointer_name ? ":" : ",",
                     std::remainder(degrees(pointer.azimuth_rad), full_turn_deg),
                     degrees(pointer.elevation_rad));
}

}  // namespace foveola
