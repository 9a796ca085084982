// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/kinds/sbml/sbml.hpp"
#include "odeum/input/yaml_tree.hpp"

namespace odeum {

cases::SbmlText cases::text_of_sbml(const std::string& file, const std::string&, double) {
  throw InputError(
      file, {},
      "SBML is not read; got this Odeum, which was built without it, expected one that "
      "`scripts/bootstrap --with sbml` builds");
}

std::string cases::sbml_support() { return {}; }

}  // namespace odeum
