// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "odeum/report/shared_files.hpp"
#include "odeum/report/text.hpp"
#include "odeum/scene/run/run.hpp"
#include "odeum/trajectories/scene_files.hpp"

namespace odeum::trajectories {
namespace {

using Json = nlohmann::ordered_json;

/// Numbers as the base64 of little-endian 32-bit floats, or of unsigned integers.
template <class Number>
std::string packed(const std::vector<Number>& numbers) {
  static_assert(sizeof(Number) == 4);
  std::string bytes(4 * numbers.size(), '\0');
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &numbers[i], 4);
    for (std::size_t k = 0; k < 4; ++k)
      bytes[4 * i + k] = static_cast<char>((bits >> (8 * k)) & 0xffU);
  }
  return report::base64(bytes);
}

Json numbers_of(const scene::Vec3& v) { return {v[0], v[1], v[2]}; }

Json surfaces_of(const scene::Scene& scene) {
  Json surfaces = Json::array();
  for (const scene::Contact& contact : scene.contacts) {
    if (const auto* plane = std::get_if<scene::PlaneContact>(&contact))
      surfaces.push_back({{"kind", "plane"},
                          {"point", numbers_of(plane->point)},
                          {"normal", numbers_of(plane->normal)}});
    if (const auto* sphere = std::get_if<scene::SphereContact>(&contact))
      surfaces.push_back(
          {{"kind", "sphere"}, {"center", numbers_of(sphere->center)}, {"radius", sphere->radius}});
  }
  return surfaces;
}

// How emitted particles look, by emitter; null where they are drawn as balls.
Json looks_of(const scene::Scene& scene) {
  Json looks = Json::array();
  for (const scene::Emitter& emitter : scene.emitters) {
    if (!emitter.look) {
      looks.push_back(nullptr);
      continue;
    }
    const scene::Look& look = *emitter.look;
    Json one = {{"colour", {numbers_of(look.colour[0]), numbers_of(look.colour[1])}},
                {"size", look.size},
                {"opacity", look.opacity},
                {"additive", look.additive}};
    if (!look.texture.empty())
      one["texture"] = "data:image/png;base64," + report::base64(look.texture);
    looks.push_back(std::move(one));
  }
  return looks;
}

// Birth, lifetime (0: endless) and emitter of each emitted particle, by its id less the number of
// particles that the scene lists: three numbers each.
std::vector<float> lives_of(const scene::Scene& scene, double until) {
  std::vector<float> lives;
  for (const scene::EmittedParticle& one : scene::emitted_particles(scene.emitters, until)) {
    const double lifetime = one.death - one.birth;
    lives.push_back(static_cast<float>(one.birth));
    lives.push_back(std::isfinite(lifetime) ? static_cast<float>(lifetime) : 0);
    lives.push_back(static_cast<float>(one.emitter));
  }
  return lives;
}

// As many frames as keep the page under some 30 MB.
std::size_t most_frames(const scene::RunResult& run) {
  std::size_t numbers = 0;
  for (const scene::Frame& frame : run.frames) numbers += frame.y.size();
  constexpr std::size_t most_numbers = 6'000'000;
  if (numbers <= most_numbers) return run.frames.size();
  return std::max<std::size_t>(2, run.frames.size() * most_numbers / numbers);
}

// Frame and particle of all that touch, two numbers each.
std::vector<std::uint32_t> touching_in(const scene::Scene& scene, const scene::RunResult& run) {
  std::vector<std::uint32_t> touching;
  if (scene.surfaces.empty()) return touching;
  const scene::Surfaces surfaces(scene);
  const auto chosen = chosen_frames(run, most_frames(run));
  for (std::uint32_t k = 0; k < chosen.size(); ++k) {
    // The listed particles come first in a frame.
    const scene::Frame& frame = run.frames[chosen[k]];
    std::vector<std::uint32_t> particles;
    scene::touching_at(surfaces, frame.y.data(), &particles);
    std::ranges::sort(particles);
    particles.erase(std::unique(particles.begin(), particles.end()), particles.end());
    for (const std::uint32_t particle : particles) touching.insert(touching.end(), {k, particle});
  }
  return touching;
}

Json scene_json(const scene::Scene& scene, const scene::RunResult& run,
                const std::vector<std::vector<double>>& errors) {
  std::vector<float> states, radii, rest, errors_shown;
  std::vector<std::uint32_t> counts, ids, ends;
  Json times = Json::array(), kinetic = Json::array(), potential = Json::array();
  for (const std::size_t k : chosen_frames(run, most_frames(run))) {
    const scene::Frame& frame = run.frames[k];
    times.push_back(frame.t);
    kinetic.push_back(frame.kinetic);
    potential.push_back(frame.potential);
    counts.push_back(static_cast<std::uint32_t>(frame.ids.size()));
    for (const std::size_t id : frame.ids) ids.push_back(static_cast<std::uint32_t>(id));
    for (const double number : frame.y) states.push_back(static_cast<float>(number));
    if (k < errors.size())
      for (const double error : errors[k]) errors_shown.push_back(static_cast<float>(error));
  }
  std::vector<std::uint32_t> fixed;
  for (const auto& particle : scene.particles) {
    radii.push_back(static_cast<float>(particle.radius));
    fixed.push_back(particle.fixed);
  }
  for (const auto& spring : scene.springs) {
    ends.push_back(static_cast<std::uint32_t>(spring.a));
    ends.push_back(static_cast<std::uint32_t>(spring.b));
    rest.push_back(static_cast<float>(spring.rest_length));
  }
  Json cloths = Json::array();
  for (const auto& cloth : scene.cloths)
    cloths.push_back({{"first", cloth.first}, {"rows", cloth.rows}, {"columns", cloth.columns}});
  Json plot = nullptr;
  if (scene.plot) {
    plot = {{"particle", scene.plot->particle}, {"coordinate", scene.plot->coordinate}};
    if (scene.plot->y_range) plot["range"] = *scene.plot->y_range;
  }
  return {{"name", report::plain(scene.name)},
          {"up", std::string(1, scene.up)},
          {"listed", scene.particles.size()},
          {"times", times},
          {"kinetic", kinetic},
          {"potential", potential},
          {"counts", packed(counts)},
          {"ids", packed(ids)},
          {"states", packed(states)},
          {"errors", packed(errors_shown)},
          {"radii", packed(radii)},
          {"fixed", packed(fixed)},
          {"springs", packed(ends)},
          {"rest", packed(rest)},
          {"cloths", cloths},
          {"plot", plot},
          {"looks", looks_of(scene)},
          {"lives", packed(lives_of(scene, run.t > 0 ? run.t : 1e-300))},
          {"touching", packed(touching_in(scene, run))},
          {"surfaces", surfaces_of(scene)}};
}

// JSON that may stand in a script element: no < at all.
std::string for_script(const Json& json) {
  std::string text;
  for (const char c : json.dump(-1, ' ', false, Json::error_handler_t::replace))
    text += c == '<' ? "\\u003c" : std::string(1, c);
  return text;
}

}  // namespace

std::string replay_page(const scene::Scene& scene, const scene::RunResult& run,
                        const std::vector<std::string>& facts,
                        const std::vector<std::vector<double>>& errors) {
  Json json = scene_json(scene, run, errors);
  json["facts"] = Json::array();
  for (const std::string& fact : facts) json["facts"].push_back(report::plain(fact));
  return report::filled_template("viewer/replay/replay.html", for_script(json));
}

}  // namespace odeum::trajectories
