#include "renderer/gaze/hid_report_items.h"

#include "renderer/base/error.h"

namespace foveola {
namespace {

constexpr std::uint8_t long_item_prefix = 0xFE;

}  // namespace

std::int64_t HidItemData::as_signed() const {
  switch (size_bytes) {
    case 1:
      return static_cast<std::int8_t>(bits);
    case 2:
      return static_cast<std::int16_t>(bits);
    default:
      return static_cast<std::int32_t>(bits);
  }
}

std::optional<HidItem> HidItemReader::next() {
  while (position_ < bytes_.size() && bytes_[position_] == long_item_prefix) {
    skip_long_item();
  }
  if (position_ == bytes_.size()) {
    return std::nullopt;
  }
  HidItem item{.offset = position_};
  const unsigned prefix = take_byte(item.offset);
  item.kind = static_cast<HidItemKind>(prefix & 0xFCU);
  item.data.size_bytes = (prefix & 3U) == 3U ? 4U : prefix & 3U;
  for (unsigned i = 0; i < item.data.size_bytes; ++i) {
    item.data.bits |= std::uint32_t{take_byte(item.offset)} << (8U * i);
  }
  return item;
}

std::uint8_t HidItemReader::take_byte(std::size_t item_offset) {
  if (position_ == bytes_.size()) {
    refuse_descriptor(item_offset, "the item is cut off");
  }
  return bytes_[position_++];
}

// Section 6.2.2.3: the prefix, the size of the data, a tag, the data.
void HidItemReader::skip_long_item() {
  const std::size_t offset = position_++;
  const std::size_t data_size = take_byte(offset);
  take_byte(offset);
  if (data_size > bytes_.size() - position_) {
    refuse_descriptor(offset, "the long item is cut off");
  }
  position_ += data_size;
}

void refuse_descriptor(std::size_t offset, const std::string& what) {
  throw Error("HID report descriptor, byte " + std::to_string(offset), what,
              "the device cannot be used with this firmware");
}

}  // namespace foveola
