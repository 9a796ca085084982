// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/solvers/runtime_library.hpp"

namespace odeum {

foreign::ProblemCallbacks open_fmu(const std::string& file,
                                   const std::map<std::string, std::string>&, const std::string&) {
  throw LoadError(file +
                  ": this Odeum was built without FMI; install libzip and pugixml and configure it "
                  "with -DODEUM_WITH_FMI=ON");
}

std::string fmi_support() { return {}; }

}  // namespace odeum
