#include "renderer/scene/gltf_accessor.h"

#include <cstring>
#include <limits>

#include <fmt/format.h>
#include <tiny_gltf.h>

#include "renderer/scene/gltf_fault.h"

namespace foveola {
namespace {

/// The elements of an accessor in memory: all `count` of them, at `stride` bytes from each other,
/// lie inside the buffer view.
struct Elements {
  const unsigned char* first;
  std::size_t stride;
  std::size_t count;
};

std::string type_name(int type, int component_type) {
  static const auto component_name = [](int component) {
    switch (component) {
      case TINYGLTF_COMPONENT_TYPE_BYTE:
        return "8-bit signed";
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return "8-bit unsigned";
      case TINYGLTF_COMPONENT_TYPE_SHORT:
        return "16-bit signed";
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return "16-bit unsigned";
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        return "32-bit unsigned";
      default:
        return "float";
    }
  };
  return fmt::format("{} x {}", tinygltf::GetNumComponentsInType(static_cast<unsigned>(type)),
                     component_name(component_type));
}

[[noreturn]] void refuse_type(const tinygltf::Accessor& accessor, int index,
                              const std::string& place, const std::string& wanted) {
  throw GltfFault(place, fmt::format("accessors[{}] holds {}{}, but {} is needed", index,
                                     type_name(accessor.type, accessor.componentType),
                                     accessor.normalized ? " (normalised)" : "", wanted));
}

/// Counts and offsets are at most 2^32 and strides below 2^10, so 64 bits hold every product.
Elements elements_of(const tinygltf::Model& model, int index, const std::string& place) {
  const tinygltf::Accessor& accessor = model.accessors.at(static_cast<std::size_t>(index));
  if (accessor.sparse.isSparse) {
    throw GltfFault(place, fmt::format("accessors[{}] is sparse, which is not supported", index));
  }
  if (accessor.bufferView < 0) {
    throw GltfFault(place, fmt::format("accessors[{}] has no bufferView", index));
  }
  const auto& view = model.bufferViews.at(static_cast<std::size_t>(accessor.bufferView));
  const auto& buffer = model.buffers.at(static_cast<std::size_t>(view.buffer));
  const auto element_size = static_cast<std::size_t>(
      tinygltf::GetComponentSizeInBytes(static_cast<unsigned>(accessor.componentType)) *
      tinygltf::GetNumComponentsInType(static_cast<unsigned>(accessor.type)));
  const std::size_t stride = view.byteStride != 0 ? view.byteStride : element_size;
  const std::size_t end = accessor.byteOffset + (accessor.count - 1) * stride + element_size;
  if (end > view.byteLength || view.byteOffset + end > buffer.data.size()) {
    throw GltfFault(
        place, fmt::format("accessors[{}] ends at byte {}, but bufferViews[{}] has {} bytes", index,
                           end, accessor.bufferView, view.byteLength));
  }
  return {.first = buffer.data.data() + view.byteOffset + accessor.byteOffset,
          .stride = stride,
          .count = accessor.count};
}

/// Converts each element of `range` from `Stored` (whose memory is as in the file, at any
/// alignment) with `convert`.
template <typename Stored, typename Convert>
auto read(const Elements& elements, ElementRange range, Convert convert) {
  std::vector<decltype(convert(Stored{}))> values;
  values.reserve(range.end - range.begin);
  for (std::size_t i = range.begin; i < range.end; ++i) {
    Stored stored;
    std::memcpy(&stored, elements.first + i * elements.stride, sizeof stored);
    values.push_back(convert(stored));
  }
  return values;
}

constexpr auto unchanged = [](const auto& value) { return value; };

void require_range(const Elements& elements, int index, ElementRange range,
                   const std::string& place) {
  if (range.end > elements.count) {
    throw GltfFault(place, fmt::format("accessors[{}] has {} elements, but an index names the {}.",
                                       index, elements.count, range.end));
  }
}

template <typename Component>
std::vector<Vec2> read_normalised(const Elements& elements, ElementRange range) {
  struct Pair {
    Component x;
    Component y;
  };
  constexpr auto one = static_cast<float>(std::numeric_limits<Component>::max());
  return read<Pair>(elements, range, [](const Pair& pair) {
    return Vec2(static_cast<float>(pair.x) / one, static_cast<float>(pair.y) / one);
  });
}

}  // namespace

std::size_t element_count(const tinygltf::Model& model, int index) {
  return model.accessors.at(static_cast<std::size_t>(index)).count;
}

std::vector<std::uint32_t> read_indices(const tinygltf::Model& model, int index,
                                        const std::string& place) {
  const Elements elements = elements_of(model, index, place);
  const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(index)];
  const ElementRange all{.begin = 0, .end = elements.count};
  if (accessor.type == TINYGLTF_TYPE_SCALAR && !accessor.normalized) {
    const auto widened = [](auto value) { return std::uint32_t{value}; };
    switch (accessor.componentType) {
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return read<std::uint8_t>(elements, all, widened);
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return read<std::uint16_t>(elements, all, widened);
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        return read<std::uint32_t>(elements, all, widened);
      default:
        break;
    }
  }
  refuse_type(accessor, index, place, "1 x unsigned integer");
}

std::vector<Vec3> read_vectors(const tinygltf::Model& model, int index, ElementRange range,
                               const std::string& place) {
  const Elements elements = elements_of(model, index, place);
  const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(index)];
  if (accessor.type != TINYGLTF_TYPE_VEC3 ||
      accessor.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT) {
    refuse_type(accessor, index, place, "3 x float");
  }
  require_range(elements, index, range, place);
  return read<Vec3>(elements, range, unchanged);
}

std::vector<Vec2> read_texture_coordinates(const tinygltf::Model& model, int index,
                                           ElementRange range, const std::string& place) {
  const Elements elements = elements_of(model, index, place);
  const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(index)];
  require_range(elements, index, range, place);
  if (accessor.type == TINYGLTF_TYPE_VEC2) {
    if (accessor.componentType == TINYGLTF_COMPONENT_TYPE_FLOAT) {
      return read<Vec2>(elements, range, unchanged);
    }
    if (accessor.normalized && accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE) {
      return read_normalised<std::uint8_t>(elements, range);
    }
    if (accessor.normalized && accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT) {
      return read_normalised<std::uint16_t>(elements, range);
    }
  }
  refuse_type(accessor, index, place, "2 x float or 2 x normalised unsigned integer");
}

}  // namespace foveola
