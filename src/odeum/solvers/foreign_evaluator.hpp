// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <functional>
#include <mutex>

#include "odeum/isolated/child_process.hpp"

namespace odeum::foreign {

/// A process that calls the functions of a foreign problem for those parts of a study that do not
/// solve it: errors, gains, spectra. About 10 microseconds a call. A call that fails, crashes or
/// hangs gives NaN; the process is started anew, a limited number of times, of which at most
/// isolated::most_ended in a row may be for its silence.
class Evaluator {
 public:
  /// `work(function, t, in, out)` is what a call does; `most` bounds the numbers in and out.
  using Work = std::function<int(int function, double t, const double* in, double* out)>;
  Evaluator(Work work, std::size_t most);
  ~Evaluator();
  Evaluator(const Evaluator&) = delete;
  Evaluator& operator=(const Evaluator&) = delete;

  /// Whether the call succeeded; else `out` is NaN.
  bool call(int function, double t, const double* in, std::size_t n_in, double* out,
            std::size_t n_out);

 private:
  struct Memory;
  bool start();
  void stop();
  bool ask();
  void serve(int socket);

  Work work_;
  std::size_t most_;
  std::mutex mutex_;
  isolated::SharedMemory shared_;
  Memory* memory_;
  pid_t process_ = -1;
  int socket_ = -1;
  int starts_ = 0;
  unsigned silent_ = 0;  ///< calls in a row that had to be ended
};

}  // namespace odeum::foreign
