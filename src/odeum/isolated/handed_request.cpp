// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/isolated/handed_request.hpp"

#include <cstring>
#include <type_traits>
#include <utility>

namespace odeum::isolated {
namespace {

class Writer {
 public:
  template <class T>
  void operator()(const T& value) requires std::is_trivially_copyable_v<T> {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void operator()(const std::vector<double>& values) {
    (*this)(values.size());
    bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(double));
  }
  void operator()(const std::string& text) {
    (*this)(text.size());
    bytes += text;
  }
  std::string bytes;
};

class Reader {
 public:
  explicit Reader(const char* from) : at_(from) {}
  template <class T>
  void operator()(T& value) requires std::is_trivially_copyable_v<T> {
    take(&value, sizeof value);
  }
  void operator()(std::vector<double>& values) {
    values.resize(size());
    take(values.data(), values.size() * sizeof(double));
  }
  void operator()(std::string& text) {
    text.resize(size());
    take(text.data(), text.size());
  }
  std::size_t size() {
    std::size_t n = 0;
    (*this)(n);
    return n;
  }

 private:
  void take(void* to, std::size_t n) {
    if (n > 0) std::memcpy(to, at_, n);
    at_ += n;
  }
  const char* at_;
};

}  // namespace

std::string bytes_of(const Request& request) {
  // A member that is added does not compile here until it is handed over, too.
  const auto& [mode, steps, tolerance, stops, over_stops, record_steps, budget, options] = request;
  Writer write;
  write(mode);
  write(steps);
  write(tolerance.relative);
  write(tolerance.thresholds);
  write(tolerance.absolutes());
  write(stops);
  write(over_stops);
  write(record_steps);
  write(budget);
  write(options.size());
  for (const auto& [name, value] : options) {
    write(name);
    write(value);
  }
  return std::move(write.bytes);
}

Request request_of(const char* bytes) {
  Reader read(bytes);
  Request request;
  read(request.mode);
  read(request.steps);
  double relative = 0;
  std::vector<double> thresholds, absolutes;
  read(relative);
  read(thresholds);
  read(absolutes);
  request.tolerance = Tolerance(relative, std::move(absolutes));
  request.tolerance.thresholds = std::move(thresholds);  // not rounded once more
  read(request.stops);
  read(request.over_stops);
  read(request.record_steps);
  read(request.budget);
  for (std::size_t n = read.size(); n > 0; --n) {
    std::string name;
    read(name);
    read(request.options[name]);
  }
  return request;
}

}  // namespace odeum::isolated
