// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/kinds/kind.hpp"

#include "odeum/cases/network_text.hpp"

namespace odeum::cases {

Kind net_kind() {
  return {"problem", "_net", false,
          [](const Named& named) { return named.word().ends_with(".net"); },
          [](const Named& named, const Given& given) {
            const std::string& text = named.text("network", most_model_bytes);
            return translated(named, given,
                              [&](double end) { return text_of_network(named.word(), text, end); });
          }};
}

}  // namespace odeum::cases
