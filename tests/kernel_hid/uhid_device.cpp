#include "tests/kernel_hid/uhid_device.h"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <stdexcept>
#include <system_error>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include "tests/waiting.h"

namespace foveola::test {
namespace {

/// How long the thread cannot be stopped.
constexpr int poll_timeout_ms = 20;

/// Copies to the beginning of a field of an event.
template <typename From, std::size_t capacity>
void put(const From& from, std::uint8_t (&to)[capacity]) {
  if (from.size() > capacity) {
    throw std::length_error("more than fits into an event of uhid");
  }
  std::copy(from.begin(), from.end(), to);
}

uhid_event creation_of(const UhidSettings& settings) {
  uhid_event event{};
  event.type = UHID_CREATE2;
  uhid_create2_req& device = event.u.create2;
  put(settings.name, device.name);
  put(settings.serial_number, device.uniq);
  put(settings.report_descriptor, device.rd_data);
  device.rd_size = static_cast<std::uint16_t>(settings.report_descriptor.size());
  device.bus = BUS_USB;
  device.vendor = settings.vendor_id;
  device.product = settings.product_id;
  return event;
}

}  // namespace

UhidDevice::File::File(const char* path) : number_(::open(path, O_RDWR | O_CLOEXEC)) {
  if (number_ < 0) {
    throw std::system_error(errno, std::generic_category(), path);
  }
}

UhidDevice::File::~File() { ::close(number_); }

void UhidDevice::File::write(const uhid_event& event) const {
  if (::write(number_, &event, sizeof event) != static_cast<ssize_t>(sizeof event)) {
    throw std::system_error(errno, std::generic_category(), "an event for uhid");
  }
}

bool UhidDevice::File::read(uhid_event& event) const {
  pollfd waiting{.fd = number_, .events = POLLIN, .revents = 0};
  return ::poll(&waiting, 1, poll_timeout_ms) == 1 && ::read(number_, &event, sizeof event) > 0;
}

UhidDevice::UhidDevice(const UhidSettings& settings) : features_(settings.features) {
  file_.write(creation_of(settings));
  thread_ = std::jthread([this](const std::stop_token& stop) { answer_requests(stop); });
}

void UhidDevice::send(const Bytes& report) const {
  uhid_event event{};
  event.type = UHID_INPUT2;
  uhid_input2_req& input = event.u.input2;
  put(report, input.data);
  input.size = static_cast<std::uint16_t>(report.size());
  file_.write(event);
}

std::vector<std::string> UhidDevice::requests() const {
  const std::lock_guard lock(mutex_);
  return requests_;
}

void UhidDevice::wait_for_request(const std::string& request) const {
  wait_until("the request " + request, [&] {
    const std::lock_guard lock(mutex_);
    return std::find(requests_.begin(), requests_.end(), request) != requests_.end();
  });
}

void UhidDevice::answer_requests(const std::stop_token& stop) {
  uhid_event event{};
  while (!stop.stop_requested()) {
    if (!file_.read(event)) {
      continue;
    }
    if (event.type == UHID_GET_REPORT) {
      answer_get(event.u.get_report);
    } else if (event.type == UHID_SET_REPORT) {
      answer_set(event.u.set_report);
    }
  }
}

void UhidDevice::answer_get(const uhid_get_report_req& request) {
  note("get " + to_hex({request.rnum}));
  uhid_event event{};
  event.type = UHID_GET_REPORT_REPLY;
  uhid_get_report_reply_req& reply = event.u.get_report_reply;
  reply.id = request.id;
  const auto feature = features_.find(request.rnum);
  if (feature == features_.end()) {
    reply.err = EIO;
  } else if (feature->second.empty()) {
    return;
  } else {
    put(feature->second, reply.data);
    reply.size = static_cast<std::uint16_t>(feature->second.size());
  }
  file_.write(event);
}

void UhidDevice::answer_set(const uhid_set_report_req& request) {
  note("set " + to_hex({request.data, request.data + request.size}));
  uhid_event event{};
  event.type = UHID_SET_REPORT_REPLY;
  event.u.set_report_reply.id = request.id;
  file_.write(event);
}

void UhidDevice::note(const std::string& request) {
  const std::lock_guard lock(mutex_);
  requests_.push_back(request);
}

}  // namespace foveola::test
