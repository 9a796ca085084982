// SPDX-License-Identifier: BSD-3-Clause
// A run of ten times as many steps allocates as much memory as a short one: none for a step.
#include <odeum/api/integrate.hpp>
#include <odeum/methods/dormand_prince54.hpp>
#include <odeum/methods/rk4.hpp>
#include <odeum/methods/rodas4.hpp>
#include <odeum/methods/velocity_verlet.hpp>

#include <cstdio>
#include <cstdlib>
#include <new>
#include <vector>

static std::size_t allocations = 0;
void* operator new(std::size_t size) {
  ++allocations;
  if (void* p = std::malloc(size)) return p;
  throw std::bad_alloc();
}
void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }

/// A row of oscillators whose number is known at run time.
struct Row {
  static constexpr std::size_t dimension = odeum::dynamic;
  static constexpr bool velocity_dependent = false;
  std::size_t size() const { return 6; }
  void acceleration(double, const double* q, const double*, double* a) const {
    for (std::size_t i = 0; i < 3; ++i) a[i] = -static_cast<double>(i + 1) * q[i];
  }
  void rhs(double t, const double* y, double* dydt) const {
    for (std::size_t i = 0; i < 3; ++i) dydt[i] = y[3 + i];
    acceleration(t, y, y + 3, dydt + 3);
  }
};

template <class Method, class Steps>
bool allocates_no_step(const char* name, Steps steps) {
  const auto count = [&](double end) {
    std::vector<double> y(6, 1.0);
    double sum = 0;
    std::vector<double> times;
    for (int i = 0; i < 1000; ++i) times.push_back(i * end / 1000);
    const std::size_t before = allocations;
    odeum::integrate(Row{}, Method{}, y, 0, end, steps,
                     odeum::at_times(std::move(times), [&](double, const auto& x) { sum += x[0]; }),
                     odeum::each_step([&](double, const auto& x) { sum += x[1]; }),
                     odeum::until_event([](double, const auto&) { return 1.0; }));
    return allocations - before;
  };
  const std::size_t few = count(1), many = count(10);
  if (few != many) std::printf("%s: %zu allocations, and %zu\n", name, few, many);
  return few == many;
}

int main() {
  using namespace odeum::methods;
  bool none = allocates_no_step<rk4>("rk4", odeum::Step{0.01});
  none = allocates_no_step<velocity_verlet>("velocity_verlet", odeum::Step{0.01}) && none;
  none = allocates_no_step<dormand_prince54>("dormand_prince54", odeum::Tolerance{1e-6}) && none;
  none = allocates_no_step<rodas4>("rodas4", odeum::Tolerance{1e-6}) && none;
  return none ? 0 : 1;
}
