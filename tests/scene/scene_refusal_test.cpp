// SPDX-License-Identifier: BSD-3-Clause
// The scene reader: errors and warnings.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "odeum/scene/read/reader.hpp"
#include "support/scene_texts.hpp"
#include "support/temporary_folder.hpp"

namespace odeum::scene_refusal_test {
namespace {

using scene::read_scene;
using tests::with_particles;

std::string error_of(const std::string& text, const scene::ReadOptions& options = {}) {
  try {
    read_scene("s.yaml", text, options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

const char* const two = tests::two_particles;

struct Fault {
  const char* name;
  std::string text;
  const char* message;  ///< what the error begins with after the file, or holds
  friend std::ostream& operator<<(std::ostream& out, const Fault& x) { return out << x.name; }
};

class SceneFault : public testing::TestWithParam<Fault> {};

TEST_P(SceneFault, IsNamedWithItsPlace) {
  const std::string error = error_of(GetParam().text);
  EXPECT_TRUE(error.starts_with("s.yaml:")) << error;
  EXPECT_NE(error.find(GetParam().message), std::string::npos) << error;
  EXPECT_NE(error.find("; got"), std::string::npos) << error;
  EXPECT_NE(error.find(", expected"), std::string::npos) << error;
}

// One particle whose entry is `entry`, on line 3.
std::string particle(const std::string& entry) {
  return "duration: 1\nsolver: {type: rk4, timestep: 0.1}\nparticles: [" + entry + "]\n";
}
// The two particles with springs; `entry` is on line 8.
std::string springs(const std::string& entry) {
  return std::string(two) + "springs:\n  - {" + entry + "}\n";
}

// Three particles in a row of faces; `faces` is on line 8.
std::string surface(const std::string& faces, const std::string& thickness = "0.01") {
  return "duration: 1\nsolver: {type: rk4, timestep: 0.1}\nparticles:\n"
         "  - {pos: [0, 0, 0], mass: 1}\n  - {pos: [1, 0, 0], mass: 1}\n"
         "  - {pos: [0, 1, 0], mass: 1}\nsurfaces:\n  - {faces: " +
         faces + ", self_contact: {thickness: " + thickness + ", stiffness: 10}}\n";
}
// A cloth below a ball; it is on line 6.
std::string cloth_below(const std::string& ball, const std::string& more = "") {
  return "duration: 1\nsolver: {type: rk4, timestep: 0.1}\nparticles:\n  - {" + ball +
         ", mass: 1, radius: 0.5}\ncloth:\n"
         "  - {rows: 3, columns: 3, row_edge: [1, 0, 0], column_edge: [0, 1, 0], mass: 1,\n"
         "     self_contact: {thickness: 0.01, stiffness: 10}}\n" +
         more;
}

// An emitter with one key more.
std::string emitter(const std::string& entry) {
  return "duration: 1\nsolver: {type: rk4, timestep: 0.1}\nemitters: [{position: [0, 0, 0], "
         "velocity: [0, 0, 1], rate: 10, mass: 1, " +
         entry + "}]\n";
}

std::string bomb() {
  std::string text = "a0: &a0 [1, 1, 1, 1, 1, 1, 1, 1, 1, 1]\n";
  for (int k = 1; k < 12; ++k) {
    text += fmt::format("a{0}: &a{0} [*a{1}", k, k - 1);
    for (int i = 1; i < 10; ++i) text += fmt::format(", *a{}", k - 1);
    text += "]\n";
  }
  return text;
}

INSTANTIATE_TEST_SUITE_P(
    SceneReader, SceneFault,
    testing::Values(
        Fault{"surface_without_faces", surface("[]"), ":8:13: surfaces[0].faces: no face; got []"},
        Fault{"face_of_two_corners", surface("[[0, 1, 2], [0, 1]]"),
              ":8:25: surfaces[0].faces[1]: a wrong number of entries; got"},
        Fault{"face_with_a_corner_twice", surface("[[0, 1, 0]]"),
              ":8:14: surfaces[0].faces[0]: a face with a corner twice; got [0, 1, 0]"},
        Fault{"face_of_no_particle", surface("[[0, 1, 3]]"),
              "surfaces[0].faces[0][2]: no such particle; got 3, expected an id from 0 to 2"},
        Fault{"thickness_of_nothing", surface("[[0, 1, 2]]", "0"),
              ":8:52: surfaces[0].self_contact.thickness: zero; got 0"},
        Fault{
            "cloth_inside_a_ball", cloth_below("pos: [0.5, 0.5, 0.3]"),
            ":7:20: cloth[0].self_contact: starts inside a body; got particle 5 at (0.5, 0.5, 0)"},
        Fault{
            "cloth_below_a_plane",
            cloth_below("pos: [0.5, 0.5, 9]",
                        "contacts: [{plane: {point: [0, 0, 1], normal: [0, 0, 1], stiffness: "
                        "1}}]\n"),
            "cloth[0].self_contact: starts inside a body; got particle 1 at (0, 0, 0) in a plane"},
        Fault{"cloth_too_near_to_a_ball", cloth_below("pos: [0.5, 0.5, 0.5005]"),
              "cloth[0].self_contact: starts in contact; got 0.0005 m"},
        Fault{"look_of_two_numbers", emitter("look: {colour: [[1, 1, 1], [1, 1]]}"),
              "emitters[0].look.colour[1]: a wrong number of entries"},
        Fault{"look_too_bright", emitter("look: {colour: [[1, 1, 2], [1, 1, 1]]}"),
              "emitters[0].look.colour[0]: no colour; got 2"},
        Fault{"look_too_opaque", emitter("look: {opacity: [1.5, 0]}"),
              "emitters[0].look.opacity[0]: too large; got 1.5, expected a number from 0 to 1"},
        Fault{"look_of_no_size", emitter("look: {size: [-1, 0]}"), "look.size[0]: negative"},
        Fault{"look_of_no_blend", emitter("look: {blend: multiply}"),
              "look.blend: an unknown blend; got multiply, expected over or add"},
        Fault{"look_without_texture", emitter("look: {texture: /nonexistent.png}"),
              "look.texture: a texture that cannot be read"},
        Fault{"look_with_a_text", emitter("look: {texture: /proc/self/status}"), "look.texture: "},
        Fault{"another_kind", "foo: 1\nbar: 2\n",
              "neither a scene nor a problem; got the keys foo, bar, expected particles"},
        Fault{"merge_of_a_number", particle("{<<: 3, pos: [0, 0, 0], mass: 1}"),
              "s.yaml:3:18: scene: a merge key; got 3, expected a mapping"},
        Fault{"merge_of_a_list_of_numbers", particle("{<<: [3], pos: [0, 0, 0], mass: 1}"),
              "a merge key; got 3"},
        Fault{"merged_typo", particle("&a {pos: [0, 0, 0], mas: 1}, {<<: *a, mass: 1}"),
              "particles[0].mas: an unknown key; did you mean mass?"},
        Fault{"plot_of_no_particle", std::string(two) + "plot: {particle_id: 2, dof: 0}\n",
              "s.yaml:7:21: plot.particle_id: no such particle; got 2, expected an id from 0 to 1"},
        Fault{"plot_of_no_axis", std::string(two) + "plot: {particle_id: 0, dof: 3}\n",
              "plot.dof: out of range; got 3, expected a whole number from 0 to 2"},
        Fault{"plot_upside_down",
              std::string(two) + "plot: {particle_id: 0, dof: 0, y_range: [1, 0.5]}\n",
              "plot.y_range: an empty range; got [1, 0.5]"},
        Fault{"typo_beside_viewer_keys",
              particle("{pos: [0, 0, 0], mass: 1, color: red, raduis: 1}"),
              "particles[0].raduis: an unknown key; did you mean radius?"},
        Fault{"nan", particle("{pos: [.nan, 0, 0], mass: 1}"),
              "s.yaml:3:20: particles[0].pos[0]: not finite; got .nan, expected a finite number"},
        Fault{"inf", particle("{pos: [0, 0, 0], vel: [0, -.inf, 0], mass: 1}"),
              "particles[0].vel[1]: not finite; got -.inf"},
        Fault{"bare_nan", particle("{pos: [nan, 0, 0], mass: 1}"), "not finite; got nan"},
        Fault{"overflow", particle("{pos: [1e999, 0, 0], mass: 1}"), "beyond the range of doubles"},
        Fault{"underflow", particle("{pos: [0, 0, 0], mass: 1e-999}"),
              "particles[0].mass: beyond the range of doubles; got 1e-999"},
        Fault{"zero_mass", particle("{pos: [0, 0, 0], mass: 0}"), "particles[0].mass: zero; got 0"},
        Fault{"negative_mass", particle("{pos: [0, 0, 0], mass: -1}"), "negative; got -1"},
        Fault{"no_mass", particle("{pos: [0, 0, 0]}"), "particles[0].mass: missing"},
        Fault{"no_pos", particle("{mass: 1}"), "particles[0].pos: missing"},
        Fault{"negative_radius", particle("{pos: [0, 0, 0], mass: 1, radius: -1}"),
              "particles[0].radius: negative"},
        Fault{"two_coordinates", particle("{pos: [0, 0], mass: 1}"),
              "got a list of 2, expected three numbers"},
        Fault{"text_for_number", particle("{pos: [a, 0, 0], mass: 1}"), "not a number; got a"},
        Fault{"quoted_number", particle("{pos: [\"1\", 0, 0], mass: 1}"), "the text \"1\""},
        Fault{"hexadecimal", particle("{pos: [0x10, 0, 0], mass: 1}"), "not a number; got 0x10"},
        Fault{"octal_number", particle("{pos: [010, 0, 0], mass: 1}"), "a leading zero"},
        Fault{"decimal_comma",
              "duration: 1,5\nsolver: {type: rk4, timestep: 1}\nparticles: [{pos: [0, 0, 0]}]\n",
              "s.yaml:1:11: duration: a decimal comma; got 1,5"},
        Fault{"comma_in_list", particle("{pos: [0,5, 0, 0], mass: 1}"), "a list of 4"},
        Fault{"fixed_maybe", particle("{pos: [0, 0, 0], fixed: maybe}"),
              "particles[0].fixed: neither true nor false; got maybe"},
        Fault{"unknown_key", springs("particle_ids: [0, 1], stifness: 3"),
              "s.yaml:8:28: springs[0].stifness: an unknown key; did you mean stiffness?"},
        Fault{"key_twice", springs("particle_ids: [0, 1], stiffness: 3, stiffness: 4"),
              "springs[0].stiffness: duplicate key"},
        Fault{"negative_stiffness", springs("particle_ids: [0, 1], stiffness: -3"),
              "springs[0].stiffness: negative; got -3"},
        Fault{"negative_rest_length",
              springs("particle_ids: [0, 1], stiffness: 3, rest_length: -1"),
              "rest_length: negative"},
        Fault{"self_spring", springs("particle_ids: [1, 1], stiffness: 3"),
              "a spring from a particle to itself"},
        Fault{"id_out_of_range", springs("particle_ids: [0, 2], stiffness: 3"),
              "particle_ids[1]: no such particle; got 2, expected an id from 0 to 1"},
        Fault{"negative_id", springs("particle_ids: [0, -1], stiffness: 3"), "negative; got -1"},
        Fault{"fractional_id", springs("particle_ids: [0, 1.5], stiffness: 3"),
              "no whole number; got 1.5"},
        Fault{"octal_id", springs("particle_ids: [0, 01], stiffness: 3"),
              "a leading zero makes this an octal number in YAML; got 01"},
        Fault{"huge_id", springs("particle_ids: [0, 99999999999999999999], stiffness: 3"),
              "out of range"},
        Fault{"three_ids", springs("particle_ids: [0, 1, 1], stiffness: 3"),
              "got a list of 3, expected two particle ids"},
        Fault{"damping_model", springs("particle_ids: [0, 1], stiffness: 3, damping_model: axal"),
              "did you mean axial?"},
        Fault{"coincident",
              "duration: 1\nsolver: {type: rk4, timestep: 1}\nparticles: [{pos: [1, 0, 0], mass: "
              "1}, {pos: [1, 0, 0], mass: 1}]\nsprings: [{particle_ids: [0, 1], stiffness: 1}]\n",
              "s.yaml:4:11: springs[0]: a spring between particles at the same place"},
        Fault{"no_particles", particle(""), "particles: no particles"},
        Fault{"no_solver", "duration: 1\nparticles: [{pos: [0, 0, 0], mass: 1}]\n",
              "solver: missing"},
        Fault{"no_setting", "duration: 1\nsolver: {type: rk4}\nparticles: []\n",
              "s.yaml:2:9: solver: no setting"},
        Fault{"zero_duration",
              "duration: 0\nsolver: {type: rk4, timestep: 1}\nparticles: [{pos: [0, 0, 0], mass: "
              "1}]\n",
              "s.yaml:1:11: duration: zero; got 0, expected a positive number"},
        Fault{"axis", "up: w\n" + particle("{pos: [0, 0, 0], mass: 1}"),
              "s.yaml:1:5: up: an unknown axis; got w, expected x, y or z"},
        Fault{"force", std::string(two) + "forces: [{drog: {coefficient: 1}}]\n",
              "did you mean drag?"},
        Fault{"plane",
              std::string(two) + "contacts: [{plane: {point: [0, 0, 0], normal: [0, 0, 0], "
                                 "stiffness: 1}}]\n",
              "contacts[0].plane.normal: zero vector"},
        Fault{"rate",
              std::string(two) + "emitters: [{position: [0, 0, 0], velocity: [0, 0, 1], "
                                 "rate: 0, mass: 1}]\n",
              "emitters[0].rate: zero"},
        Fault{"cloth_rows", std::string(two) + "cloth: [{rows: 1, columns: 3}]\n",
              "cloth[0].rows: out of range; got 1"},
        Fault{"too_many", std::string(two) + "cloth: [{rows: 1000000, columns: 1000000}]\n",
              "too many particles"},
        Fault{"deep", std::string(100, '['), "nested too deeply"},
        Fault{"alias_bomb", bomb(), "too much once its aliases are written out"},
        Fault{"self_anchor", "a: &a [*a]\n", "s.yaml:1:8: scene: an alias within its own anchor"},
        Fault{"second_document", std::string(two) + "---\nmore: 1\n", "a second document"},
        Fault{"empty", "", "s.yaml:1:1: scene: empty"},
        Fault{"comment_only", "# nothing\n", "scene: empty"},
        Fault{"a_list", "- 1\n", "scene: not a mapping; got a list of 1"},
        Fault{"binary", std::string("ab\0cd", 5), "s.yaml:1:3: scene: a binary file"},
        Fault{"not_utf8", "name: \xff\n", "s.yaml:1:7: scene: not UTF-8 text; got the byte 0xff"},
        Fault{"overlong", "name: \xc0\xaf\n", "not UTF-8"},
        Fault{"truncated", "particles: [{pos: [0, 0", "scene: not YAML"},
        Fault{"tag", "name: !!python/object x\n", "scene: a tag"}),
    [](const auto& fault) { return fault.param.name; });

struct Oddity {
  const char* name;
  std::string text;
  const char* warning;
  friend std::ostream& operator<<(std::ostream& out, const Oddity& x) { return out << x.name; }
};
class SceneOddity : public testing::TestWithParam<Oddity> {};
TEST_P(SceneOddity, IsAWarning) {
  const auto warnings = read_scene("s.yaml", GetParam().text).warnings;
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_TRUE(warnings[0].starts_with("s.yaml:")) << warnings[0];
  EXPECT_NE(warnings[0].find(GetParam().warning), std::string::npos) << warnings[0];
}
INSTANTIATE_TEST_SUITE_P(
    SceneReader, SceneOddity,
    testing::Values(
        Oddity{"duplicate_spring",
               springs("particle_ids: [0, 1], stiffness: 1}\n  - {particle_ids: [1, 0], "
                       "stiffness: 2"),
               "s.yaml:9:5: springs: duplicate spring between particles 0 and 1"},
        Oddity{"negative_damping", springs("particle_ids: [0, 1], stiffness: 1, damping: -1"),
               "springs[0].damping: negative damping"},
        Oddity{"moving_fixed", particle("{pos: [0, 0, 0], fixed: true, vel: [1, 0, 0]}"),
               "of a fixed particle is not used"}),
    [](const auto& fault) { return fault.param.name; });

TEST(SceneReader, NegativeDampingMayBeMeant) {
  EXPECT_TRUE(read_scene("s.yaml", "allow_negative_damping: true\n" +
                                       springs("particle_ids: [0, 1], stiffness: 1, damping: -1"))
                  .warnings.empty());
}

TEST(SceneReader, WhoReadsMayBringTheSolver) {
  scene::ReadOptions options;
  options.need_solver = false;
  EXPECT_EQ(error_of("particles: [{pos: [0, 0, 0], mass: 1}]\n", options), "");
}

TEST(SceneReader, RefusesWhatIsNoFile) {
  const tests::TemporaryFolder folder;
  const auto error_of_file = [](const std::string& path, const scene::ReadOptions& options = {}) {
    try {
      scene::read_scene_file(path, options);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const std::string base = folder.path().string();
  EXPECT_NE(error_of_file(base).find("got a directory"), std::string::npos);
  EXPECT_NE(error_of_file(base + "/none.yaml")
                .find("none.yaml:1:1: scene: cannot be read; got No "
                      "such file"),
            std::string::npos);
  ASSERT_EQ(::mkfifo((base + "/pipe").c_str(), 0600), 0);
  EXPECT_NE(error_of_file(base + "/pipe").find("got a FIFO"), std::string::npos);
  tests::write_text(folder.path() / "large.yaml", std::string(1000, '#'));
  scene::ReadOptions options;
  options.most_bytes = 999;
  EXPECT_NE(error_of_file(base + "/large.yaml", options).find("--max-megabytes"),
            std::string::npos);
  options.most_particles = 1;
  EXPECT_NE(error_of(two, options).find("--max-particles"), std::string::npos);
}

}  // namespace
}  // namespace odeum::scene_refusal_test
