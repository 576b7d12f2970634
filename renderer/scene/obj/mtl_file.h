// Reads the material library of an OBJ file, as it is written, through tinyobjloader.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <tiny_obj_loader.h>

namespace foveola {

struct MtlMaterial {
  std::string name;
  tinyobj::material_t values;
  /// The statements that stand in the file, such as "Kd": what is left out has no value of its own
  /// in `values`.
  std::set<std::string, std::less<>> statements;
  /// The statements of maps that name no file, which are neither in `values` nor in `statements`.
  std::size_t maps_without_file = 0;
  /// The statements with words in place of numbers, such as "Kd spectral file.rfl" or "Ns nan",
  /// which are not in `statements` either.
  std::set<std::string, std::less<>> without_numbers;
  /// "d -halo", whose number is read as if it stood alone.
  bool has_halo = false;

  bool has(std::string_view statement) const { return statements.contains(statement); }
};

/// The materials of the file at `path`, in its order. Throws Error if it cannot be read or is no
/// text.
std::vector<MtlMaterial> read_mtl_file(const std::filesystem::path& path);

}  // namespace foveola
