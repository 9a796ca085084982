// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>

#include "odeum/kernel/explicit_rk.hpp"

namespace odeum::methods {

/// Dormand and Prince's method of order 8 in twelve stages, with the embedded rows of order 5
/// (here) and 3 (below) of Hairer, Norsett and Wanner's DOP853.
inline constexpr Tableau<12> dormand_prince853_tableau{
    .a = {{{0},
           {0.052600151958767731879},
           {0.019725056984537899454, 0.059175170953613698363},
           {0.029587585476806849182, 0, 0.088762756430420547545},
           {0.2413651341592666855, 0, -0.88454947932828608534, 0.92483400326179200312},
           {0.037037037037037037037, 0, 0, 0.17082860872947387128, 0.12546768756682242502},
           {19. / 512, 0, 0, 0.17025221101954403931, 0.060216538980455960685, -9. / 512},
           {0.037092000118504792711, 0, 0, 0.17038392571223999381, 0.10726203044637328465,
            -0.015319437748624401753, 8.2737891638140228876e-3},
           {0.62411095871607571711, 0, 0, -3.3608926294469412941, -0.86821934684172600682,
            27.592099699446708305, 20.154067550477893409, -43.489884181069958848},
           {0.47766253643826436589, 0, 0, -2.4881146199716676419, -0.59029082683684299637,
            21.230051448181194235, 15.279233632882423583, -33.288210968984862919,
            -0.020331201708508626136},
           {-0.93714243008598732572, 0, 0, 5.1863724288440637083, 1.0914373489967295782,
            -8.1497870107469261251, -18.520065659996959864, 22.739487099350504282,
            2.4936055526796523899, -3.0467644718982195004},
           {2.2733101475165382079, 0, 0, -10.534495466737250198, -2.0008720582248624991,
            -17.958931863118798917, 27.948884529419960051, -2.8589982771350236947,
            -8.8728569335306295443, 12.360567175794303065, 0.64339274601576353036}}},
    .b = {0.054293734116568762238, 0, 0, 0, 0, 4.4503128927524088814, 1.891517899314500383,
          -5.8012039600105847815, 0.31116436695781989441, -0.15216094966251607856,
          0.20136540080403034837, 0.044710615727772590518},
    .order = 8,
    .b_hat = {0.041173689122373881506, 0, 0, 0, 0, 5.6754693391286133222, 2.3872768489717505746,
              -7.4655811424655713184, 0.6614932157077935761, -0.48634006837553355759,
              0.11944219431891463591, 0.067065923591658885777},
    .order_hat = 5,
};
static_assert(proven<dormand_prince853_tableau>());

inline constexpr std::array<double, 12> dormand_prince853_third_order = {
    0.24409448818897637795, 0, 0, 0, 0, 0, 0, 0, 0.73384668828161185734, 0, 0,
    0.022058823529411764706};
static_assert(row_proven<dormand_prince853_tableau, dormand_prince853_third_order, 3>());

/// The solution has order 8. The error estimate is e5 |e5| / sqrt(|e5|^2 + 0.01 |e3|^2), with norms
/// that weigh a component by 1 / (1 + |y|); it is of size h^6 h^6 / h^4 = h^8, as of an embedded
/// row of order 7.
struct dormand_prince853 : ForAnyProblem, TableauMethod<dormand_prince853_tableau> {
  static constexpr MethodInfo info{
      .id = "dormand_prince853",
      .family = "explicit_rk",
      .order = dormand_prince853_tableau.order,
      .order_embedded = 7,
      .source = "Hairer, Norsett, Wanner, Solving ODEs I, II.5 (DOP853) and II.10, (10.17)"};
  static constexpr auto inlined = Inlined::nonstiff;

  template <class P>
  class Stepper {
   public:
    using Real = RealOf<P>;
    explicit Stepper(const P& problem)
        : rk_(problem), third_(make_state(problem)), before_(third_) {}

    Status step(Real t, Real h, State<P>& y) { return rk_.step(t, h, y); }

    Status step(Real t, Real h, State<P>& y, State<P>& error) {
      copy_components(y, before_);
      const Status status = rk_.step(t, h, y, error);
      rk_.template weighted_sum<third_order_difference>(h, third_);
      using std::abs, std::max, std::sqrt;
      Real five = 0, three = 0;
      each_component(y, [&](std::size_t i) {
        const Real weight = 1 / (1 + max(abs(before_[i]), abs(y[i])));
        five += weight * error[i] * (weight * error[i]);
        three += weight * third_[i] * (weight * third_[i]);
      });
      const Real both = five + 0.01 * three, share = select(both > 0, sqrt(five / both), Real(1));
      each_component(y, [&](std::size_t i) { error[i] *= share; });
      return status;
    }
    void advance() { rk_.advance(); }
    void repeat() { rk_.repeat(); }
    void forget() { rk_.forget(); }
    const State<P>& first_stage() const { return rk_.first_stage(); }
    State<P>& first_stage() { return rk_.first_stage(); }

   private:
    static constexpr std::array<double, 12> third_order_difference = [] {
      std::array<double, 12> row{};
      for (std::size_t i = 0; i < 12; ++i)
        row[i] = dormand_prince853_tableau.b[i] - dormand_prince853_third_order[i];
      return row;
    }();
    ExplicitRungeKutta<dormand_prince853_tableau, P> rk_;
    State<P> third_, before_;
  };
};

}  // namespace odeum::methods
