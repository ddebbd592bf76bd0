// The state of a push between two steps, from which it goes on to the same bits.
//
// Each class with a state has one list of its fields, `exchange(archive)`, for both directions. It lists what
// a step reads before it writes it; all else is made anew from the setup.
#pragma once

#include <concepts>
#include <cstring>
#include <map>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace cpt::solver {

/// Values by name, in SI units and the order of the program's own arrays. Whole numbers are exact up to 2^53.
using PushState = std::map<std::string, std::vector<double>>;

/// A state that does not fit: of another setup, or of a program with other fields.
struct StateMismatch : std::runtime_error {
  using std::runtime_error::runtime_error;
};

template <class T>
concept MadeOfDoubles = std::is_trivially_copyable_v<T> && !std::integral<T> &&
                        alignof(T) % alignof(double) == 0 && sizeof(T) % sizeof(double) == 0;

class StateWriter {
 public:
  static constexpr bool reading = false;

  template <class T>
  requires std::is_arithmetic_v<T>
  void operator()(const std::string& name, const T& value) { state_[name] = {static_cast<double>(value)}; }

  template <MadeOfDoubles T>
  void operator()(const std::string& name, const std::vector<T>& values) {
    std::vector<double>& stored = state_[name];
    stored.resize(values.size() * (sizeof(T) / sizeof(double)));
    if (!values.empty()) std::memcpy(stored.data(), values.data(), values.size() * sizeof(T));
  }

  [[nodiscard]] PushState take() { return std::move(state_); }

 private:
  PushState state_;
};

/// Throws StateMismatch for a name that is missing or an array of another size than the one to be filled.
class StateReader {
 public:
  static constexpr bool reading = true;
  explicit StateReader(const PushState& state) : state_(state) {}

  template <class T>
  requires std::is_arithmetic_v<T>
  void operator()(const std::string& name, T& value) { value = static_cast<T>(find(name, 1).front()); }

  template <MadeOfDoubles T>
  void operator()(const std::string& name, std::vector<T>& values) {
    const std::vector<double>& stored = find(name, values.size() * (sizeof(T) / sizeof(double)));
    if (!values.empty())
      std::memcpy(static_cast<void*>(values.data()), stored.data(), values.size() * sizeof(T));
  }

  /// An array of any size.
  [[nodiscard]] const std::vector<double>& find(const std::string& name) const {
    const auto found = state_.find(name);
    if (found == state_.end()) throw StateMismatch("the state of the push has no " + name);
    return found->second;
  }

 private:
  [[nodiscard]] const std::vector<double>& find(const std::string& name, std::size_t size) const {
    const std::vector<double>& stored = find(name);
    if (stored.size() != size) throw StateMismatch("the state of the push has another size of " + name);
    return stored;
  }
  const PushState& state_;
};

}  // namespace cpt::solver
