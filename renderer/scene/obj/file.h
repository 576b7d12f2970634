// Reads a Wavefront OBJ file's geometry, unconverted, through tinyobjloader.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/base/vec.h"
#include "renderer/scene/warnings.h"

namespace foveola {

/// Indices of a face's corner, from 0; -1: absent.
struct ObjCorner {
  int position = -1;
  int uv = -1;
  int normal = -1;

  auto operator<=>(const ObjCorner&) const = default;
};

/// The faces of one object with one material.
struct ObjPart {
  std::string object;                      ///< the last "o", or, before any, "g"
  std::string material;                    ///< the last "usemtl"; may be empty
  std::vector<ObjCorner> corners;          ///< one face after the other
  std::vector<std::size_t> begins;         ///< for each face, the index of its first corner
  std::vector<unsigned> smoothing_groups;  ///< per face, 0: none; empty if no face has one
};

struct ObjFile {
  std::vector<Vec3> positions;
  std::vector<Rgb> colors;  ///< see vertex_colors_in(): one per position, or none
  std::vector<Vec2> uvs;    ///< as in the file: v runs upwards
  std::vector<Vec3> normals;
  std::vector<ObjPart> parts;                   ///< in the order of their first face
  std::vector<std::string> material_libraries;  ///< the arguments of "mtllib"
  std::string sha256;                           ///< SHA-256 of the file
};

/// Reads the file at `path`: faces with their indices resolved and in range, and smoothing groups
/// as normals. Lines, points and curves are not read. Throws Error if the file cannot be read or is
/// not text, or if a face refers to an element not defined before it.
ObjFile read_obj_file(const std::filesystem::path& path, Warnings& warnings);

}  // namespace foveola
