#include "renderer/base/freed_memory.h"

#include <cstdlib>
#include <limits>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace foveola {

void keep_freed_memory() {
#if defined(__GLIBC__)
  // All from one heap, which never shrinks: the heaps of other threads cannot hold what is large.
  mallopt(M_ARENA_MAX, 1);
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
#endif
}

}  // namespace foveola
