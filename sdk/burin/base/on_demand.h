#pragma once
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>

namespace burin {

/// A cache of values for the indices 0 .. count - 1. The value of an index must depend on the index alone, so
/// that it does not matter who computes it. Memory is allocated in pages of 256 values when one of them is
/// stored.
///
/// find() and put() may be called on several threads at once. If two threads put the same value at the same
/// time, the cache keeps one of the two.
template <class T>
class OnDemand {
 public:
  static_assert(std::is_trivially_destructible_v<T>);
  OnDemand() = default;
  OnDemand(const OnDemand&) = delete;
  OnDemand& operator=(const OnDemand&) = delete;
  ~OnDemand() { restart(0); }

  /// Forgets all values and sets the number of indices. One thread.
  void restart(std::size_t count) {
    for (std::size_t page = 0; page < page_count_; ++page) delete pages_[page].load();
    page_count_ = (count + page_size - 1) / page_size;
    pages_ = std::make_unique<std::atomic<Page*>[]>(page_count_);
  }

  /// The value of an index, or null if it has not been put.
  const T* find(std::size_t index) const {
    const Page* page = pages_[index / page_size].load(std::memory_order_acquire);
    const std::size_t place = index % page_size;
    if (!page || page->states[place].load(std::memory_order_acquire) != State::made) return nullptr;
    return &page->values[place];
  }

  void put(std::size_t index, const T& value) {
    Page& page = page_of(index / page_size);
    const std::size_t place = index % page_size;
    State nothing = State::nothing;
    if (!page.states[place].compare_exchange_strong(nothing, State::being_kept, std::memory_order_acquire))
      return;
    page.values[place] = value;
    page.states[place].store(State::made, std::memory_order_release);
  }

  /// Forgets the values for which `stale(value)` is true. One thread.
  template <class Stale>
  void forget_if(const Stale& stale) {
    for (std::size_t number = 0; number < page_count_; ++number) {
      Page* const page = pages_[number].load();
      for (std::size_t place = 0; page && place < page_size; ++place)
        if (page->states[place].load() == State::made && stale(page->values[place]))
          page->states[place].store(State::nothing);
    }
  }

 private:
  static constexpr std::size_t page_size = 256;
  enum class State : std::uint8_t { nothing, being_kept, made };
  struct Page {
    std::array<std::atomic<State>, page_size> states{};
    std::array<T, page_size> values;
  };

  Page& page_of(std::size_t number) {
    Page* page = pages_[number].load(std::memory_order_acquire);
    if (page) return *page;
    auto fresh = std::make_unique<Page>();
    if (pages_[number].compare_exchange_strong(page, fresh.get(), std::memory_order_acq_rel))
      return *fresh.release();
    return *page;
  }

  std::size_t page_count_ = 0;
  std::unique_ptr<std::atomic<Page*>[]> pages_;
};

}  // namespace burin
