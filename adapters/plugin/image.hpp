// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <string>

#include "odeum/isolated/loaded_processes.hpp"
#include "odeum/plugin.h"

namespace odeum::adapters::plugin {

/// A plug-in in a shared object. Its code is loaded in processes of their own alone; the laboratory
/// knows an image of its description: the same structs, with texts and numbers in memory that it
/// shared with the process which read them, and functions that it never calls itself. Those of
/// problems load the code where they are called first.
class Plugin : public std::enable_shared_from_this<Plugin> {
 public:
  /// Throws LoadError, without the file's name, where the shared object cannot be used.
  static std::shared_ptr<Plugin> open(const std::string& path);

  const odeum_plugin& image() const { return *image_; }
  /// The description itself, in a process of its own. Throws LoadError where it cannot be loaded,
  /// or the file is not the one of which the image was made.
  const odeum_plugin& loaded() const;
  /// Processes that have it loaded, for its solvers.
  isolated::LoadedProcesses& processes() const { return processes_; }
  /// The problem with functions that call those of the loaded one. It keeps the plug-in.
  struct Linked;
  std::shared_ptr<const Linked> problem(std::size_t number) const;

 private:
  explicit Plugin(std::string path);
  std::string path_, state_;  ///< state_: tells the file from another one in its place
  const odeum_plugin* image_ = nullptr;
  mutable const odeum_plugin* loaded_ = nullptr;
  mutable isolated::LoadedProcesses processes_;
};

struct Plugin::Linked {
  std::shared_ptr<const Plugin> plugin;
  std::size_t number = 0;
  odeum_problem functions{};
};

}  // namespace odeum::adapters::plugin
