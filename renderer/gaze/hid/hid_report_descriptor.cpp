#include "renderer/gaze/hid/hid_report_descriptor.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "renderer/base/transformed.h"
#include "renderer/gaze/hid/hid_items.h"

namespace foveola {
namespace {

/// The global state, for all main items from here on (section 6.2.2.7).
struct GlobalState {
  std::uint16_t usage_page = 0;
  HidItemData logical_minimum;
  HidItemData logical_maximum;
  HidItemData physical_minimum;
  HidItemData physical_maximum;
  std::uint32_t unit = 0;
  int unit_exponent = 0;
  std::uint32_t report_size = 0;
  std::uint32_t report_count = 0;
  std::uint8_t report_id = 0;
};

/// A usage without a page takes the page at the main item (6.2.2.8).
struct PartialUsage {
  std::optional<std::uint16_t> page;
  std::uint16_t id = 0;
};

struct PartialRange {
  PartialUsage first;
  std::uint16_t last_id = 0;
};

/// The local state, for the next main item only.
struct LocalState {
  std::vector<PartialRange> usages;
  std::optional<PartialUsage> minimum;
  bool in_delimiter = false;
  bool has_delimited_usage = false;
};

struct NumberRange {
  std::int64_t minimum = 0;
  std::int64_t maximum = 0;
};

/// A maximum is signed only if the minimum is negative: many devices write 255 as one byte FF.
NumberRange range_from(const HidItemData& minimum, const HidItemData& maximum) {
  const std::int64_t least = minimum.as_signed();
  return {.minimum = least,
          .maximum = least < 0 ? maximum.as_signed() : std::int64_t{maximum.bits}};
}

PartialUsage usage_from(const HidItemData& data) {
  PartialUsage usage{.id = static_cast<std::uint16_t>(data.bits)};
  if (data.size_bytes == 4) {
    usage.page = static_cast<std::uint16_t>(data.bits >> 16);
  }
  return usage;
}

/// Section 6.2.2.7 codes it in a nibble, -8 to 7; many devices write -1 as a whole byte FF instead.
int unit_exponent_from(const HidItem& item) {
  const std::uint32_t bits = item.data.bits;
  if (bits < 16) {
    return static_cast<int>(bits < 8 ? bits : bits - 16);
  }
  const std::int64_t exponent = item.data.as_signed();
  if (exponent < -20 || exponent > 20) {
    refuse_descriptor(item.offset, "no unit has an exponent of " + std::to_string(exponent));
  }
  return static_cast<int>(exponent);
}

class DescriptorParser {
 public:
  HidReportDescriptor parse(std::span<const std::uint8_t> bytes) {
    HidItemReader reader(bytes);
    while (const std::optional<HidItem> item = reader.next()) {
      take(*item);
    }
    if (!collections_.empty()) {
      refuse_descriptor(bytes.size(), "a collection has no end");
    }
    if (!all_or_none_have_ids()) {
      refuse_descriptor(bytes.size(), "some reports have an id and others have none");
    }
    set_sizes();
    return std::move(descriptor_);
  }

 private:
  /// Items of other kinds (designators, strings, reserved ones) do not describe numbers.
  void take(const HidItem& item) {
    switch (item.kind) {
      case HidItemKind::input:
        return end_main_item([&] { add_field(HidReportKind::input, item); });
      case HidItemKind::output:
        return end_main_item([&] { add_field(HidReportKind::output, item); });
      case HidItemKind::feature:
        return end_main_item([&] { add_field(HidReportKind::feature, item); });
      case HidItemKind::collection:
        return end_main_item([&] { open_collection(item); });
      case HidItemKind::end_collection:
        return end_main_item([&] { close_collection(item); });
      case HidItemKind::usage:
      case HidItemKind::usage_minimum:
      case HidItemKind::usage_maximum:
      case HidItemKind::delimiter:
        return take_local(item);
      default:
        return take_global(item);
    }
  }

  void take_global(const HidItem& item) {
    switch (item.kind) {
      case HidItemKind::usage_page:
        global_.usage_page = usage_page_from(item);
        break;
      case HidItemKind::logical_minimum:
        global_.logical_minimum = item.data;
        break;
      case HidItemKind::logical_maximum:
        global_.logical_maximum = item.data;
        break;
      case HidItemKind::physical_minimum:
        global_.physical_minimum = item.data;
        break;
      case HidItemKind::physical_maximum:
        global_.physical_maximum = item.data;
        break;
      case HidItemKind::unit_exponent:
        global_.unit_exponent = unit_exponent_from(item);
        break;
      case HidItemKind::unit:
        global_.unit = item.data.bits;
        break;
      case HidItemKind::report_size:
        global_.report_size = item.data.bits;
        break;
      case HidItemKind::report_id:
        global_.report_id = report_id_from(item);
        break;
      case HidItemKind::report_count:
        global_.report_count = item.data.bits;
        break;
      case HidItemKind::push:
        push(item);
        break;
      case HidItemKind::pop:
        pop(item);
        break;
      default:
        break;
    }
  }

  void take_local(const HidItem& item) {
    switch (item.kind) {
      case HidItemKind::usage:
        add_usages({.first = usage_from(item.data),
                    .last_id = static_cast<std::uint16_t>(item.data.bits)});
        break;
      case HidItemKind::usage_minimum:
        local_.minimum = usage_from(item.data);
        break;
      case HidItemKind::usage_maximum:
        close_usage_range(item);
        break;
      default:
        take_delimiter(item);
        break;
    }
  }

  static std::uint16_t usage_page_from(const HidItem& item) {
    if (item.data.bits > 0xFFFF) {
      refuse_descriptor(item.offset, "a usage page has 16 bits");
    }
    return static_cast<std::uint16_t>(item.data.bits);
  }

  static std::uint8_t report_id_from(const HidItem& item) {
    if (item.data.bits == 0 || item.data.bits > 255) {
      refuse_descriptor(item.offset, "a report's id is from 1 to 255");
    }
    return static_cast<std::uint8_t>(item.data.bits);
  }

  void push(const HidItem& item) {
    if (pushed_.size() == HidLimits::pushed_states) {
      refuse_descriptor(item.offset, "too many states are pushed");
    }
    pushed_.push_back(global_);
  }

  void pop(const HidItem& item) {
    if (pushed_.empty()) {
      refuse_descriptor(item.offset, "no state was pushed that could be popped");
    }
    global_ = pushed_.back();
    pushed_.pop_back();
  }

  /// Delimiters enclose several usages of one number, of which the first is preferred.
  void add_usages(const PartialRange& usages) {
    if (local_.in_delimiter && std::exchange(local_.has_delimited_usage, true)) {
      return;
    }
    local_.usages.push_back(usages);
  }

  void close_usage_range(const HidItem& item) {
    if (!local_.minimum) {
      refuse_descriptor(item.offset, "a usage maximum follows no usage minimum");
    }
    const PartialUsage first = *std::exchange(local_.minimum, std::nullopt);
    const PartialUsage last = usage_from(item.data);
    if (last.id < first.id || (last.page && first.page && last.page != first.page)) {
      refuse_descriptor(item.offset, "a usage maximum is below its minimum or on another page");
    }
    add_usages({.first = {.page = first.page ? first.page : last.page, .id = first.id},
                .last_id = last.id});
  }

  void take_delimiter(const HidItem& item) {
    const bool opens = item.data.bits != 0;
    if (opens == local_.in_delimiter) {
      refuse_descriptor(item.offset, "delimiters are not in pairs");
    }
    local_.in_delimiter = opens;
    local_.has_delimited_usage = false;
  }

  template <typename MainItem>
  void end_main_item(MainItem&& main_item) {
    main_item();
    local_ = {};
  }

  std::vector<HidUsageRange> usages() const {
    return transformed(local_.usages, [&](const PartialRange& range) {
      return HidUsageRange{
          .first = {.page = range.first.page.value_or(global_.usage_page), .id = range.first.id},
          .last_id = range.last_id};
    });
  }

  void open_collection(const HidItem& item) {
    if (collections_.size() == HidLimits::collection_depth) {
      refuse_descriptor(item.offset, "collections are nested too deeply");
    }
    const std::vector<HidUsageRange> named = usages();
    collections_.push_back(named.empty() ? HidUsage{} : named.front().first);
  }

  void close_collection(const HidItem& item) {
    if (collections_.empty()) {
      refuse_descriptor(item.offset, "no collection is open that could end");
    }
    collections_.pop_back();
  }

  HidReport& report_of(HidReportKind kind) {
    std::vector<HidReport>& reports = descriptor_.reports;
    const auto found = std::ranges::find_if(reports, [&](const HidReport& report) {
      return report.kind == kind && report.id == global_.report_id;
    });
    return found != reports.end()
               ? *found
               : reports.emplace_back(HidReport{.kind = kind, .id = global_.report_id});
  }

  void add_field(HidReportKind kind, const HidItem& item) {
    const std::uint64_t bits = std::uint64_t{global_.report_size} * global_.report_count;
    if (bits == 0) {
      return;
    }
    HidReport& report = report_of(kind);
    if (bits > HidLimits::report_bits - report.bit_size) {
      refuse_descriptor(item.offset, "a report is longer than " +
                                         std::to_string(HidLimits::report_bits / 8) + " bytes");
    }
    if (++field_count_ > HidLimits::fields) {
      refuse_descriptor(item.offset,
                        "there are more than " + std::to_string(HidLimits::fields) + " fields");
    }
    report.fields.push_back(field_from(item));
    report.fields.back().bit_offset = report.bit_size;
    report.bit_size += static_cast<std::uint32_t>(bits);
  }

  HidField field_from(const HidItem& item) const {
    const NumberRange logical = range_from(global_.logical_minimum, global_.logical_maximum);
    const NumberRange physical = range_from(global_.physical_minimum, global_.physical_maximum);
    if (logical.maximum < logical.minimum) {
      refuse_descriptor(item.offset, "the logical maximum is below the minimum");
    }
    return {.usages = usages(),
            .collections = collections_,
            .bit_size = global_.report_size,
            .count = global_.report_count,
            .logical_minimum = logical.minimum,
            .logical_maximum = logical.maximum,
            .physical_minimum = physical.minimum,
            .physical_maximum = physical.maximum,
            .unit = global_.unit,
            .unit_exponent = global_.unit_exponent,
            .is_variable = (item.data.bits & 2) != 0};
  }

  bool all_or_none_have_ids() const {
    const auto has_id = [](const HidReport& report) { return report.id != 0; };
    const std::vector<HidReport>& reports = descriptor_.reports;
    return std::ranges::all_of(reports, has_id) || std::ranges::none_of(reports, has_id);
  }

  void set_sizes() {
    for (HidReport& report : descriptor_.reports) {
      const std::size_t id_bytes = report.id != 0 ? 1 : 0;
      report.size_bytes = id_bytes + (report.bit_size + 7) / 8;
    }
  }

  HidReportDescriptor descriptor_;
  std::size_t field_count_ = 0;
  GlobalState global_;
  std::vector<GlobalState> pushed_;
  LocalState local_;
  std::vector<HidUsage> collections_;
};

}  // namespace

HidReportDescriptor parse_report_descriptor(std::span<const std::uint8_t> bytes) {
  return DescriptorParser().parse(bytes);
}

HidNumberRun numbers_with(const HidField& field, const HidUsage& usage) {
  if (!field.is_variable) {
    return {};
  }
  std::uint64_t index = 0;  // of the range's first usage
  for (const HidUsageRange& range : field.usages) {
    const HidUsage& first = range.first;
    if (usage.page == first.page && usage.id >= first.id && usage.id <= range.last_id) {
      index += static_cast<std::uint64_t>(usage.id - first.id);
      if (index >= field.count) {
        return {};
      }
      const auto found = static_cast<std::uint32_t>(index);
      const bool is_last = &range == &field.usages.back() && usage.id == range.last_id;
      return {.first = found, .count = is_last ? field.count - found : 1};
    }
    index += static_cast<std::uint64_t>(range.last_id - first.id) + 1;
  }
  return {};
}

}  // namespace foveola
