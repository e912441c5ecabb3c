// An array for searches that may see little of a large map.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>

namespace taut::pursuit::detail {

/// Unsigned numbers, each the largest until it is set. Kept inverted in memory that is zero to begin with, which an
/// operating system hands out page by page as it is written: what is never set costs nothing.
template <typename T>
class HighArray {
  static_assert(std::is_unsigned_v<T>);

 public:
  HighArray() = default;
  explicit HighArray(std::size_t size) : values_(static_cast<T*>(std::calloc(size, sizeof(T)))) {
    if (!values_ && size > 0) throw std::bad_alloc();
  }

  bool empty() const { return !values_; }
  T operator[](std::size_t i) const { return static_cast<T>(~values_.get()[i]); }
  void set(std::size_t i, T value) { values_.get()[i] = static_cast<T>(~value); }

 private:
  struct Free {
    void operator()(T* values) const { std::free(values); }
  };
  std::unique_ptr<T, Free> values_;
};

}  // namespace taut::pursuit::detail
