#include "renderer/film/item_pool.h"

#include <utility>

namespace foveola {
namespace {

/// Zeros whose memory the system allocates at the first write. Throws std::bad_alloc.
HugePage make_huge_page() {
  // A mapping may begin anywhere. Of one twice as long, the aligned part is kept.
  void* const mapped =
      ::mmap(nullptr, 2 * huge_page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (mapped == MAP_FAILED) {
    throw std::bad_alloc();
  }
  auto* const begin = static_cast<std::byte*>(mapped);
  const std::size_t behind = reinterpret_cast<std::uintptr_t>(begin) % huge_page;
  const std::size_t before = behind == 0 ? 0 : huge_page - behind;
  std::byte* const page = begin + before;
  if (before > 0) {
    ::munmap(begin, before);
  }
  ::munmap(page + huge_page, huge_page - before);
  ::madvise(page, huge_page, MADV_HUGEPAGE);  // a hint: its result does not matter
  return HugePage(page);
}

/// Makes the system allocate the memory. Not by madvise, which would block other threads that map
/// or free memory.
void touch(HugePage& page) {
  constexpr std::size_t smallest_page = 4096;
  for (std::size_t offset = 0; offset < huge_page; offset += smallest_page) {
    const_cast<volatile std::byte&>(page[offset]) = std::byte{0};
  }
}

}  // namespace

HugePage HugePages::take() {
  const std::scoped_lock lock(mutex_);
  ++taken_;
  if (ready_.empty()) {
    return make_huge_page();
  }
  HugePage page = std::move(ready_.back());
  ready_.pop_back();
  return page;
}

void HugePages::make_ready() {
  const std::scoped_lock lock(mutex_);
  if (taken_ <= taken_without_thread || ready_.size() == max_ready) {
    return;
  }
  if (!maker_.joinable()) {
    maker_ = std::jthread([this](const std::stop_token& stop) { make_pages(stop); });
  }
  are_wanted_.notify_one();
}

std::size_t HugePages::ready() const {
  const std::scoped_lock lock(mutex_);
  return ready_.size();
}

void HugePages::make_pages(const std::stop_token& stop) {
  try {
    std::unique_lock lock(mutex_);
    const auto lacks_some = [this] { return ready_.size() < max_ready; };
    while (are_wanted_.wait(lock, stop, lacks_some) && !stop.stop_requested()) {
      lock.unlock();
      HugePage page = make_huge_page();
      touch(page);
      lock.lock();
      ready_.push_back(std::move(page));
    }
  } catch (const std::bad_alloc&) {
    // Notifies takers of the next page.
  }
}

}  // namespace foveola
