#include "renderer/scene/gltf/accessor.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <optional>
#include <type_traits>

#include <fmt/format.h>
#include <tiny_gltf.h>

#include "renderer/scene/gltf/fault.h"

namespace foveola {
namespace {

/// Enough for a matrix of floats.
constexpr std::array<unsigned char, 64> zeros = {};

template <typename T>
T load(const unsigned char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);  // files align as they like
  return value;
}

std::uint32_t load_index(const unsigned char* bytes, int component_type) {
  switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return *bytes;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return load<std::uint16_t>(bytes);
    default:
      return load<std::uint32_t>(bytes);
  }
}

std::size_t component_size(int component_type) {
  return static_cast<std::size_t>(
      tinygltf::GetComponentSizeInBytes(static_cast<unsigned>(component_type)));
}

std::size_t element_size(const tinygltf::Accessor& accessor) {
  return component_size(accessor.componentType) *
         static_cast<std::size_t>(
             tinygltf::GetNumComponentsInType(static_cast<unsigned>(accessor.type)));
}

const tinygltf::Accessor& accessor_at(const tinygltf::Model& model, int index) {
  return model.accessors.at(static_cast<std::size_t>(index));
}

/// `count` elements of `size` bytes, at `stride` bytes from each other, `offset` bytes into a
/// buffer view: a pointer to the first of them, all of which lie inside the view. Counts and
/// offsets are at most 2^32 and strides below 2^10, so 64 bits hold every product.
const unsigned char* bytes_in_view(const tinygltf::Model& model, int view_index, std::size_t offset,
                                   std::size_t count, std::size_t stride, std::size_t size,
                                   const std::string& what, const std::string& place) {
  const auto& view = model.bufferViews.at(static_cast<std::size_t>(view_index));
  const auto& buffer = model.buffers.at(static_cast<std::size_t>(view.buffer));
  const std::size_t end = offset + (count - 1) * stride + size;
  if (end > view.byteLength || view.byteOffset + end > buffer.data.size()) {
    throw GltfFault(place, fmt::format("{} ends at byte {}, but bufferViews[{}] has {} bytes", what,
                                       end, view_index, view.byteLength));
  }
  return buffer.data.data() + view.byteOffset + offset;
}

/// The elements of an accessor that replace others (specification, section 3.6.2.3).
class SparseElements {
 public:
  SparseElements(const tinygltf::Model& model, int accessor_index, const std::string& place)
      : count_(static_cast<std::size_t>(accessor_at(model, accessor_index).sparse.count)),
        index_type_(accessor_at(model, accessor_index).sparse.indices.componentType),
        index_size_(component_size(index_type_)),
        value_size_(element_size(accessor_at(model, accessor_index))) {
    const auto& sparse = accessor_at(model, accessor_index).sparse;
    indices_ = bytes_in_view(model, sparse.indices.bufferView,
                             static_cast<std::size_t>(sparse.indices.byteOffset), count_,
                             index_size_, index_size_,
                             fmt::format("accessors[{}].sparse.indices", accessor_index), place);
    values_ = bytes_in_view(model, sparse.values.bufferView,
                            static_cast<std::size_t>(sparse.values.byteOffset), count_, value_size_,
                            value_size_, fmt::format("accessors[{}].sparse.values", accessor_index),
                            place);
  }

  std::size_t count() const { return count_; }
  std::uint32_t index(std::size_t i) const {
    return load_index(indices_ + i * index_size_, index_type_);
  }

  /// The bytes that replace element `element`, or null.
  const unsigned char* find(std::uint32_t element) const {
    std::size_t begin = 0;
    std::size_t end = count_;
    while (begin < end) {
      const std::size_t middle = begin + (end - begin) / 2;
      if (index(middle) < element) {
        begin = middle + 1;
      } else {
        end = middle;
      }
    }
    return begin < count_ && index(begin) == element ? values_ + begin * value_size_ : nullptr;
  }

 private:
  std::size_t count_;
  int index_type_;
  std::size_t index_size_;
  std::size_t value_size_;
  const unsigned char* indices_ = nullptr;
  const unsigned char* values_ = nullptr;
};

/// The elements of an accessor in memory.
class Elements {
 public:
  Elements(const tinygltf::Model& model, int index, const std::string& place)
      : count_(accessor_at(model, index).count) {
    constexpr std::size_t most_zeros = std::size_t{1} << 22;
    const tinygltf::Accessor& accessor = accessor_at(model, index);
    if (accessor.sparse.isSparse) {
      sparse_.emplace(model, index, place);
    }
    if (accessor.bufferView >= 0) {
      const auto& view = model.bufferViews.at(static_cast<std::size_t>(accessor.bufferView));
      const std::size_t size = element_size(accessor);
      stride_ = view.byteStride != 0 ? view.byteStride : size;
      first_ = bytes_in_view(model, accessor.bufferView, accessor.byteOffset, count_, stride_, size,
                             fmt::format("accessors[{}]", index), place);
    } else if (count_ > most_zeros) {
      throw GltfFault(place, fmt::format("accessors[{}] has {} elements without data; up to {} are "
                                         "read",
                                         index, count_, most_zeros));
    }
  }

  std::size_t count() const { return count_; }

  const unsigned char* bytes(std::uint32_t element) const {
    if (sparse_) {
      if (const unsigned char* replacement = sparse_->find(element)) {
        return replacement;
      }
    }
    return first_ == nullptr ? zeros.data() : first_ + element * stride_;
  }

 private:
  std::size_t count_;
  const unsigned char* first_ = nullptr;
  std::size_t stride_ = 0;
  std::optional<SparseElements> sparse_;
};

std::string type_name(const tinygltf::Accessor& accessor) {
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
  return fmt::format(
      "{} x {}{}", tinygltf::GetNumComponentsInType(static_cast<unsigned>(accessor.type)),
      component_name(accessor.componentType), accessor.normalized ? " (normalised)" : "");
}

[[noreturn]] void refuse_type(const tinygltf::Accessor& accessor, int index,
                              const std::string& place, const std::string& wanted) {
  throw GltfFault(place, fmt::format("accessors[{}] holds {}, but {} is needed", index,
                                     type_name(accessor), wanted));
}

template <typename Component>
float to_float(Component value, bool normalized) {
  if constexpr (std::is_floating_point_v<Component>) {
    return value;
  } else {
    constexpr auto one = static_cast<float>(std::numeric_limits<Component>::max());
    const auto number = static_cast<float>(value);
    return normalized ? std::max(number / one, -1.0F) : number;
  }
}

float number_at(const unsigned char* bytes, int component_type, bool normalized) {
  switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return to_float(load<std::int8_t>(bytes), normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return to_float(load<std::uint8_t>(bytes), normalized);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return to_float(load<std::int16_t>(bytes), normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return to_float(load<std::uint16_t>(bytes), normalized);
    default:
      return load<float>(bytes);
  }
}

template <int size, typename Component>
std::vector<glm::vec<size, float>> convert(const Elements& source, ElementList elements,
                                           bool normalized) {
  std::vector<glm::vec<size, float>> values;
  values.reserve(elements.size());
  for (const std::uint32_t element : elements) {
    const unsigned char* bytes = source.bytes(element);
    glm::vec<size, float> value;
    for (int i = 0; i < size; ++i) {
      value[i] = to_float(load<Component>(bytes + static_cast<std::size_t>(i) * sizeof(Component)),
                          normalized);
    }
    values.push_back(value);
  }
  return values;
}

template <int size>
std::vector<glm::vec<size, float>> read(const tinygltf::Model& model, int index,
                                        ElementList elements, const std::string& place) {
  const Elements source(model, index, place);
  const tinygltf::Accessor& accessor = accessor_at(model, index);
  if (!elements.empty() && elements.back() >= source.count()) {
    throw GltfFault(place, fmt::format("accessors[{}] has {} elements, but an index names the {}.",
                                       index, source.count(), std::size_t{elements.back()} + 1));
  }
  if (accessor.type == size) {  // tinygltf's values of VEC2, VEC3 and VEC4
    switch (accessor.componentType) {
      case TINYGLTF_COMPONENT_TYPE_FLOAT:
        return convert<size, float>(source, elements, false);
      case TINYGLTF_COMPONENT_TYPE_BYTE:
        return convert<size, std::int8_t>(source, elements, accessor.normalized);
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return convert<size, std::uint8_t>(source, elements, accessor.normalized);
      case TINYGLTF_COMPONENT_TYPE_SHORT:
        return convert<size, std::int16_t>(source, elements, accessor.normalized);
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return convert<size, std::uint16_t>(source, elements, accessor.normalized);
      default:
        break;
    }
  }
  refuse_type(accessor, index, place, fmt::format("{} x float or integer of 8 or 16 bits", size));
}

}  // namespace

void check_sparse_accessors(const tinygltf::Model& model) {
  // Sparse accessors may share their indices, so their number alone bounds nothing.
  constexpr std::size_t most = std::size_t{1} << 27;
  std::size_t checked = 0;
  for (std::size_t i = 0; i < model.accessors.size(); ++i) {
    if (!model.accessors[i].sparse.isSparse) {
      continue;
    }
    const std::string place = fmt::format("accessors[{}].sparse", i);
    const SparseElements sparse(model, static_cast<int>(i), place);
    checked += sparse.count();
    if (checked > most) {
      throw GltfFault(place, fmt::format("brings the elements that sparse accessors replace to "
                                         "more than {}",
                                         most));
    }
    std::int64_t previous = -1;
    for (std::size_t k = 0; k < sparse.count(); ++k) {
      const std::int64_t element = sparse.index(k);
      if (element <= previous || element >= static_cast<std::int64_t>(model.accessors[i].count)) {
        throw GltfFault(place + ".indices",
                        fmt::format("name element {} after {}, of {}; they must ascend", element,
                                    previous, model.accessors[i].count));
      }
      previous = element;
    }
  }
}

std::size_t element_count(const tinygltf::Model& model, int index) {
  return accessor_at(model, index).count;
}

std::vector<std::uint32_t> read_indices(const tinygltf::Model& model, int index,
                                        const std::string& place) {
  const Elements source(model, index, place);
  const tinygltf::Accessor& accessor = accessor_at(model, index);
  const int type = accessor.componentType;
  if (accessor.type != TINYGLTF_TYPE_SCALAR || accessor.normalized ||
      (type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE &&
       type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT &&
       type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT)) {
    refuse_type(accessor, index, place, "1 x unsigned integer");
  }
  std::vector<std::uint32_t> indices(source.count());
  for (std::size_t i = 0; i < indices.size(); ++i) {
    indices[i] = load_index(source.bytes(static_cast<std::uint32_t>(i)), type);
  }
  return indices;
}

std::vector<Vec2> read_vec2s(const tinygltf::Model& model, int index, ElementList elements,
                             const std::string& place) {
  return read<2>(model, index, elements, place);
}

std::vector<Vec3> read_vec3s(const tinygltf::Model& model, int index, ElementList elements,
                             const std::string& place) {
  return read<3>(model, index, elements, place);
}

std::vector<Vec4> read_vec4s(const tinygltf::Model& model, int index, ElementList elements,
                             const std::string& place) {
  return read<4>(model, index, elements, place);
}

std::vector<Vec4> read_colors(const tinygltf::Model& model, int index, ElementList elements,
                              const std::string& place) {
  const tinygltf::Accessor& accessor = accessor_at(model, index);
  const int type = accessor.componentType;
  const bool is_unsigned = type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                           type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
  if (type != TINYGLTF_COMPONENT_TYPE_FLOAT && !(is_unsigned && accessor.normalized)) {
    refuse_type(accessor, index, place, "float or normalised unsigned integer of 8 or 16 bits");
  }
  if (accessor.type == TINYGLTF_TYPE_VEC4) {
    return read_vec4s(model, index, elements, place);
  }
  std::vector<Vec4> colors;
  colors.reserve(elements.size());
  for (const Vec3& color : read_vec3s(model, index, elements, place)) {
    colors.emplace_back(color, 1.0F);
  }
  return colors;
}

std::vector<float> read_numbers(const tinygltf::Model& model, int index, int components,
                                const std::string& place) {
  constexpr int most_in_columns_without_padding = 4;
  const Elements source(model, index, place);
  const tinygltf::Accessor& accessor = accessor_at(model, index);
  const bool is_float = accessor.componentType == TINYGLTF_COMPONENT_TYPE_FLOAT;
  if (tinygltf::GetNumComponentsInType(static_cast<unsigned>(accessor.type)) != components ||
      accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT ||
      (!is_float && components > most_in_columns_without_padding)) {
    refuse_type(accessor, index, place, fmt::format("{} x float", components));
  }
  const std::size_t size = component_size(accessor.componentType);
  std::vector<float> numbers;
  numbers.reserve(source.count() * static_cast<std::size_t>(components));
  for (std::uint32_t element = 0; element < source.count(); ++element) {
    const unsigned char* bytes = source.bytes(element);
    for (int i = 0; i < components; ++i, bytes += size) {
      numbers.push_back(number_at(bytes, accessor.componentType, accessor.normalized));
    }
  }
  return numbers;
}

}  // namespace foveola
