// Reads the material library of an OBJ file, unconverted, through tinyobjloader.
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
  /// The statements present in the file, such as "Kd"; values of absent statements are meaningless.
  std::set<std::string, std::less<>> statements;
  /// Number of map statements without a file, which are neither in `values` nor in `statements`.
  std::size_t maps_without_file = 0;
  /// Statements with words in place of numbers, such as "Kd spectral file.rfl" or "Ns nan", which
  /// are not in `statements` either.
  std::set<std::string, std::less<>> without_numbers;
  /// "d -halo", whose number is read as that of "d".
  bool has_halo = false;

  bool has(std::string_view statement) const { return statements.contains(statement); }
};

/// The materials of the file at `path`, in its order. Throws Error if it cannot be read or is not
/// text.
std::vector<MtlMaterial> read_mtl_file(const std::filesystem::path& path);

}  // namespace foveola
