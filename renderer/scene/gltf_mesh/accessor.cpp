#include "renderer/scene/gltf_mesh/accessor.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <optional>
#include <type_traits>

#include <fmt/format.h>

#include "renderer/base/transformed.h"
#include "renderer/scene/gltf_file/fault.h"

namespace foveola {
namespace {

/// Enough for a matrix of floats.
constexpr std::array<unsigned char, 64> zeros = {};

template <typename T>
T load(const unsigned char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);  // files need not align values
  return value;
}

std::uint32_t load_index(const unsigned char* bytes, GltfComponent component) {
  return with_type_of(component, [&](auto example) {
    return static_cast<std::uint32_t>(load<decltype(example)>(bytes));
  });
}

const GltfAccessor& accessor_at(const GltfModel& model, int index) {
  return model.accessors.at(static_cast<std::size_t>(index));
}

/// Pointer to `count` elements of `size` bytes, `stride` bytes apart, from `offset` in a buffer
/// view; all lie inside the view. Counts and offsets are at most 2^32 and strides below 2^10, so 64
/// bits hold every product.
const unsigned char* bytes_in_view(const GltfModel& model, int view_index, std::size_t offset,
                                   std::size_t count, std::size_t stride, std::size_t size,
                                   const std::string& what, const std::string& place) {
  const GltfBufferView& view = model.views.at(static_cast<std::size_t>(view_index));
  const GltfBytes& buffer = model.buffers.at(view.buffer);
  const std::size_t end = offset + (count - 1) * stride + size;
  if (end > view.length || view.offset + end > buffer.size()) {
    throw GltfFault(place, fmt::format("{} ends at byte {}, but bufferViews[{}] has {} bytes", what,
                                       end, view_index, view.length));
  }
  return buffer.data() + view.offset + offset;
}

/// The replaced elements of an accessor (specification, section 3.6.2.3).
class SparseElements {
 public:
  /// accessor_index: of a sparse accessor.
  SparseElements(const GltfModel& model, int accessor_index, const std::string& place)
      : sparse_(*accessor_at(model, accessor_index).sparse),
        index_size_(size_of(sparse_.index_component)),
        value_size_(accessor_at(model, accessor_index).element_size()),
        indices_(bytes_in_view(model, sparse_.index_view, sparse_.index_offset, count(),
                               index_size_, index_size_,
                               fmt::format("accessors[{}].sparse.indices", accessor_index), place)),
        values_(bytes_in_view(model, sparse_.value_view, sparse_.value_offset, count(), value_size_,
                              value_size_,
                              fmt::format("accessors[{}].sparse.values", accessor_index), place)) {}

  std::size_t count() const { return sparse_.count; }
  std::uint32_t index(std::size_t i) const {
    return load_index(indices_ + i * index_size_, sparse_.index_component);
  }

  /// The bytes that replace element `element`, or null.
  const unsigned char* find(std::uint32_t element) const {
    std::size_t begin = 0;
    std::size_t end = count();
    while (begin < end) {
      const std::size_t middle = begin + (end - begin) / 2;
      if (index(middle) < element) {
        begin = middle + 1;
      } else {
        end = middle;
      }
    }
    return begin < count() && index(begin) == element ? values_ + begin * value_size_ : nullptr;
  }

 private:
  const GltfAccessor::Sparse& sparse_;
  std::size_t index_size_;
  std::size_t value_size_;
  const unsigned char* indices_;
  const unsigned char* values_;
};

/// The elements of an accessor in memory.
class Elements {
 public:
  Elements(const GltfModel& model, int index, const std::string& place)
      : count_(accessor_at(model, index).count) {
    constexpr std::size_t max_zeros = std::size_t{1} << 22;
    const GltfAccessor& accessor = accessor_at(model, index);
    if (accessor.sparse) {
      sparse_.emplace(model, index, place);
    }
    if (accessor.view >= 0) {
      const GltfBufferView& view = model.views.at(static_cast<std::size_t>(accessor.view));
      const std::size_t size = accessor.element_size();
      stride_ = view.stride != 0 ? view.stride : size;
      first_ = bytes_in_view(model, accessor.view, accessor.offset, count_, stride_, size,
                             fmt::format("accessors[{}]", index), place);
    } else if (count_ > max_zeros) {
      throw GltfFault(place, fmt::format("accessors[{}] has {} elements without data; up to {} are "
                                         "read",
                                         index, count_, max_zeros));
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

std::string type_name(const GltfAccessor& accessor) {
  const std::string component = with_type_of(accessor.component, [](auto example) {
    return std::is_floating_point_v<decltype(example)>
               ? std::string("float")
               : fmt::format("{}-bit {}", 8 * sizeof example,
                             std::is_signed_v<decltype(example)> ? "signed" : "unsigned");
  });
  return fmt::format("{} x {}{}", accessor.components, component,
                     accessor.is_normalized ? " (normalised)" : "");
}

[[noreturn]] void refuse_type(const GltfAccessor& accessor, int index, const std::string& place,
                              const std::string& wanted) {
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
std::vector<glm::vec<size, float>> read(const GltfModel& model, int index, ElementList elements,
                                        const std::string& place) {
  const Elements source(model, index, place);
  const GltfAccessor& accessor = accessor_at(model, index);
  if (!elements.empty() && elements.back() >= source.count()) {
    throw GltfFault(place, fmt::format("accessors[{}] has {} elements, but an index names the {}.",
                                       index, source.count(), std::size_t{elements.back()} + 1));
  }
  if (accessor.components != size || accessor.is_matrix ||
      accessor.component == GltfComponent::uint32) {
    refuse_type(accessor, index, place, fmt::format("{} x float or integer of 8 or 16 bits", size));
  }
  return with_type_of(accessor.component, [&](auto example) {
    return convert<size, decltype(example)>(source, elements, accessor.is_normalized);
  });
}

}  // namespace

void check_sparse_accessors(const GltfModel& model) {
  // Sparse accessors may share their indices, so their number alone bounds nothing.
  constexpr std::size_t most = std::size_t{1} << 27;
  std::size_t checked = 0;
  for (std::size_t i = 0; i < model.accessors.size(); ++i) {
    if (!model.accessors[i].sparse) {
      continue;
    }
    const std::string place = fmt::format("accessors[{}].sparse", i);
    const SparseElements sparse(model, static_cast<int>(i), place);
    checked += sparse.count();
    if (checked > most) {
      throw GltfFault(place,
                      fmt::format("the sparse accessors replace more than {} elements", most));
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

std::size_t element_count(const GltfModel& model, int index) {
  return accessor_at(model, index).count;
}

std::vector<std::uint32_t> read_indices(const GltfModel& model, int index,
                                        const std::string& place) {
  const Elements source(model, index, place);
  const GltfAccessor& accessor = accessor_at(model, index);
  const GltfComponent component = accessor.component;
  if (accessor.components != 1 || accessor.is_normalized ||
      (component != GltfComponent::uint8 && component != GltfComponent::uint16 &&
       component != GltfComponent::uint32)) {
    refuse_type(accessor, index, place, "1 x unsigned integer");
  }
  std::vector<std::uint32_t> indices(source.count());
  for (std::size_t i = 0; i < indices.size(); ++i) {
    indices[i] = load_index(source.bytes(static_cast<std::uint32_t>(i)), component);
  }
  return indices;
}

std::vector<Vec2> read_vec2s(const GltfModel& model, int index, ElementList elements,
                             const std::string& place) {
  return read<2>(model, index, elements, place);
}

std::vector<Vec3> read_vec3s(const GltfModel& model, int index, ElementList elements,
                             const std::string& place) {
  return read<3>(model, index, elements, place);
}

std::vector<Vec4> read_vec4s(const GltfModel& model, int index, ElementList elements,
                             const std::string& place) {
  return read<4>(model, index, elements, place);
}

std::vector<Vec4> read_colors(const GltfModel& model, int index, ElementList elements,
                              const std::string& place) {
  const GltfAccessor& accessor = accessor_at(model, index);
  const GltfComponent component = accessor.component;
  const bool is_unsigned = component == GltfComponent::uint8 || component == GltfComponent::uint16;
  if (component != GltfComponent::float32 && !(is_unsigned && accessor.is_normalized)) {
    refuse_type(accessor, index, place, "float or normalised unsigned integer of 8 or 16 bits");
  }
  if (accessor.components == 4 && !accessor.is_matrix) {
    return read_vec4s(model, index, elements, place);
  }
  return transformed(read_vec3s(model, index, elements, place),
                     [&](const Vec3& color) { return Vec4(color, 1.0F); });
}

void VertexReader::require_count(int index, const std::string& place) const {
  if (const std::size_t count = element_count(model_, index); count != vertex_count_) {
    throw GltfFault(place, fmt::format("accessors[{}] has {} elements, but POSITION has {}", index,
                                       count, vertex_count_));
  }
}

std::vector<float> read_numbers(const GltfModel& model, int index, int components,
                                const std::string& place) {
  constexpr int max_in_columns_without_padding = 4;
  const Elements source(model, index, place);
  const GltfAccessor& accessor = accessor_at(model, index);
  const bool is_float = accessor.component == GltfComponent::float32;
  if (accessor.components != components || accessor.component == GltfComponent::uint32 ||
      (!is_float && components > max_in_columns_without_padding)) {
    refuse_type(accessor, index, place, fmt::format("{} x float", components));
  }
  std::vector<float> numbers;
  numbers.reserve(source.count() * static_cast<std::size_t>(components));
  with_type_of(accessor.component, [&](auto example) {
    for (std::uint32_t element = 0; element < source.count(); ++element) {
      const unsigned char* bytes = source.bytes(element);
      for (int i = 0; i < components; ++i, bytes += sizeof example) {
        numbers.push_back(to_float(load<decltype(example)>(bytes), accessor.is_normalized));
      }
    }
  });
  return numbers;
}

}  // namespace foveola
