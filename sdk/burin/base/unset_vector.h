#pragma once
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace burin {

/// An allocator that leaves elements uninitialised where std::vector would set them to 0.
template <class T>
struct UnsetAllocator : std::allocator<T> {
  static_assert(std::is_trivially_copyable_v<T>);
  template <class Other>
  struct rebind {
    using other = UnsetAllocator<Other>;
  };
  template <class Element, class... Arguments>
  void construct(Element* place, Arguments&&... arguments) {  ///< or leaves it as it is
    if constexpr (sizeof...(arguments) == 0) {
      ::new (static_cast<void*>(place)) Element;
    } else {
      ::new (static_cast<void*>(place)) Element(std::forward<Arguments>(arguments)...);
    }
  }
};

/// A vector for long arrays that all threads fill: resize() does not touch the memory, so that the threads
/// share the cost of page faults.
template <class T>
using UnsetVector = std::vector<T, UnsetAllocator<T>>;

}  // namespace burin
