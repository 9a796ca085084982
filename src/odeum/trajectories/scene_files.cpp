// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/trajectories/scene_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "odeum/record/csv.hpp"
#include "odeum/report/text.hpp"

namespace odeum::trajectories {
namespace {

void add_particle(record::CsvRow& row, const scene::Frame& frame, std::size_t i) {
  row.count(frame.ids[i]);
  const std::size_t half = frame.y.size() / 2;
  for (const std::size_t from : {3 * i, half + 3 * i})
    for (std::size_t d = 0; d < 3; ++d) row.number(frame.y[from + d]);
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
  record::CsvTable table("particle,x,y,z,vx,vy,vz");
  const scene::Frame& frame = run.frames.back();
  for (std::size_t i = 0; i < frame.ids.size(); ++i) {
    record::CsvRow row;
    add_particle(row, frame, i);
    table.add(row);
  }
  return table.text();
}

std::string trajectory_csv(const scene::RunResult& run) {
  record::CsvTable table("time,particle,x,y,z,vx,vy,vz");
  for (const scene::Frame& frame : run.frames)
    for (std::size_t i = 0; i < frame.ids.size(); ++i) {
      record::CsvRow row;
      row.number(frame.t);
      add_particle(row, frame, i);
      table.add(row);
    }
  return table.text();
}

std::string energy_csv(const scene::RunResult& run) {
  record::CsvTable table("time,kinetic,potential,total,momentum_x,momentum_y,momentum_z");
  for (const scene::Frame& frame : run.frames) {
    record::CsvRow row;
    row.number(frame.t).number(frame.kinetic).number(frame.potential);
    row.number(frame.kinetic + frame.potential);
    for (const double component : frame.momentum) row.number(component);
    table.add(row);
  }
  return table.text();
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

}  // namespace odeum::trajectories
