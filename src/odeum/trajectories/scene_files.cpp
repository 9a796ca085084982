// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/trajectories/scene_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "odeum/record/rows.hpp"
#include "odeum/report/text.hpp"

namespace odeum::trajectories {
namespace {

struct ParticleRow {
  std::size_t id = 0;
  double y[6] = {};  ///< position, m; velocity, m/s

  ODEUM_COLUMNS(column("particle", id), column("x", y[0]), column("y", y[1]), column("z", y[2]),
                column("vx", y[3]), column("vy", y[4]), column("vz", y[5]))
};
struct TimedParticleRow {
  double t = 0;
  ParticleRow particle;
  ODEUM_COLUMNS(column("time", t), particle)
};
struct EnergyRow {
  double t = 0, kinetic = 0, potential = 0;
  scene::Vec3 momentum = {};
  ODEUM_COLUMNS(column("time", t), kinetic, potential, column("total", kinetic + potential),
                column("momentum_x", momentum[0]), column("momentum_y", momentum[1]),
                column("momentum_z", momentum[2]))
};

ParticleRow particle_of(const scene::Frame& frame, std::size_t i) {
  ParticleRow row{.id = frame.ids[i]};
  std::copy_n(frame.y.begin() + static_cast<std::ptrdiff_t>(3 * i), 3, row.y);
  std::copy_n(frame.y.begin() + static_cast<std::ptrdiff_t>(frame.y.size() / 2 + 3 * i), 3,
              row.y + 3);
  return row;
}

std::string vtk_file(const scene::Scene& scene, const scene::Frame& frame,
                     const std::string& title) {
  const std::size_t n = frame.ids.size();
  std::string text = "# vtk DataFile Version 3.0\n" + title + "\nASCII\nDATASET POLYDATA\n";
  text += fmt::format("POINTS {} float\n", n);
  const auto vectors = [&](std::size_t from) {
    for (std::size_t i = 0; i < n; ++i)
      text += fmt::format("{:.7g} {:.7g} {:.7g}\n", frame.y[from + 3 * i],
                          frame.y[from + 3 * i + 1], frame.y[from + 3 * i + 2]);
  };
  vectors(0);
  text += fmt::format("VERTICES {} {}\n", n, 2 * n);
  for (std::size_t i = 0; i < n; ++i) text += fmt::format("1 {}\n", i);
  if (!scene.springs.empty()) {
    text += fmt::format("LINES {0} {1}\n", scene.springs.size(), 3 * scene.springs.size());
    for (const auto& spring : scene.springs) text += fmt::format("2 {} {}\n", spring.a, spring.b);
  }
  text += fmt::format("POINT_DATA {}\nSCALARS particle int 1\nLOOKUP_TABLE default\n", n);
  for (const std::size_t id : frame.ids) text += fmt::format("{}\n", id);
  text += "VECTORS velocity float\n";
  vectors(3 * n);
  return text;
}

}  // namespace

std::string final_csv(const scene::RunResult& run) {
  std::vector<ParticleRow> rows;
  const scene::Frame& frame = run.frames.back();
  for (std::size_t i = 0; i < frame.ids.size(); ++i) rows.push_back(particle_of(frame, i));
  return record::csv_text(rows);
}

std::string trajectory_csv(const scene::RunResult& run) {
  std::vector<TimedParticleRow> rows;
  for (const scene::Frame& frame : run.frames)
    for (std::size_t i = 0; i < frame.ids.size(); ++i)
      rows.push_back({frame.t, particle_of(frame, i)});
  return record::csv_text(rows);
}

std::string energy_csv(const scene::RunResult& run) {
  std::vector<EnergyRow> rows;
  for (const scene::Frame& frame : run.frames)
    rows.push_back({frame.t, frame.kinetic, frame.potential, frame.momentum});
  return record::csv_text(rows);
}

std::vector<std::size_t> chosen_frames(const scene::RunResult& run, std::size_t most) {
  std::vector<std::size_t> chosen;
  const std::size_t count = run.frames.size();
  const std::size_t kept = std::min(count, std::max<std::size_t>(most, 2));
  for (std::size_t k = 0; k < kept; ++k)
    chosen.push_back(kept == 1 ? 0 : k * (count - 1) / (kept - 1));
  return chosen;
}

void write_vtk_series(const record::OutputFolder& folder, const scene::Scene& scene,
                      const scene::RunResult& run, const std::string& in, std::size_t most) {
  std::string title = "Odeum: " + report::plain(scene.name);
  title.resize(std::min<std::size_t>(title.size(), 200));
  nlohmann::ordered_json files = nlohmann::ordered_json::array();
  for (const std::size_t k : chosen_frames(run, most)) {
    const std::string name = fmt::format("vtk/frame_{:06}.vtk", k);
    folder.write(in + name, vtk_file(scene, run.frames[k], title));
    files.push_back({{"name", name}, {"time", run.frames[k].t}});
  }
  const nlohmann::ordered_json series = {{"file-series-version", "1.0"}, {"files", files}};
  folder.write(in + "trajectory.vtk.series", series.dump(1) + "\n");
}

void write_scene_files(const record::OutputFolder& folder, const std::string& in,
                       const scene::Scene& scene, const scene::RunResult& run,
                       const std::vector<std::string>& facts) {
  if (run.status == Status::ok) folder.write(in + "final.csv", final_csv(run));
  folder.write(in + "trajectory.csv", trajectory_csv(run));
  folder.write(in + "energy.csv", energy_csv(run));
  folder.write(in + "replay.html", replay_page(scene, run, facts));
  write_vtk_series(folder, scene, run, in);
}

}  // namespace odeum::trajectories
