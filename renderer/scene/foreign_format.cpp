#include "renderer/scene/foreign_format.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/files/files.h"

namespace fs = std::filesystem;

namespace foveola {
namespace {

constexpr const char* export_from_blender =
    "export it as glTF binary (.glb): in Blender, File > Export > glTF 2.0";
constexpr const char* import_into_blender =
    "import it into Blender (File > Import) and export it as glTF binary: File > Export > glTF 2.0";
constexpr const char* export_from_its_program =
    "open it in the program that made it and export it from there as glTF binary (.glb), or as FBX "
    "for Blender to convert";

struct ForeignFormat {
  std::string_view extension;
  const char* what;  ///< as in "is a Blender file"
  const char* remedy;
};

constexpr ForeignFormat blender{".blend", "a Blender file", export_from_blender};

constexpr std::array foreign_formats{
    blender,
    ForeignFormat{".blend1", "a Blender file", export_from_blender},
    ForeignFormat{".fbx", "an FBX file", import_into_blender},
    ForeignFormat{".usd", "a USD file", import_into_blender},
    ForeignFormat{".usda", "a USD file", import_into_blender},
    ForeignFormat{".usdc", "a USD file", import_into_blender},
    ForeignFormat{".usdz", "a USD archive", import_into_blender},
    ForeignFormat{".dae", "a COLLADA file", import_into_blender},
    ForeignFormat{".stl", "an STL file", import_into_blender},
    ForeignFormat{".ply", "a PLY file", import_into_blender},
    ForeignFormat{".abc", "an Alembic file", import_into_blender},
    ForeignFormat{".3ds", "a file of 3D Studio", export_from_its_program},
    ForeignFormat{".max", "a file of 3ds Max", export_from_its_program},
    ForeignFormat{".ma", "a file of Maya", export_from_its_program},
    ForeignFormat{".mb", "a file of Maya", export_from_its_program},
    ForeignFormat{".c4d", "a file of Cinema 4D", export_from_its_program},
    ForeignFormat{".skp", "a file of SketchUp", export_from_its_program}};

/// The first bytes that all signatures need; fewer of a short file.
std::string start_of_file(const fs::path& path) {
  std::array<char, 24> bytes{};
  std::ifstream file(path, std::ios::binary);
  file.read(bytes.data(), bytes.size());
  return {bytes.data(), static_cast<std::size_t>(file.gcount())};
}

/// Files compressed by Blender, with gzip or since 3.0 with Zstandard, are recognised by their
/// names alone.
const ForeignFormat* format_of(const fs::path& path) {
  const std::string start = start_of_file(path);
  if (start.starts_with("glTF")) {
    return nullptr;
  }
  if (start.starts_with("BLENDER")) {
    return &blender;
  }
  const std::string extension = lower_case_extension(path);
  const auto* const known = std::ranges::find_if(foreign_formats, [&](const ForeignFormat& format) {
    return format.extension == extension ||
           (format.extension == ".fbx" && start.starts_with("Kaydara FBX Binary")) ||
           (format.extension == ".usdc" && start.starts_with("PXR-USDC")) ||
           (format.extension == ".usda" && start.starts_with("#usda"));
  });
  return known != foreign_formats.end() ? known : nullptr;
}

}  // namespace

void require_readable_format(const fs::path& file) {
  if (const ForeignFormat* const format = format_of(file)) {
    throw Error(file.string(), fmt::format("is {}, which Foveola does not read", format->what),
                format->remedy);
  }
}

}  // namespace foveola
