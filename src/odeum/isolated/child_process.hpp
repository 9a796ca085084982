// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <sys/types.h>

#include <cstddef>
#include <functional>

namespace odeum::isolated {

/// Memory that a process shares with its children, all zeros at first. Throws std::bad_alloc.
class SharedMemory {
 public:
  explicit SharedMemory(std::size_t bytes);
  ~SharedMemory();
  SharedMemory(const SharedMemory&) = delete;
  SharedMemory& operator=(const SharedMemory&) = delete;
  void* get() const { return memory_; }

 private:
  std::size_t bytes_;
  void* memory_;
};

/// A process of its own that calls work() and ends; -1 where none could be made. Its files are
/// those of the parent, but what it prints goes to standard error and not into the parent's data.
/// It leads a group of processes and leaves no core.
pid_t start_child(const std::function<void()>& work);
/// Ends such a process with its group and waits for it; its state.
int end_child(pid_t process);

}  // namespace odeum::isolated
