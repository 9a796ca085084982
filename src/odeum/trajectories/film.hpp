// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <string>

#include "odeum/record/output_folder.hpp"
#include "odeum/scene/run/run.hpp"

namespace odeum::trajectories {

/// One moment of a run as a picture of 960 x 720 pixels: cloths as faces, other springs as
/// lines, particles as balls in the colour of their speed, planes as grids, spheres. The eye stands
/// as on the replay page. Returns the bytes of a PNG file.
std::string film_frame(const scene::Scene& scene, const scene::RunResult& run, std::size_t frame);

/// Writes film/0001.png, ... of at most `most` frames, evenly chosen, into the subfolder `in`,
/// which ends with a slash or is empty. Returns the command of ffmpeg that makes a film of them at
/// the scene's own speed. Throws FileError.
std::string write_film(const record::OutputFolder& folder, const scene::Scene& scene,
                       const scene::RunResult& run, std::size_t most, const std::string& in);

}  // namespace odeum::trajectories
