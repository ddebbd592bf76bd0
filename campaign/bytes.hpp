// Plain binary packing for messages between processes of the same program on the same kind of machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace cpt::campaign {

using Bytes = std::vector<std::byte>;

/// Received bytes that are no message of ours.
struct MalformedMessage : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Appends values; numbers keep every bit.
class ByteWriter {
 public:
  template <class... T>
  void operator()(const T&... values) {
    (put(values), ...);
  }
  [[nodiscard]] Bytes take() { return std::move(bytes_); }

 private:
  void append(const void* data, std::size_t size) {
    const auto* first = static_cast<const std::byte*>(data);
    bytes_.insert(bytes_.end(), first, first + size);
  }
  template <class T>
  requires std::is_trivially_copyable_v<T>
  void put(const T& value) { append(&value, sizeof value); }
  template <class T>
  requires std::is_trivially_copyable_v<T>
  void put(const std::vector<T>& values) {
    put(static_cast<std::uint64_t>(values.size()));
    append(values.data(), values.size() * sizeof(T));
  }
  void put(const std::string& text) {
    put(static_cast<std::uint64_t>(text.size()));
    append(text.data(), text.size());
  }

  Bytes bytes_;
};

/// Takes values in the order they were written; throws MalformedMessage if there are too few or too many
/// bytes.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::byte> bytes) : rest_(bytes) {}

  template <class... T>
  void operator()(T&... values) {
    (get(values), ...);
  }
  void expect_end() const {
    if (!rest_.empty()) throw MalformedMessage("message is longer than its content");
  }

 private:
  void extract(void* data, std::size_t size) {
    if (size > rest_.size()) throw MalformedMessage("message ends early");
    if (size > 0) std::memcpy(data, rest_.data(), size);
    rest_ = rest_.subspan(size);
  }
  std::size_t count(std::size_t element_size) {
    std::uint64_t n = 0;
    get(n);
    if (n > rest_.size() / element_size) throw MalformedMessage("message ends early");
    return static_cast<std::size_t>(n);
  }
  template <class T>
  requires std::is_trivially_copyable_v<T>
  void get(T& value) { extract(&value, sizeof value); }
  template <class T>
  requires std::is_trivially_copyable_v<T>
  void get(std::vector<T>& values) {
    values.resize(count(sizeof(T)));
    extract(values.data(), values.size() * sizeof(T));
  }
  void get(std::string& text) {
    text.resize(count(1));
    extract(text.data(), text.size());
  }

  std::span<const std::byte> rest_;
};

}  // namespace cpt::campaign
