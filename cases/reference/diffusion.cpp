// SPDX-License-Identifier: BSD-3-Clause
// Writes brusselator_1d.csv or medakzo.csv: the problems of cases/brusselator_1d.cpp and
// cases/medakzo.cpp with their data rounded to double as there.
//
// Taylor series of order 24 in extended precision (64 bits), coefficients by the recurrences of the
// equations; independent of Odeum's code. The argument `rk4` takes the classical Runge-Kutta method
// instead, whose error is what the two differ by. It takes some minutes and is not part of the
// build:
//     g++ -std=c++20 -O3 diffusion.cpp && ./a.out brusselator_1d 30000 > brusselator_1d.csv
//     ./a.out medakzo 12000 > medakzo.csv
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

using Real = long double;
constexpr int order = 24;

/// u and v by cell; both species react by u^2 v or u v and have their own transport:
/// left u_{i-1} + middle u_i + right u_{i+1} with given values beyond the ends.
struct System {
  int n;
  bool brusselator;
  std::vector<double> left, middle, right;  // of u
  double c;                                 // of v: c (v_{i-1} - 2 v_i + v_{i+1})
  double u_before, u_after, v_ends;         // u_after < 0: the same as the last u
};

System brusselator() {
  constexpr int n = 500;
  const double c = 0.02 * ((n + 1) * (n + 1));
  System s{n, true, {}, {}, {}, c, 1, 1, 3};
  s.left.assign(n, c), s.middle.assign(n, -2 * c), s.right.assign(n, c);
  return s;
}

System medakzo() {
  constexpr int n = 200;
  System s{n, false, {}, {}, {}, 0, 2, -1, 0};
  for (int j = 1; j <= n; ++j) {
    const double z = static_cast<double>(j) / n - 1;
    const double alpha = 2 * z * z * z / 16, beta = z * z * z * z / 16;
    s.left.push_back(beta * n * n - alpha * n / 2);
    s.middle.push_back(-2 * beta * n * n);
    s.right.push_back(beta * n * n + alpha * n / 2);
  }
  return s;
}

using Row = std::vector<Real>;

/// f of the k-th coefficients, where reaction holds those of u^2 v or 100 u v.
void rates(const System& s, const Row& u, const Row& v, const Row& reaction, bool constant, Row& fu,
           Row& fv) {
  const int n = s.n;
  for (int i = 0; i < n; ++i) {
    const Real beyond_left = constant ? s.u_before : 0;
    const Real beyond_right = s.u_after < 0 ? u[n - 1] : constant ? s.u_after : 0;
    fu[i] = s.left[i] * (i > 0 ? u[i - 1] : beyond_left) + s.middle[i] * u[i] +
            s.right[i] * (i + 1 < n ? u[i + 1] : beyond_right);
    if (s.brusselator) {
      const Real ends = constant ? s.v_ends : 0;
      const Real vl = i > 0 ? v[i - 1] : ends, vr = i + 1 < n ? v[i + 1] : ends;
      fu[i] += (constant ? 1 : 0) + reaction[i] - 4 * u[i];
      fv[i] = s.c * (vl - 2 * v[i] + vr) + 3 * u[i] - reaction[i];
    } else {
      fu[i] -= reaction[i];
      fv[i] = -reaction[i];
    }
  }
}

void taylor_step(const System& s, Real h, Row& u, Row& v) {
  static std::vector<Row> us(order + 1, Row(s.n)), vs(us), squares(us);
  static Row reaction(s.n), fu(s.n), fv(s.n);
  us[0] = u, vs[0] = v;
  for (int k = 0; k < order; ++k) {
    for (int i = 0; i < s.n; ++i) reaction[i] = 0;
    if (s.brusselator) {
      for (int i = 0; i < s.n; ++i) squares[k][i] = 0;
      for (int j = 0; j <= k; ++j)
        for (int i = 0; i < s.n; ++i) squares[k][i] += us[j][i] * us[k - j][i];
    }
    for (int j = 0; j <= k; ++j)
      for (int i = 0; i < s.n; ++i)
        reaction[i] += (s.brusselator ? squares[j][i] : 100 * us[j][i]) * vs[k - j][i];
    rates(s, us[k], vs[k], reaction, k == 0, fu, fv);
    for (int i = 0; i < s.n; ++i) us[k + 1][i] = fu[i] / (k + 1), vs[k + 1][i] = fv[i] / (k + 1);
  }
  for (int i = 0; i < s.n; ++i) {
    Real a = us[order][i], b = vs[order][i];
    for (int k = order; k-- > 0;) a = a * h + us[k][i], b = b * h + vs[k][i];
    u[i] = a, v[i] = b;
  }
}

void rk4_step(const System& s, Real h, Row& u, Row& v) {
  static Row reaction(s.n), fu(s.n), fv(s.n);
  Row a = u, b = v, sum_u(s.n), sum_v(s.n);
  for (int stage = 0; stage < 4; ++stage) {
    for (int i = 0; i < s.n; ++i) reaction[i] = (s.brusselator ? a[i] * a[i] : 100 * a[i]) * b[i];
    rates(s, a, b, reaction, true, fu, fv);
    const Real weight = stage == 0 || stage == 3 ? 1 : 2, next = stage == 2 ? h : h / 2;
    for (int i = 0; i < s.n; ++i) {
      sum_u[i] += weight * fu[i], sum_v[i] += weight * fv[i];
      a[i] = u[i] + next * fu[i], b[i] = v[i] + next * fv[i];
    }
  }
  for (int i = 0; i < s.n; ++i) u[i] += h / 6 * sum_u[i], v[i] += h / 6 * sum_v[i];
}

/// Below the range of double: zero.
Real shown(Real x) { return std::abs(x) < 1e-300L ? 0 : x; }

int main(int count, char** words) {
  const bool first = count > 1 && std::strcmp(words[1], "brusselator_1d") == 0;
  const long steps = count > 2 ? std::atol(words[2]) : 30000;
  const bool rk4 = count > 3;
  const System s = first ? brusselator() : medakzo();
  const double end = first ? 10 : 5;
  const long stops = 5;
  Row u(s.n, 0), v(s.n, first ? 3 : 1);
  if (first)
    for (int i = 0; i < s.n; ++i)
      u[i] = 1 + std::sin(2 * 3.14159265358979323846 * ((i + 1.0) / (s.n + 1)));
  std::puts("t,component,value");
  for (long k = 1; k <= steps; ++k) {
    (rk4 ? rk4_step : taylor_step)(s, static_cast<Real>(end) / steps, u, v);
    if (k * stops % steps != 0) continue;
    for (int i = 0; i < s.n; ++i) {
      std::printf("%g,%d,%.21Lg\n", end * k / steps, 2 * i, shown(u[i]));
      std::printf("%g,%d,%.21Lg\n", end * k / steps, 2 * i + 1, shown(v[i]));
    }
  }
}
