// Arrays that every iteration reads from end to end. Their pages are large where the system has such (2 MB in the place
// of 4 kB, on Linux): the processor finds 512 times as much with one entry of its table of pages, and does not wait for
// that table where matrices no longer fit into its caches.
#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

namespace sim {

template <class T>
struct LargePages {
  using value_type = T;
  static constexpr std::size_t page = std::size_t{1} << 21;  // [bytes]; smaller arrays are placed as any other

  LargePages() = default;
  template <class U>
  LargePages(const LargePages<U>&) {}

  // Throws std::bad_alloc where there is no memory.
  T* allocate(std::size_t count) {
    const std::size_t bytes = count * sizeof(T);
    if (bytes < page) return static_cast<T*>(::operator new(bytes, std::align_val_t(alignof(T))));
    void* place = std::aligned_alloc(page, (bytes + page - 1) / page * page);
    if (place == nullptr) throw std::bad_alloc();
    // What is left of the last page stays in small ones. A system that has no large pages says no: all is as before.
    madvise(place, bytes / page * page, MADV_HUGEPAGE);
    return static_cast<T*>(place);
  }
  void deallocate(T* place, std::size_t count) {
    if (count * sizeof(T) < page)
      ::operator delete(place, std::align_val_t(alignof(T)));
    else
      std::free(place);
  }
  bool operator==(const LargePages&) const = default;
};

template <class T>
using LargeArray = std::vector<T, LargePages<T>>;

}  // namespace sim
