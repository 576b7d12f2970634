#include "renderer/scene/mtl_file.h"

#include <map>
#include <sstream>

#include "renderer/scene/text_lines.h"

namespace foveola {
namespace {

constexpr std::size_t largest_file = std::size_t{1} << 26;

/// One material's lines, which begin with its "newmtl".
MtlMaterial material_in(const std::string& lines) {
  std::map<std::string, int> indices;
  std::vector<tinyobj::material_t> materials;
  std::istringstream stream(lines);
  std::string ignored;
  tinyobj::LoadMtl(&indices, &materials, &stream, &ignored, &ignored);
  MtlMaterial material;
  material.values = materials.at(0);
  for_each_line(lines, [&](std::string_view line) {
    const Statement statement = statement_in(line);
    if (statement.keyword == "newmtl") {
      material.name = statement.rest;
    } else {
      material.statements.emplace(statement.keyword);
    }
  });
  return material;
}

}  // namespace

std::vector<MtlMaterial> read_mtl_file(const std::filesystem::path& path) {
  std::string text = read_text_file(path, largest_file);
  blank_byte_order_mark(text);
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
