// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/trajectories/scene_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "odeum/core/shell_word.hpp"
#include "odeum/trajectories/raster.hpp"

namespace odeum::trajectories {
namespace {

using scene::Vec3;

constexpr std::size_t width = 960, height = 720;
constexpr Colour background{0.078, 0.086, 0.102}, ground{0.2, 0.22, 0.25},
    at_rest{0.75, 0.75, 0.75}, thread{0.6, 0.67, 0.76};

Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vec3 unit(Vec3 a) {
  const double length = std::sqrt(dot(a, a));
  for (double& x : a) x /= length > 0 ? length : 1;
  return a;
}
Vec3 plus(Vec3 a, double factor, const Vec3& b) {
  for (std::size_t d = 0; d < 3; ++d) a[d] += factor * b[d];
  return a;
}

/// The box of all positions of a run, and the largest speed.
struct Extent {
  Vec3 low{}, high{}, centre{};
  double size = 0, fastest = 0;

  explicit Extent(const scene::RunResult& run) {
    low.fill(std::numeric_limits<double>::infinity());
    high.fill(-std::numeric_limits<double>::infinity());
    for (const scene::Frame& frame : run.frames) {
      const std::size_t half = frame.y.size() / 2;
      for (std::size_t i = 0; i < half; ++i) {
        if (!std::isfinite(frame.y[i])) continue;
        low[i % 3] = std::min(low[i % 3], frame.y[i]);
        high[i % 3] = std::max(high[i % 3], frame.y[i]);
      }
      for (std::size_t i = half; i + 2 < frame.y.size(); i += 3)
        fastest = std::max(fastest, std::hypot(frame.y[i], frame.y[i + 1], frame.y[i + 2]));
    }
    for (std::size_t d = 0; d < 3; ++d) {
      if (!(low[d] <= high[d])) low[d] = high[d] = 0;
      centre[d] = (low[d] + high[d]) / 2;
    }
    size = std::max(std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]), 1e-9);
    if (fastest == 0) fastest = 1;
  }
};

/// A perspective view from where the replay page's camera stands first.
struct View {
  Extent extent;
  std::size_t up, ahead, aside;
  Vec3 back{}, right{}, top{}, eye{};

  View(const scene::Scene& scene, const scene::RunResult& run)
      : extent(run),
        up(static_cast<std::size_t>(scene.up - 'x')),
        ahead((up + 1) % 3),
        aside((up + 2) % 3) {
    constexpr double yaw = -0.9, pitch = 0.3;
    back[ahead] = std::cos(pitch) * std::cos(yaw);
    back[aside] = std::cos(pitch) * std::sin(yaw);
    back[up] = std::sin(pitch);
    Vec3 upward{};
    upward[up] = 1;
    right = unit(cross(upward, back));
    top = cross(back, right);
    eye = plus(extent.centre, 1.2 * extent.size, back);
  }
  /// Pixels that a metre has at a depth.
  static double scale(double depth) { return static_cast<double>(height) / depth; }
  ScreenPoint operator()(const Vec3& point) const {
    const Vec3 off = plus(point, -1, eye);
    const double depth = std::max(-dot(off, back), 1e-3 * extent.size), pixels = scale(depth);
    return {width / 2. + pixels * dot(off, right), height / 2. - pixels * dot(off, top), depth};
  }
  double light(const Vec3& normal) const {
    return 0.8 * normal[up] + 0.5 * normal[ahead] + 0.33 * normal[aside];
  }
};

/// The colour from violet over green to yellow, as on the replay page.
Colour colour_of_speed(double part) {
  constexpr std::array<Colour, 5> stops{{{0.28, 0.24, 0.59},
                                         {0.2, 0.43, 0.71},
                                         {0.16, 0.65, 0.59},
                                         {0.51, 0.8, 0.33},
                                         {0.98, 0.9, 0.24}}};
  const double at = std::clamp(part, 0., 1.) * (stops.size() - 1);
  const auto k = std::min(static_cast<std::size_t>(at), stops.size() - 2);
  Colour colour{};
  for (std::size_t d = 0; d < 3; ++d)
    colour[d] = stops[k][d] + (at - static_cast<double>(k)) * (stops[k + 1][d] - stops[k][d]);
  return colour;
}

void draw_grid(Picture& picture, const View& view, const Vec3& point, const Vec3& direction) {
  const Vec3 n = unit(direction),
             a = unit(cross(n, std::abs(n[0]) < 0.9 ? Vec3{1, 0, 0} : Vec3{0, 1, 0})),
             b = cross(n, a);
  const Vec3 origin = plus(view.extent.centre, -dot(plus(view.extent.centre, -1, point), n), n);
  const double half = 0.7 * view.extent.size;
  constexpr int lines = 6;
  for (int k = -lines; k <= lines; ++k)
    for (const auto& [along, across] : {std::pair{a, b}, {b, a}}) {
      const Vec3 middle = plus(origin, k * half / lines, across);
      picture.line(view(plus(middle, -half, along)), view(plus(middle, half, along)), ground, 1);
    }
}

void draw_surfaces(Picture& picture, const View& view, const scene::Scene& scene) {
  bool any_plane = false;
  for (const scene::Contact& contact : scene.contacts) {
    if (const auto* plane = std::get_if<scene::PlaneContact>(&contact)) {
      draw_grid(picture, view, plane->point, plane->normal);
      any_plane = true;
    }
    if (const auto* sphere = std::get_if<scene::SphereContact>(&contact)) {
      const ScreenPoint at = view(sphere->center);
      const double radius = 0.985 * sphere->radius;  // what lies on it stays before it
      picture.ball(at, radius * View::scale(at[2]), radius, {0.5, 0.54, 0.6});
    }
  }
  if (any_plane) return;
  Vec3 floor = view.extent.centre, normal{};
  floor[view.up] = view.extent.low[view.up];
  normal[view.up] = 1;
  draw_grid(picture, view, floor, normal);
}

/// Such springs are what the cloth's faces show.
bool is_within_cloth(const scene::Scene& scene, const scene::Spring& spring) {
  return std::ranges::any_of(scene.cloths, [&](const scene::ClothPatch& cloth) {
    const auto within = [&](std::size_t i) {
      return i >= cloth.first && i < cloth.first + cloth.rows * cloth.columns;
    };
    return within(spring.a) && within(spring.b);
  });
}

Vec3 position(const scene::Frame& frame, std::size_t i) {
  return {frame.y[3 * i], frame.y[3 * i + 1], frame.y[3 * i + 2]};
}

void draw_cloths(Picture& picture, const View& view, const scene::Scene& scene,
                 const scene::Frame& frame) {
  for (const scene::ClothPatch& cloth : scene.cloths)
    for (std::size_t i = 0; i + 1 < cloth.rows; ++i)
      for (std::size_t j = 0; j + 1 < cloth.columns; ++j) {
        const std::size_t a = cloth.first + i * cloth.columns + j, c = a + cloth.columns;
        for (const auto& [x, y, z] : {std::array{a, c, c + 1}, {a, c + 1, a + 1}}) {
          const Vec3 p = position(frame, x), q = position(frame, y), r = position(frame, z);
          const Vec3 normal = unit(cross(plus(q, -1, p), plus(r, -1, p)));
          const double light = 0.35 + 0.5 * std::abs(view.light(normal));
          picture.triangle({view(p), view(q), view(r)}, {0.55 * light, 0.6 * light, 0.75 * light});
        }
      }
}

std::string picture_of(const View& view, const scene::Scene& scene, const scene::Frame& frame) {
  Picture picture(width, height, background);
  draw_surfaces(picture, view, scene);
  const std::size_t listed = scene.size(), half = frame.y.size() / 2;
  // What a scene lists stands before what is emitted, each at its own number.
  draw_cloths(picture, view, scene, frame);
  for (const scene::Spring& spring : scene.springs)
    if (!is_within_cloth(scene, spring))
      picture.line(view(position(frame, spring.a)), view(position(frame, spring.b)), thread, 1,
                   view.extent.size / 200);
  for (std::size_t i = 0; i < frame.ids.size(); ++i) {
    const bool is_listed = frame.ids[i] < listed;
    const double radius =
        std::max(is_listed ? scene.particles[frame.ids[i]].radius : 0, view.extent.size / 250);
    const double speed =
        std::hypot(frame.y[half + 3 * i], frame.y[half + 3 * i + 1], frame.y[half + 3 * i + 2]);
    const ScreenPoint at = view(position(frame, i));
    picture.ball(at, radius * View::scale(at[2]), radius,
                 is_listed && scene.particles[frame.ids[i]].fixed
                     ? at_rest
                     : colour_of_speed(speed / view.extent.fastest));
  }
  return picture.png();
}

}  // namespace

std::string write_film(const record::OutputFolder& folder, const scene::Scene& scene,
                       const scene::RunResult& run, std::size_t most, const std::string& in) {
  const std::vector<std::size_t> frames = chosen_frames(run, most);
  const View view(scene, run);
  for (std::size_t k = 0; k < frames.size(); ++k)
    folder.write(fmt::format("{}film/{:04}.png", in, k + 1),
                 picture_of(view, scene, run.frames[frames[k]]));
  const double duration = run.frames[frames.back()].t - run.frames[frames.front()].t;
  const double rate = duration > 0 ? static_cast<double>(frames.size() - 1) / duration : 25;
  std::string path = (folder.path() / in).string(), pattern;
  if (path.ends_with('/')) path.pop_back();
  for (const char c : path) pattern += c == '%' ? "%%" : std::string(1, c);
  return fmt::format("ffmpeg -framerate {:.6g} -i {} -pix_fmt yuv420p {}", rate,
                     shell_word(pattern + "/film/%04d.png"), shell_word(path + "/film.mp4"));
}

}  // namespace odeum::trajectories
