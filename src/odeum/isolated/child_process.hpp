// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <sys/types.h>

#include <cstddef>
#include <functional>

namespace odeum::isolated {

/// Memory that a process shares with its children, at one address and all zeros at first. Throws
/// std::bad_alloc.
class SharedMemory {
 public:
  explicit SharedMemory(std::size_t bytes);
  ~SharedMemory();
  SharedMemory(const SharedMemory&) = delete;
  SharedMemory& operator=(const SharedMemory&) = delete;
  void* get() const { return memory_; }
  /// From now on neither this process nor one that it starts writes to it.
  void seal() const;

 private:
  std::size_t bytes_;
  void* memory_;
};

/// A process that lives as long as the thread that starts it, or until it is ended.
enum class Lifetime { thread, open };

/// A process that has another one call work() and end, and in which no exit handler runs that was
/// there before; -1 where none could be made. It ends, with the same state, once that one has ended
/// and it has ended all others that this started, wherever they went. Their files are those of the
/// parent, but what work() prints goes to standard error and not into the parent's data. The data
/// of work() may grow by at most $ODEUM_FOREIGN_GIGABYTES, else 4; no core is left.
pid_t start_child(Lifetime lifetime, const std::function<void()>& work);
/// Ends such a process with all that it started and waits for it; its state.
int end_child(pid_t process);

}  // namespace odeum::isolated
