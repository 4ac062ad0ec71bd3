#pragma once
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace burin {

/// Leaves numbers unset that a vector would set to 0.
template <class T>
struct UnsetAllocator : std::allocator<T> {
  static_assert(std::is_trivially_copyable_v<T>);
  template <class Other>
  struct rebind {
    using other = UnsetAllocator<Other>;
  };
  template <class Element, class... Arguments>
  void construct(Element* place, Arguments&&... arguments) {
    if constexpr (sizeof...(arguments) == 0) {
      ::new (static_cast<void*>(place)) Element;
    } else {
      ::new (static_cast<void*>(place)) Element(std::forward<Arguments>(arguments)...);
    }
  }
};

/// For long arrays that all threads fill: resize() touches no memory, so that threads share the cost of
/// getting it from the system.
template <class T>
using UnsetVector = std::vector<T, UnsetAllocator<T>>;

}  // namespace burin
