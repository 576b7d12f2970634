#include "renderer/scene/obj/mtl_file.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <sstream>

#include <fmt/format.h>

#include "renderer/scene/obj/text_lines.h"

namespace foveola {
namespace {

constexpr std::size_t largest_library = std::size_t{1} << 26;

/// An option of a map, and the default of an argument that may be omitted.
struct MapOption {
  std::string_view name;
  int arguments;
  std::string_view absent;  ///< empty: all arguments are required
};

constexpr std::array<MapOption, 13> map_options = {{{"-o", 3, "0"},
                                                    {"-s", 3, "1"},
                                                    {"-t", 3, "0"},
                                                    {"-mm", 2, ""},
                                                    {"-bm", 1, ""},
                                                    {"-blendu", 1, ""},
                                                    {"-blendv", 1, ""},
                                                    {"-boost", 1, ""},
                                                    {"-clamp", 1, ""},
                                                    {"-colorspace", 1, ""},
                                                    {"-imfchan", 1, ""},
                                                    {"-texres", 1, ""},
                                                    {"-type", 1, ""}}};

/// The arguments of a map.
struct Map {
  std::string options;  ///< with all of their arguments
  std::string_view file;
};

/// tinyobjloader takes three words after -o, -s and -t, whether numbers or the file's name.
Map map_in(std::string_view text) {
  Map map{.options = {}, .file = text};
  for (;;) {
    const Statement first = statement_in(map.file);
    const auto* const option = std::ranges::find(map_options, first.keyword, &MapOption::name);
    if (option == map_options.end()) {
      return map;
    }
    map.options.append(option->name).append(" ");
    map.file = first.rest;
    for (int i = 0; i < option->arguments; ++i) {
      const Statement next = statement_in(map.file);
      const bool is_there = option->absent.empty() || is_number(next.keyword);
      map.options.append(is_there ? next.keyword : option->absent).append(" ");
      map.file = is_there ? next.rest : map.file;
    }
  }
}

bool is_map(std::string_view keyword) {
  return keyword.starts_with("map_") || keyword == "bump" || keyword == "disp" ||
         keyword == "norm" || keyword == "refl";
}

constexpr std::array<std::string_view, 6> colours = {"Ka", "Kd", "Ke", "Ks", "Kt", "Tf"};
constexpr std::array<std::string_view, 12> single_numbers = {
    "Ni", "Ns", "Pc", "Pcr", "Pm", "Pr", "Ps", "Tr", "aniso", "anisor", "d", "illum"};

/// Number of numbers of a statement; 0 for statements without numbers.
std::size_t numbers_of(std::string_view keyword) {
  const auto is_in = [&](const auto& keywords) {
    return std::ranges::find(keywords, keyword) != keywords.end();
  };
  return is_in(colours) ? 3 : is_in(single_numbers) ? 1 : 0;
}

/// The `count` numbers at the beginning of `text`, in tinyobjloader's form; nullopt if one is not a
/// number. A colour's second and third number default to its first.
std::optional<std::string> numbers_in(std::string_view text, std::size_t count) {
  const std::string_view first = statement_in(text).keyword;
  std::string numbers;
  for (std::size_t i = 0; i < count; ++i) {
    const Statement next = statement_in(text);
    const bool is_left_out = next.keyword.empty() || next.keyword.front() == '#';
    const std::string_view number = is_left_out ? first : next.keyword;
    if (!is_number(number)) {
      return std::nullopt;
    }
    numbers.append(" ").append(number);
    text = is_left_out ? std::string_view() : next.rest;
  }
  return numbers;
}

tinyobj::material_t values_in(const std::string& lines) {
  std::map<std::string, int> indices;
  std::vector<tinyobj::material_t> materials;
  std::istringstream stream(lines);
  std::string ignored;
  tinyobj::LoadMtl(&indices, &materials, &stream, &ignored, &ignored);
  return materials.at(0);
}

/// The statement in a form that tinyobjloader reads correctly; nullopt if it must be left out, as
/// `material` then records.
std::optional<std::string> readable(const Statement& statement, MtlMaterial& material) {
  if (is_map(statement.keyword)) {
    const Map map = map_in(statement.rest);
    if (map.file.empty()) {
      ++material.maps_without_file;
      return std::nullopt;
    }
    return fmt::format("{} {}{}", statement.keyword, map.options, map.file);
  }
  const std::size_t count = numbers_of(statement.keyword);
  if (count == 0) {
    return fmt::format("{} {}", statement.keyword, statement.rest);
  }
  const Statement halo = statement_in(statement.rest);
  const bool has_halo = statement.keyword == "d" && halo.keyword == "-halo";
  const auto numbers = numbers_in(has_halo ? halo.rest : statement.rest, count);
  if (!numbers) {
    material.without_numbers.emplace(statement.keyword);
    return std::nullopt;
  }
  material.has_halo = material.has_halo || has_halo;
  return fmt::format("{}{}", statement.keyword, *numbers);
}

/// One material's lines, which begin with its "newmtl".
MtlMaterial material_in(const std::string& lines) {
  MtlMaterial material;
  std::string readable_lines;
  for_each_line(lines, [&](std::string_view line) {
    Statement statement = statement_in(line);
    if (statement.keyword == "map_Kn") {
      statement.keyword = "norm";  // as Assimp reads it
    }
    const auto readable_line = readable(statement, material);
    if (!readable_line) {
      return;
    }
    readable_lines.append(*readable_line).append("\n");
    if (statement.keyword == "newmtl") {
      material.name = statement.rest;
    } else {
      material.statements.emplace(statement.keyword);
    }
  });
  material.values = values_in(readable_lines);
  return material;
}

}  // namespace

std::vector<MtlMaterial> read_mtl_file(const std::filesystem::path& path) {
  const std::string text = utf8_text(path, read_bytes(path, largest_library));
  std::vector<MtlMaterial> materials;
  std::string lines;
  bool in_material = false;
  const auto finish = [&] {
    if (in_material) {
      materials.push_back(material_in(lines));
    }
    lines.clear();
  };
  for_each_line(text, [&](std::string_view line) {
    if (statement_in(line).keyword == "newmtl") {
      finish();
      in_material = true;
    }
    lines.append(line).append("\n");
  });
  finish();
  return materials;
}

}  // namespace foveola
