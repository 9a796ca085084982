// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/scene/read/reader_fields.hpp"

#include "odeum/input/near_words.hpp"

namespace odeum::scene::reading {

double damping_of(const Mapping& mapping) {
  if (!mapping.has("damping")) return 0;
  const Value value = mapping.at("damping");
  const double damping = value.number();
  if (damping < 0 && !context_of(value).allow_negative_damping)
    value.warn("negative damping, which adds energy; allow_negative_damping: true silences");
  return damping;
}

bool is_axial(const Mapping& mapping) {
  if (!mapping.has("damping_model")) {
    context_of(mapping.value()).damping_model_given = false;
    return true;
  }
  const Value value = mapping.at("damping_model");
  const std::string model = value.text();
  if (model != "axial" && model != "full")
    value.fail("an unknown damping" + near_one(model, {"axial", "full"}), "axial or full");
  return model == "axial";
}

}  // namespace odeum::scene::reading
