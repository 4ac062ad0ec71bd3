// Maps pages without access around an array, so that a read or write beyond it ends the process.
#include "validate/probe/guarded.h"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>

#include "validate/probe/check.h"

namespace burin::validate {

Guarded::Guarded(std::span<const float> numbers, Guard guard) {
  const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  // Without a guard there is as much room around the numbers as brushes write beyond arrays by mistake.
  const std::size_t room = guard == Guard::none ? 256 * page : 0;
  const std::size_t middle = (numbers.size_bytes() + page - 1) / page * page + 2 * room;
  bytes_ = middle + 2 * page;
  pages_ = mmap(nullptr, bytes_, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  require(pages_ != MAP_FAILED, "no memory for guarded arrays");
  char* start = static_cast<char*>(pages_) + page;
  require(mprotect(start, middle, PROT_READ | PROT_WRITE) == 0, "no memory for guarded arrays");
  data_ =
      reinterpret_cast<float*>(guard == Guard::behind ? start + middle - numbers.size_bytes() : start + room);
  std::copy(numbers.begin(), numbers.end(), data_);
}

Guarded::~Guarded() { munmap(pages_, bytes_); }

}  // namespace burin::validate
