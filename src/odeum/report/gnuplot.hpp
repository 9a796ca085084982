// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

namespace odeum::report {

/// A picture to be drawn by gnuplot. No text of a case, a solver or a user may go into the
/// commands (gnuplot runs shell commands found in some strings): numbers and our own words only;
/// names stand in the page around the picture.
struct Picture {
  enum class Kind { svg, png };
  Kind kind = Kind::svg;
  int width = 0, height = 0;  ///< pixels
  std::string commands = {};  ///< everything after terminal and output are set
  /// In gnuplot's binary matrix format; the commands find it in the file named by `matrix`.
  std::vector<float> matrix = {};
};

struct Rendering {
  std::vector<std::string> images;  ///< the file of each picture; empty where it was not drawn
  std::string version;              ///< of gnuplot; empty where it could not be run
  std::string problem;              ///< a sentence where a picture is missing; else empty
};

/// Draws the pictures with gnuplot as found on the PATH, in `processes` processes at once. A
/// missing or failing gnuplot is told in `problem`; throws FileError where the temporary folder
/// fails.
Rendering render(const std::vector<Picture>& pictures, unsigned processes);

}  // namespace odeum::report
