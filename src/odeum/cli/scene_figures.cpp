// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <functional>

#include "odeum/cli/run.hpp"

namespace odeum::cli {
namespace {

using report::ChartPoint;
using report::Figure;
using Quantity = std::function<double(const scene::Frame& frame)>;

double time(const scene::Frame& frame) { return frame.t; }

// What is drawn: the scene's plot, or the height of its first free particle.
std::optional<scene::Plot> plot_of(const scene::Scene& scene) {
  if (scene.plot) return scene.plot;
  for (std::size_t i = 0; i < scene.particles.size(); ++i)
    if (!scene.particles[i].fixed)
      return scene::Plot{
          .particle = i, .coordinate = static_cast<std::size_t>(scene.up - 'x'), .y_range = {}};
  return std::nullopt;
}

void draw(Figure& figure, const std::vector<SceneRun>& runs, const Quantity& x, const Quantity& y) {
  for (std::size_t r = 0; r < runs.size(); ++r) {
    std::vector<ChartPoint> points;
    for (const scene::Frame& frame : runs[r].outcome.frames)
      points.emplace_back(x(frame), y(frame));
    figure.lines.push_back(
        {.name = runs[r].entrant->info.id(), .style = r, .points = std::move(points)});
  }
}

// The exact motion at the frames of a run, where there is a closed form.
std::vector<scene::Frame> exact_frames(const scene::SceneProblem& problem,
                                       const scene::RunResult& run) {
  std::vector<scene::Frame> frames;
  if (!problem.structure().closed_form || run.births > 0) return frames;
  for (const scene::Frame& frame : run.frames) {
    scene::Frame exact{.t = frame.t, .ids = frame.ids, .y = std::vector<double>(problem.size())};
    if (frame.y.size() != problem.size()) return {};
    problem.closed_form(frame.t, problem.start().data(), exact.y.data());
    frames.push_back(std::move(exact));
  }
  return frames;
}

}  // namespace

std::vector<report::Figure> scene_figures(const scene::Scene& scene,
                                          const scene::SceneProblem& problem,
                                          const std::vector<SceneRun>& runs) {
  std::vector<Figure> figures;
  if (const auto plot = plot_of(scene)) {
    const std::size_t at = 3 * plot->particle + plot->coordinate;
    const Quantity position = [at](const scene::Frame& frame) { return frame.y[at]; };
    const Quantity velocity = [at](const scene::Frame& frame) {
      return frame.y[frame.y.size() / 2 + at];
    };
    const char axis = "xyz"[plot->coordinate];
    const std::string name = fmt::format("{} of particle {}", axis, plot->particle);
    Figure over_time{
        .title = name + " over time", .x = "time (s)", .y = fmt::format("{} (m)", axis)};
    Figure plane{.title = "State plane of " + name,
                 .x = fmt::format("{} (m)", axis),
                 .y = fmt::format("v{} (m/s)", axis)};
    over_time.y_range = plot->y_range;
    report::FigureLine exact{.name = "exact", .points = {}}, exact_plane = exact;
    for (const scene::Frame& frame : exact_frames(problem, runs.front().outcome)) {
      exact.points.emplace_back(frame.t, position(frame));
      exact_plane.points.emplace_back(position(frame), velocity(frame));
    }
    if (!exact.points.empty()) {
      over_time.lines.push_back(std::move(exact));
      plane.lines.push_back(std::move(exact_plane));
    }
    draw(over_time, runs, time, position);
    draw(plane, runs, position, velocity);
    figures = {std::move(over_time), std::move(plane)};
  }
  Figure total{.title = "Energy, less that at the start", .x = "time (s)", .y = "energy (J)"};
  const double start = energy(runs.front().outcome.frames.front());
  draw(total, runs, time, [start](const scene::Frame& frame) { return energy(frame) - start; });
  figures.push_back(std::move(total));
  return figures;
}

}  // namespace odeum::cli
