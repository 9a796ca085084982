# SPDX-License-Identifier: BSD-3-Clause
# What is compiled for timed runs with the right-hand sides of this folder inlined. The test Inlined.ListsAreComplete
# compares these lists with the files that they name.

# Own methods: those of src/odeum/methods whose file sets `inlined`, which says for which cases.
set(ODEUM_INLINED_METHODS
    bdf_variable blanes_moan6 dormand_nystroem64 dormand_nystroem86 dormand_prince54 dormand_prince853
    exponential_propagator gragg_bulirsch_stoer radau_iia5 radau_iia9 rk4 rodas4 rodas5p seulex taylor
    velocity_verlet verner98)

# Problems on which odeint's steppers are inlined: all that have cases that are not stiff, since these steppers are
# explicit. Its rosenbrock4 is in rosenbrock4.cpp, for the problems that it suits.
set(ODEUM_INLINED_ODEINT hires kepler oscillator pleiades van_der_pol)
