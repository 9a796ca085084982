// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace odeum::report {

/// Where the rows of a section come from, and where it stands.
struct Origin {
  std::string command = {};    ///< the subcommand that measures them
  int place = 500;             ///< see Section
  std::string problem = {};    ///< why files of an earlier run could not be used; empty: they could
  bool measured = true;        ///< by this run, and not only read back
  std::string selection = {};  ///< what of it a report measures, as text; empty: all
};

/// The first paragraphs of a section; `empty`: it has no rows.
std::string origin_text(const Origin& origin, bool empty);

}  // namespace odeum::report
