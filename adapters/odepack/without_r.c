// SPDX-License-Identifier: BSD-3-Clause
/* What deSolve.so asks of R where its integrators run without R: nothing is printed, since their
   flags say what happened, and no error ends the process. Its parts that serve R's own interpreter
   are never called. */

/* R prints texts and numbers by these. */
void Rprintf(const char* format, ...) { (void)format; }
void dblepr_(const char* label, const int* length, const double* numbers, const int* count) {
  (void)label, (void)length, (void)numbers, (void)count;
}
void intpr_(const char* label, const int* length, const int* numbers, const int* count) {
  (void)label, (void)length, (void)numbers, (void)count;
}
/* R's end of a call with an error. The integrators return with a flag after it. */
void rexit_(const char* message, const int* length) { (void)message, (void)length; }

double R_NaReal;
void *R_NaString, *R_NamesSymbol, *R_NilValue;

#define ODEUM_NEVER_CALLED(name) \
  void name(void) { __builtin_trap(); }
ODEUM_NEVER_CALLED(COMPLEX)
ODEUM_NEVER_CALLED(INTEGER)
ODEUM_NEVER_CALLED(LENGTH)
ODEUM_NEVER_CALLED(REAL)
ODEUM_NEVER_CALLED(R_CHAR)
ODEUM_NEVER_CALLED(R_ExternalPtrAddrFn)
ODEUM_NEVER_CALLED(R_RegisterCCallable)
ODEUM_NEVER_CALLED(R_alloc)
ODEUM_NEVER_CALLED(R_registerRoutines)
ODEUM_NEVER_CALLED(R_useDynamicSymbols)
ODEUM_NEVER_CALLED(Rf_ScalarReal)
ODEUM_NEVER_CALLED(Rf_allocMatrix)
ODEUM_NEVER_CALLED(Rf_allocVector)
ODEUM_NEVER_CALLED(Rf_coerceVector)
ODEUM_NEVER_CALLED(Rf_error)
ODEUM_NEVER_CALLED(Rf_eval)
ODEUM_NEVER_CALLED(Rf_findVar)
ODEUM_NEVER_CALLED(Rf_getAttrib)
ODEUM_NEVER_CALLED(Rf_inherits)
ODEUM_NEVER_CALLED(Rf_install)
ODEUM_NEVER_CALLED(Rf_isEnvironment)
ODEUM_NEVER_CALLED(Rf_isNull)
ODEUM_NEVER_CALLED(Rf_isNumeric)
ODEUM_NEVER_CALLED(Rf_isString)
ODEUM_NEVER_CALLED(Rf_lang3)
ODEUM_NEVER_CALLED(Rf_lang4)
ODEUM_NEVER_CALLED(Rf_length)
ODEUM_NEVER_CALLED(Rf_protect)
ODEUM_NEVER_CALLED(Rf_setAttrib)
ODEUM_NEVER_CALLED(Rf_unprotect)
ODEUM_NEVER_CALLED(Rf_warning)
ODEUM_NEVER_CALLED(STRING_ELT)
ODEUM_NEVER_CALLED(VECTOR_ELT)
