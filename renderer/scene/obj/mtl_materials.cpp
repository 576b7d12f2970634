#include "renderer/scene/obj/mtl_materials.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

namespace foveola {
namespace {

namespace fs = std::filesystem;

/// Reads one material.
class MaterialReader {
 public:
  MaterialReader(const MtlMaterial& source, const ObjTextureFinder& find_texture,
                 ObjTextureSet& textures, const std::string& place, Warnings& warnings)
      : source_(source),
        values_(source.values),
        find_texture_(find_texture),
        textures_(textures),
        place_(place),
        warnings_(warnings) {}

  Material read() const {
    Material material = default_obj_material();
    material.name = source_.name;
    if (is_glass()) {
      make_glass(material);
    } else if (is_mirror()) {
      make_mirror(material);
    } else {
      make_surface(material);
    }
    read_emission(material);
    read_normals(material);
    warn_of_what_is_ignored();
    return material;
  }

 private:
  bool has(std::string_view statement) const { return source_.has(statement); }
  bool has_illum(std::initializer_list<int> models) const {
    return has("illum") && std::ranges::find(models, values_.illum) != models.end();
  }

  /// Clamped to a value's range, with a warning if it was outside.
  float limited(float value, float lowest, float highest, const char* statement) const {
    const float result = std::isfinite(value) ? std::clamp(value, lowest, highest) : lowest;
    if (result != value) {
      warnings_.add(fmt::format("{} is clamped to its range", statement), place_);
    }
    return result;
  }
  float fraction(float value, const char* statement) const {
    return limited(value, 0.0F, 1.0F, statement);
  }
  Rgb limited(const float* rgb, float highest, const char* statement) const {
    return {limited(rgb[0], 0.0F, highest, statement), limited(rgb[1], 0.0F, highest, statement),
            limited(rgb[2], 0.0F, highest, statement)};
  }

  /// A texture without its own colour multiplies white.
  Rgb diffuse() const {
    if (!has("Kd")) {
      return Rgb(values_.diffuse_texname.empty() ? 0.0F : 1.0F);
    }
    return limited(values_.diffuse, 1.0F, "Kd");
  }
  /// A factor beside a map: exporters write 0, the value of a socket whose texture counts instead.
  static Rgb factor_beside_map(const Rgb& stated, bool has_map) {
    return has_map && max_component(stated) == 0.0F ? Rgb(1.0F) : stated;
  }
  static float factor_beside_map(float stated, bool has_map) {
    return has_map && stated == 0.0F ? 1.0F : stated;
  }
  Rgb specular() const {
    if (!has("Ks")) {
      return Rgb(values_.specular_texname.empty() ? 0.0F : 1.0F);
    }
    return limited(values_.specular, 1.0F, "Ks");
  }

  bool has_filter() const { return has("Tf") || has("Kt"); }
  bool is_filter_white() const {
    const float* filter = values_.transmittance;
    return !has_filter() || std::min({filter[0], filter[1], filter[2]}) >= 1.0F;
  }

  /// Exporters write illum 4 for opaque materials as well, and an Ni above 1 for curtains.
  bool is_glass() const {
    return has_illum({6, 7, 9}) || (has_illum({4}) && values_.ior > 1.0F &&
                                    (values_.dissolve < 1.0F || !is_filter_white()));
  }

  bool is_mirror() const {
    constexpr float black = 1e-3F;
    return has_illum({3, 5}) && !has("Pm") && max_component(diffuse()) <= black &&
           max_component(specular()) > 0.0F;
  }

  void make_glass(Material& material) const {
    material.base_color = has_filter() ? limited(values_.transmittance, 1.0F, "Tf") : Rgb(1.0F);
    material.roughness = fraction(values_.roughness, "Pr");
    material.transmission = 1.0F;
    material.is_solid = true;
    material.specular = 1.0F;
    read_ior(material);
  }

  void make_mirror(Material& material) const {
    material.base_color = specular();
    material.metallic = 1.0F;
    material.roughness = fraction(values_.roughness, "Pr");
    material.specular = 1.0F;
    read_base_texture(material, values_.specular_texname, values_.specular_texopt);
  }

  void make_surface(Material& material) const {
    material.base_color = factor_beside_map(diffuse(), !values_.diffuse_texname.empty());
    if (has("Pr") || has("Pm") || has("map_Pr") || has("map_Pm")) {
      make_physically_based(material);
    } else {
      read_highlight(material);
    }
    read_layers(material);
    read_base_texture(material, values_.diffuse_texname, values_.diffuse_texopt);
  }

  /// 1 is written where none is meant.
  void read_ior(Material& material) const {
    constexpr float max_ior = 10.0F;
    if (values_.ior > 1.0F) {
      material.ior = limited(values_.ior, 1.0F, max_ior, "Ni");
    }
  }

  void read_highlight(Material& material) const {
    const Rgb reflected = specular();
    const float strength = max_component(reflected);
    if (strength == 0.0F || (has("illum") && values_.illum < 2)) {
      return;
    }
    material.specular = strength;
    material.specular_color = reflected / strength;
    material.specular_color_texture =
        texture_of(values_.specular_texname, values_.specular_texopt, true);
    const float exponent = limited(values_.shininess, 0.0F, 1e6F, "Ns");
    material.roughness = std::pow(2.0F / (exponent + 2.0F), 0.25F);  // whose square is alpha
    read_ior(material);
  }

  void make_physically_based(Material& material) const {
    const ObjTexture texture{.content = ObjTexture::Content::roughness_metallic,
                             .first = file_of(values_.roughness_texname),
                             .second = file_of(values_.metallic_texname)};
    const bool has_roughness = !texture.first.empty();
    const bool has_metallic = !texture.second.empty();
    material.specular = 1.0F;
    material.roughness =
        has("Pr") ? factor_beside_map(fraction(values_.roughness, "Pr"), has_roughness) : 1.0F;
    material.metallic = factor_beside_map(fraction(values_.metallic, "Pm"), has_metallic);
    if (has_roughness || has_metallic) {
      material.metallic_roughness_texture =
          use_of(texture, has_roughness ? values_.roughness_texopt : values_.metallic_texopt);
    }
  }

  void read_layers(Material& material) const {
    constexpr float sheen_roughness = 0.5F;  // the extension has no statement for it
    material.clearcoat = fraction(values_.clearcoat_thickness, "Pc");
    material.clearcoat_roughness = fraction(values_.clearcoat_roughness, "Pcr");
    material.sheen_color =
        Rgb(factor_beside_map(fraction(values_.sheen, "Ps"), !values_.sheen_texname.empty()));
    if (max_component(material.sheen_color) > 0.0F) {
      material.sheen_roughness = sheen_roughness;
      material.sheen_color_texture = texture_of(values_.sheen_texname, values_.sheen_texopt, false);
    }
  }

  /// The base colour's texture, with the alpha that map_d gives it.
  void read_base_texture(Material& material, const std::string& name,
                         const tinyobj::texture_option_t& options) const {
    material.alpha = fraction(values_.dissolve, "d");
    const fs::path mask = file_of(values_.alpha_texname);
    if (mask.empty()) {
      material.alpha_mode = material.alpha < 1.0F ? AlphaMode::blend : AlphaMode::opaque;
      material.base_color_texture = texture_of(name, options, true);
      return;
    }
    material.alpha_mode = AlphaMode::mask;
    material.base_color_texture = use_of({.content = ObjTexture::Content::color_alpha,
                                          .first = file_of(name),
                                          .second = mask,
                                          .is_srgb = options.colorspace != "linear"},
                                         name.empty() ? values_.alpha_texopt : options);
  }

  void read_emission(Material& material) const {
    constexpr float brightest = 1e9F;
    material.emissive_texture = texture_of(values_.emissive_texname, values_.emissive_texopt, true);
    material.emission = factor_beside_map(limited(values_.emission, brightest, "Ke"),
                                          material.emissive_texture.exists());
  }

  /// By norm, or by a coloured bump map, as Blender writes.
  void read_normals(Material& material) const {
    const bool has_norm = !values_.normal_texname.empty();
    const std::string& name = has_norm ? values_.normal_texname : values_.bump_texname;
    const tinyobj::texture_option_t& options =
        has_norm ? values_.normal_texopt : values_.bump_texopt;
    const fs::path file = file_of(name);
    const bool is_used = !file.empty() && (has_norm || has_colors(file));
    if (has_norm || !is_used) {
      warn_of_map(values_.bump_texname, "bump maps in greys are ignored");
    }
    if (!is_used) {
      return;
    }
    material.normal_texture = use_of({.first = file}, options);
    material.normal_scale = limited(options.bump_multiplier, -100.0F, 100.0F, "-bm");
  }

  void warn_of_map(const std::string& name, const char* warning) const {
    if (!name.empty()) {
      warnings_.add(warning, place_);
    }
  }

  void warn_of_what_is_ignored() const {
    const std::array<std::pair<const std::string*, const char*>, 3> ignored = {
        {{&values_.displacement_texname, "displacement maps are ignored"},
         {&values_.reflection_texname, "reflection maps are ignored"},
         {&values_.specular_highlight_texname, "maps of the highlight's exponent are ignored"}}};
    for (const auto& [name, warning] : ignored) {
      warn_of_map(*name, warning);
    }
    warnings_.add("a map that names no file is ignored", place_, source_.maps_without_file);
    for (const std::string& statement : source_.without_numbers) {
      warnings_.add(fmt::format("{} is ignored, for it has no numbers", statement), place_);
    }
    if (source_.has_halo) {
      warnings_.add("-halo is ignored", place_);
    }
    if (values_.anisotropy != 0.0F) {
      warnings_.add("anisotropy is ignored", place_);
    }
  }

  /// Some exporters put a path in quotes.
  fs::path file_of(const std::string& name) const {
    const bool is_quoted = name.size() > 2 && name.front() == '"' && name.back() == '"';
    return name.empty() ? fs::path()
                        : find_texture_(is_quoted ? name.substr(1, name.size() - 2) : name);
  }

  TextureUse texture_of(const std::string& name, const tinyobj::texture_option_t& options,
                        bool is_color) const {
    const fs::path file = file_of(name);
    if (file.empty()) {
      return {};
    }
    return use_of({.first = file, .is_srgb = is_color && options.colorspace != "linear"}, options);
  }

  /// -s scales and -o moves the coordinates of OBJ, whose v runs upwards.
  TextureUse use_of(const ObjTexture& texture, const tinyobj::texture_option_t& options) const {
    const Wrap wrap = options.clamp ? Wrap::clamp_to_edge : Wrap::repeat;
    TextureUse use{.texture = textures_.add(texture, wrap)};
    const float su = options.scale[0];
    const float sv = options.scale[1];
    const float ou = options.origin_offset[0];
    const float ov = options.origin_offset[1];
    if (std::isfinite(su) && std::isfinite(sv) && std::isfinite(ou) && std::isfinite(ov)) {
      use.texture_from_mesh = Mat3x2(su, 0.0F, 0.0F, sv, ou, 1.0F - sv - ov);
    }
    return use;
  }

  const MtlMaterial& source_;
  const tinyobj::material_t& values_;
  const ObjTextureFinder& find_texture_;
  ObjTextureSet& textures_;
  const std::string& place_;
  Warnings& warnings_;
};

}  // namespace

Material default_obj_material() {
  Material material;
  material.name = "default";
  material.specular = 0.0F;
  material.double_sided = true;
  return material;
}

Material material_of(const MtlMaterial& source, const ObjTextureFinder& find_texture,
                     ObjTextureSet& textures, const std::string& place, Warnings& warnings) {
  return MaterialReader(source, find_texture, textures, place, warnings).read();
}

}  // namespace foveola
