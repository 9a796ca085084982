// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <numbers>

#include "odeum/methods/tsitouras54.hpp"
#include "odeum/tableau/order_conditions.hpp"
#include "odeum/tableau/tableau.hpp"

/// Default tables of ARKODE in SUNDIALS 7.3.0 that 6.4.1 does not have, under the names of its
/// enumerations (odeum/verner98 is VERNER_16_8_9): they run on 6.4.1 as tables of the user.
namespace odeum::adapters::sundials {

/// As proven(), for coefficients whose size lets their rounding to double leave a residual of up to
/// `rounding`; one of the next order is 4e-7 and more.
template <const auto& table>
consteval bool proven_within(double rounding) {
  const auto holds = [&]<int order>(const auto& row, std::integral_constant<int, order>) {
    FaultSearch search{.order = order, .rounding = rounding};
    for_each_condition<order + 1>(table, row, [&](std::size_t tau, double residual) {
      search.take(WeightRow::b, rooted_trees<order + 1>.nodes[tau], tau, residual);
    });
    return search.result().order == 0;
  };
  return holds(table.b, std::integral_constant<int, table.order>()) &&
         holds(table.b_hat, std::integral_constant<int, table.order_hat>());
}

/// Ralston, Math. Comp. 16 (1962) 431-437: the method of order 2 of least error. The row of order 1
/// is that of the guide of ARKODE 6.3.0 (SUNDIALS 7.3.0).
inline constexpr Tableau<3> ralston_3_1_2{
    .a = {{{0}, {2. / 3}, {1. / 4, 3. / 4}}},
    .b = {1. / 4, 3. / 4},
    .order = 2,
    .b_hat = {5. / 37, 2. / 3, 22. / 111},
    .order_hat = 1,
};
static_assert(proven<ralston_3_1_2>());

/// Sofroniou, Spaletta, Math. Comput. Modelling 40 (2004) 1157-1169: a pair 4(3), first same as
/// last.
inline constexpr Tableau<5> sofroniou_spaletta_5_3_4{
    .a = {{{0},
           {2. / 5},
           {-3. / 20, 3. / 4},
           {19. / 44, -15. / 44, 10. / 11},
           {11. / 72, 25. / 72, 25. / 72, 11. / 72}}},
    .b = {11. / 72, 25. / 72, 25. / 72, 11. / 72},
    .order = 4,
    .b_hat = {1251515. / 8970912, 3710105. / 8970912, 2519695. / 8970912, 61105. / 8970912,
              119041. / 747576},
    .order_hat = 3,
};
static_assert(proven<sofroniou_spaletta_5_3_4>());

/// Tsitouras's pair 5(4) with an error estimate that is 1.65 times that of odeum/tsitouras54: the
/// last weight of the row of order 4 is 1/40 in the guide, not 1/66.
inline constexpr Tableau<7> tsitouras_7_4_5 = [] {
  Tableau<7> table = methods::tsitouras54_tableau;
  for (std::size_t i = 0; i < table.stages; ++i)
    table.b_hat[i] = table.b[i] + 66. / 40 * (table.b_hat[i] - table.b[i]);
  return table;
}();
static_assert(proven<tsitouras_7_4_5>());

/// Giraldo, Kelly, Constantinescu, SIAM J. Sci. Comput. 35 (2013) B1162-B1194: the implicit half of
/// ARK2, L-stable and stiffly accurate.
inline constexpr Tableau<3> ark2_dirk_3_1_2 = [] {
  constexpr double root = std::numbers::sqrt2, gamma = 1 - root / 2, delta = root / 4;
  return Tableau<3>{.a = {{{0}, {gamma, gamma}, {delta, delta, gamma}}},
                    .b = {delta, delta, gamma},
                    .order = 2,
                    .b_hat = {(4 - root) / 8, (4 - root) / 8, delta},
                    .order_hat = 1};
}();
static_assert(proven<ark2_dirk_3_1_2>());

/// Verner, Numer. Algorithms 53 (2010) 383-396: the most efficient pair 6(5), IIIXb on his page of
/// pairs (RKV65.IIIXb.Efficient.00000144617); weights of 176 leave a residual of 3e-11.
inline constexpr Tableau<9> verner_9_5_6{
    .a = {{{0},
           {3. / 50},
           {519479. / 27000000, 2070721. / 27000000},
           {1439. / 40000, 0, 4317. / 40000},
           {1.3186834152331482609, 0, -5.0420580636285622254, 4.2206746483954139645},
           {-41.872591664327514618, 0, 159.43256216313749177, -122.11921356501003092,
            5.5317430662000537683},
           {-54.430156935316504333, 0, 207.06725136501846443, -158.61081378458999918,
            6.9918165859502423220, -0.018597231062203233978},
           {-54.663741787281976802, 0, 207.95280625538937345, -159.28895747449950715,
            7.0187437407969444347, -0.018338785905045723065, -0.00051194849978820990779},
           {0.034389578683570360093, 0, 0, 0.25826245556335034047, 0.42093711896735371506,
            4.4053964696693101701, -176.48311902429865762, 172.36413340141507303}}},
    .b = {0.034389578683570360093, 0, 0, 0.25826245556335034047, 0.42093711896735371506,
          4.4053964696693101701, -176.48311902429865762, 172.36413340141507303},
    .order = 6,
    .b_hat = {0.049099676483824897309, 0, 0, 0.22511122295165241534, 0.46946822530295620394,
              0.80657922499888677076, 0, -0.60711948917779597977, 0.056861139440475692411},
    .order_hat = 5,
};
static_assert(proven_within<verner_9_5_6>(1e-10));

/// Verner, the same: the most efficient pair 7(6) (RKV76.IIa.Efficient.00001675585).
inline constexpr Tableau<10> verner_10_6_7{
    .a = {{{0},
           {1. / 200},
           {-4361. / 4050, 2401. / 2025},
           {49. / 1200, 0, 49. / 400},
           {0.63891392362557267805, 0, -2.4556726382236568097, 2.2722587145980841316},
           {-2.6615773750187571311, 0, 10.804513886456137696, -8.3539146573961994120,
            0.82048759495665697914},
           {6.0677414346967709927, 0, -24.711273635911085797, 20.427517930788893940,
            -1.9061579788166471506, 1.0061722492420680148},
           {12.054670076253202995, 0, -49.754784950468989328, 41.142888638604676633,
            -4.4617601499740041856, 2.0423348222391749598, -0.098348436654061073795},
           {10.138146522881807876, 0, -42.641136031717502146, 35.763840039922570071,
            -4.3480228403929076533, 2.0098622683770358954, 0.34874904603382724060,
            -0.27143900510483128424},
           {-45.030072034298677124, 0, 187.32724376545888408, -154.02882369350186906,
            18.564653063475362339, -7.1418096792950788549, 1.3088085781613786251}}},
    .b = {0.047155618486272221704, 0, 0, 0.25750564298434151896, 0.26216653977412620477,
          0.15216092656738557403, 0.49399691700324842469, -0.29430311714032504416,
          0.081317472324951099997},
    .order = 7,
    .b_hat = {0.044608606606341176287, 0, 0, 0.26716403785713726805, 0.22010183001772930200,
              0.21884317031431568310, 0.22898717054112028834, 0, 0, 0.020295184663356282228},
    .order_hat = 6,
};
static_assert(proven<verner_10_6_7>());

/// Verner, the same: the most efficient pair 8(7) (RKV87.IIa.Efficient.000000282866); weights of 32
/// and coefficients of 123 leave a residual of 6e-13.
inline constexpr Tableau<13> verner_13_7_8{
    .a = {{{0},
           {1. / 20},
           {-7161. / 1024000, 116281. / 1024000},
           {1023. / 25600, 0, 3069. / 25600},
           {4202367. / 11628100, 0, -3899844. / 2907025, 3982992. / 2907025},
           {5611. / 114400, 0, 0, 31744. / 135025, 923521. / 5106400},
           {21173. / 343200, 0, 0, 8602624. / 76559175, -0.038850460714513667670, 5611. / 283500},
           {-1.7676302402223268757, 0, 0, -125. / 2, -6.0618893773766691008, 5.6508231982227631386,
            65.621696419376232838},
           {-1.1809450665549707998, 0, 0, -41.504734411143208416, -4.4344383191037250112,
            4.2604081885861330248, 43.753640224461715850, 0.0078714254899123106874},
           {-1.2814059994414884055, 0, 0, -45.047139960139866302, -4.7313620694495764773,
            4.5149670165938078412, 47.449095571729851349, 0.010592282971116611357,
            -0.0057468422638446162544},
           {-1.7244701342624851918, 0, 0, -60.923490084830540165, -5.9515183762223924552,
            5.5565237306984562360, 63.983011980333053368, 0.014642028250414961593,
            0.064604087723582036036, -0.079303231690088789840},
           {-3.3016226677470790164, 0, 0, -118.01127235975250857, -10.141422388456112486,
            9.1393113322320579235, 123.37594282840426837, 4.6232443788745804748,
            -3.3832777380682019237, 4.5275921003246181895, -5.8284954858116229632},
           {-3.0395150337663090300, 0, 0, -109.26086808941762547, -9.2906424974002934497,
            8.4305049817649111421, 114.20100103783313136, -0.96372713421454793582,
            -5.0348840888021897912, 5.9581308240029231775}}},
    .b = {0.044279894190079510747, 0, 0, 0, 0, 0.35410493917244487448, 0.24796921549564378287,
          -15.694202038838084051, 25.084064965558562613, -31.738367786260276468,
          22.938283273988783952, -0.23613246330715421453},
    .order = 8,
    .b_hat = {0.044312615229089792125, 0, 0, 0, 0, 0.35460956423432264479, 0.24784804313666530696,
              4.4481347324757844927, 19.846886366118733699, -23.581623377465618420, 0, 0,
              -0.36016794372897751621},
    .order_hat = 7,
};
static_assert(proven_within<verner_13_7_8>(1e-11));

}  // namespace odeum::adapters::sundials
