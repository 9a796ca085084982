// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "odeum/record/output_folder.hpp"
#include "odeum/scene/run/run.hpp"

namespace odeum::trajectories {

/// The last frame: schema,particle,x,y,z,vx,vy,vz.
std::string final_csv(const scene::RunResult& run);
/// Every frame: schema,time,particle,x,y,z,vx,vy,vz.
std::string trajectory_csv(const scene::RunResult& run);
/// schema,time,kinetic,potential,total,momentum_x,momentum_y,momentum_z, a row a frame.
std::string energy_csv(const scene::RunResult& run);

/// A series that ParaView opens: trajectory.vtk.series, and one legacy VTK file a frame (at most
/// `most` of them, evenly chosen) under vtk/; all in the subfolder `in`, which ends with a slash.
/// Throws FileError.
void write_vtk_series(const record::OutputFolder& folder, const scene::Scene& scene,
                      const scene::RunResult& run, const std::string& in = "",
                      std::size_t most = 200);

/// The frames, at most `most` of them, evenly chosen, the first and the last among them.
std::vector<std::size_t> chosen_frames(const scene::RunResult& run, std::size_t most);

/// A page that shows the run in 3-D, with all that it needs in itself (reports/viewer/replay.*).
/// `facts` are lines of text for the reader. `errors`: how far each particle is from where it
/// should be, m, by frame (of all frames) and particle; where given, particles and cloth have its
/// colour.
std::string replay_page(const scene::Scene& scene, const scene::RunResult& run,
                        const std::vector<std::string>& facts,
                        const std::vector<std::vector<double>>& errors = {});

/// Writes film/0001.png, ... of at most `most` frames, evenly chosen, into the subfolder `in`,
/// which ends with a slash or is empty: pictures of 960 x 720 pixels, with cloths as faces, other
/// springs as lines, particles as balls in the colour of their speed, planes as grids, spheres. The
/// eye stands as on the replay page. Returns the command of ffmpeg that makes a film of them at the
/// scene's own speed. Throws FileError.
std::string write_film(const record::OutputFolder& folder, const scene::Scene& scene,
                       const scene::RunResult& run, std::size_t most, const std::string& in);

/// All of these but the film, into the subfolder `in`, which ends with a slash or is empty; the
/// last frame where the run ended well. Throws FileError.
void write_scene_files(const record::OutputFolder& folder, const std::string& in,
                       const scene::Scene& scene, const scene::RunResult& run,
                       const std::vector<std::string>& facts);

}  // namespace odeum::trajectories
