! SPDX-License-Identifier: BSD-3-Clause
! Heun's method in Fortran: the structures of odeum/plugin.h, as far as a solver needs them.
module my_heun
  use, intrinsic :: iso_c_binding
  implicit none

  type, bind(c) :: odeum_system
    integer(c_size_t) :: dimension
    type(c_ptr) :: data
    type(c_funptr) :: rhs, jacobian, time_derivative
    integer(c_size_t) :: degrees_of_freedom
    integer(c_int) :: velocity_dependent
    type(c_funptr) :: acceleration
  end type
  type, bind(c) :: odeum_solver
    type(c_ptr) :: name, family, source
    real(c_double) :: order
    integer(c_int32_t) :: needs
    type(c_funptr) :: create, step, solve, steps, destroy
  end type
  type, bind(c) :: odeum_plugin
    integer(c_int32_t) :: version
    type(c_ptr) :: name
    integer(c_size_t) :: solver_count
    type(c_ptr) :: solvers
    integer(c_size_t) :: problem_count
    type(c_ptr) :: problems
  end type
  abstract interface
    function right_hand_side(data, t, y, dydt) bind(c)
      import :: c_ptr, c_double, c_int
      type(c_ptr), value :: data
      real(c_double), value :: t
      real(c_double), intent(in) :: y(*)
      real(c_double), intent(out) :: dydt(*)
      integer(c_int) :: right_hand_side
    end function
  end interface

  character(kind=c_char), target :: plugin_name(8) = ['f', 'o', 'r', 't', 'r', 'a', 'n', c_null_char]
  character(kind=c_char), target :: solver_name(5) = ['h', 'e', 'u', 'n', c_null_char]
  type(odeum_system), pointer :: system
  procedure(right_hand_side), pointer :: f
  type(odeum_solver), target :: solver
  type(odeum_plugin), target :: plugin

contains

  ! A name of its own: a function `step` would be that of the C library.

  function create(given, t0, y0) bind(c, name='my_heun_create') result(self)
    type(c_ptr), value :: given
    real(c_double), value :: t0
    real(c_double), intent(in) :: y0(*)
    type(c_ptr) :: self
    call c_f_pointer(given, system)
    call c_f_procpointer(system%rhs, f)
    self = given
    if (t0 /= t0 .or. y0(1) /= y0(1)) self = c_null_ptr
  end function

  function step(self, t, h, y) bind(c, name='my_heun_step') result(answer)
    type(c_ptr), value :: self
    real(c_double), value :: t, h
    real(c_double), intent(inout) :: y(*)
    integer(c_int) :: answer
    real(c_double) :: k1(system%dimension), k2(system%dimension)
    integer :: n
    n = int(system%dimension)
    answer = 1
    if (.not. c_associated(self)) return
    if (f(system%data, t, y, k1) /= 0) return
    if (f(system%data, t + h, y(1:n) + h * k1, k2) /= 0) return
    y(1:n) = y(1:n) + h / 2 * (k1 + k2)
    answer = 0
  end function

  function odeum_plugin_entry() bind(c) result(described)
    type(c_ptr) :: described
    solver = odeum_solver(c_loc(solver_name), c_null_ptr, c_null_ptr, 2.0_c_double, 0, &
                          c_funloc(create), c_funloc(step), c_null_funptr, c_null_funptr, c_null_funptr)
    plugin = odeum_plugin(1, c_loc(plugin_name), 1, c_loc(solver), 0, c_null_ptr)
    described = c_loc(plugin)
  end function
end module
