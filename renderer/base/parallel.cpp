#include "renderer/base/parallel.h"

#include <algorithm>

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#if defined(__SSE2__)
#include <pmmintrin.h>
#endif

namespace foveola {
namespace {

/// Sets flush-to-zero and denormals-are-zero for its lifetime, on its own thread.
class FlushDenormals {
 public:
#if defined(__SSE2__)
  FlushDenormals() : saved_(_mm_getcsr()) {
    _mm_setcsr(saved_ | _MM_FLUSH_ZERO_ON | _MM_DENORMALS_ZERO_ON);
  }
  ~FlushDenormals() { _mm_setcsr(saved_); }
#else
  FlushDenormals() = default;
  ~FlushDenormals() = default;
#endif
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;

#if defined(__SSE2__)
 private:
  unsigned saved_;
#endif
};

}  // namespace

/// The control lifts TBB's own limit, so that four threads on two cores are four threads.
struct Workers::Arena {
  explicit Arena(int threads)
      : control(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads)),
        arena(threads) {}
  tbb::global_control control;
  tbb::task_arena arena;
};

Workers::Workers(int threads)
    : threads_(threads > 0 ? threads : tbb::info::default_concurrency()),
      arena_(std::make_unique<Arena>(threads_)) {}

Workers::~Workers() = default;

void Workers::for_each_block(
    std::size_t count, std::size_t block,
    const std::function<void(std::size_t begin, std::size_t end)>& body) const {
  const std::size_t blocks = (count + block - 1) / block;
  arena_->arena.execute([&] {
    tbb::parallel_for(std::size_t{0}, blocks, [&](std::size_t i) {
      const FlushDenormals flush;
      body(i * block, std::min(count, (i + 1) * block));
    });
  });
}

}  // namespace foveola
