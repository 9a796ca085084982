// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "sundials/session.hpp"

namespace odeum::adapters::sundials {

/// Creates CVODE in a session: CV_ADAMS with the fixed-point iteration, or CV_BDF with Newton's, as
/// the user guide recommends them.
void create_cvode(Session& session, int family);

}  // namespace odeum::adapters::sundials
