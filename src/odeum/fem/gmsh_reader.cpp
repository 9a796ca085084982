// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/fem/gmsh_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <unordered_map>

#include "odeum/fem/token_reader.hpp"
#include "odeum/input/text_file.hpp"

namespace odeum::fem {
namespace {

const char* element_name(int type) {
  return type == 3   ? "a quadrangle"
         : type == 4 ? "a tetrahedron"
         : type == 8 ? "a line of second order"
         : type == 9 ? "a triangle of second order"
                     : "another element";
}

class Reader {
 public:
  Reader(const std::string& file, const std::string& text) : tokens_(file, text) {}

  GmshMesh read() {
    bool begun = false;
    for (std::string_view word = tokens_.next(); !word.empty(); word = tokens_.next()) {
      const std::string section(word);
      if (!section.starts_with('$') || section.starts_with("$End"))
        tokens_.refuse("the file", word, "$ and the name of a section");
      if (!begun && section != "$MeshFormat" && section != "$Comments")
        tokens_.refuse("the file", word, "$MeshFormat: a mesh of Gmsh");
      begun = begun || section == "$MeshFormat";
      static const std::map<std::string, void (Reader::*)()> readers = {
          {"$MeshFormat", &Reader::read_format},
          {"$PhysicalNames", &Reader::read_names},
          {"$Entities", &Reader::read_entities},
          {"$Nodes", &Reader::read_nodes},
          {"$Elements", &Reader::read_elements}};
      const std::string end = "$End" + section.substr(1);
      if (const auto reader = readers.find(section); reader == readers.end())
        skip(end);
      else
        (this->*reader->second)(), tokens_.expect(end);
    }
    if (!begun) tokens_.refuse("the file", "", "$MeshFormat: a mesh of Gmsh");
    finish();
    return std::move(result_);
  }

 private:
  void skip(const std::string& end) {
    const Place begin = tokens_.place();
    for (std::string_view word = tokens_.next(); word != end; word = tokens_.next())
      if (word.empty())
        tokens_.fail(begin, fmt::format("the section does not end; expected {}", shown(end)));
  }

  void read_format() {
    const std::string_view version = tokens_.next();
    if (version != "4.1")
      tokens_.refuse("the version", version, "4.1 (Gmsh writes it with -format msh41)");
    if (const std::string_view kind = tokens_.next(); kind != "0")
      tokens_.refuse("the kind of file", kind, "0, ASCII (Gmsh: without -bin)");
    tokens_.count("the size of a number");
  }

  void read_names() {
    const std::size_t count = tokens_.count("the number of names");
    for (std::size_t i = 0; i < count; ++i) {
      const int dimension = tokens_.integer("a dimension"), tag = tokens_.integer("a tag");
      names_[{dimension, tag}] = tokens_.quoted("a physical name");
    }
  }

  void read_entities() {
    std::size_t counts[4];
    for (std::size_t& count : counts) count = tokens_.count("the number of entities");
    for (int dimension = 0; dimension < 4; ++dimension)
      for (std::size_t i = 0; i < counts[dimension]; ++i) {
        const int tag = tokens_.integer("the tag of an entity");
        for (int k = 0; k < (dimension == 0 ? 3 : 6); ++k) tokens_.real("a coordinate");
        const std::size_t physical = tokens_.count("the number of physical groups");
        for (std::size_t k = 0; k < physical; ++k) {
          const int group = tokens_.integer("a physical group");
          if (dimension == 1) groups_[tag].push_back(group);
        }
        if (dimension == 0) continue;
        const std::size_t bounding = tokens_.count("the number of bounding entities");
        for (std::size_t k = 0; k < bounding; ++k) tokens_.integer("a bounding entity");
      }
  }

  /// The blocks of a section, whose head says how many entries they add to `all`; `number` is what
  /// errors call that count.
  template <class All, class ReadBlock>
  void read_blocks(const char* number, const All& all, ReadBlock&& read_block) {
    const std::size_t blocks = tokens_.count("the number of blocks");
    const std::size_t count = tokens_.count(number);
    const Place counted = tokens_.place();
    tokens_.count("the least tag"), tokens_.count("the greatest tag");
    for (std::size_t block = 0; block < blocks; ++block) read_block();
    if (all.size() != count)
      tokens_.fail(counted, fmt::format("{}: got {}, but {} follow", number, count, all.size()));
  }

  void read_nodes() {
    if (!nodes_.empty()) tokens_.refuse("the file", "$Nodes twice", "one section of nodes");
    read_blocks("the number of nodes", nodes_, [this] {
      const int dimension = tokens_.integer("the dimension of an entity");
      tokens_.integer("the tag of an entity");
      const bool parametric = tokens_.count("whether there are parameters") != 0;
      const std::size_t here = tokens_.count("the number of nodes");
      std::vector<std::size_t> tags;
      for (std::size_t i = 0; i < here; ++i) {
        tags.push_back(tokens_.count("the tag of a node"));
        if (!nodes_.emplace(tags.back(), nodes_.size()).second)
          tokens_.fail(tokens_.place(), fmt::format("node {} is there twice", tags.back()));
      }
      for (const std::size_t tag : tags) {
        const double x = tokens_.real("a coordinate");
        node_places_.push_back(tokens_.place());
        const double y = tokens_.real("a coordinate");
        result_.mesh.nodes.push_back({x, y});
        heights_.push_back(tokens_.real("a coordinate"));
        for (int k = 0; parametric && k < std::clamp(dimension, 0, 3); ++k)
          tokens_.real("a parameter");
        tags_.nodes.push_back(tag);
      }
    });
  }

  std::size_t node() {
    const std::size_t tag = tokens_.count("a node");
    const auto found = nodes_.find(tag);
    if (found == nodes_.end())
      tokens_.fail(
          tokens_.place(),
          fmt::format("element refers to node {}, which the file does not define ({} nodes "
                      "read)",
                      tag, nodes_.size()));
    return found->second;
  }

  void read_elements() {
    read_blocks("the number of elements", elements_, [this] {
      tokens_.integer("the dimension of an entity");
      const int entity = tokens_.integer("the tag of an entity");
      const int type = tokens_.integer("the type of elements");
      if (type != 1 && type != 2 && type != 15)
        tokens_.refuse("the type of elements", fmt::format("{}, {}", type, element_name(type)),
                       "15, 1 or 2: points, lines, triangles of three nodes");
      const std::size_t here = tokens_.count("the number of elements");
      for (std::size_t i = 0; i < here; ++i) read_element(type, entity);
    });
  }

  void read_element(int type, int entity) {
    const std::size_t tag = tokens_.count("the tag of an element");
    const Place place = tokens_.place();
    if (!elements_.insert(tag).second)
      tokens_.fail(place, fmt::format("element {} is there twice", tag));
    if (type == 15) {
      node();
    } else if (type == 1) {
      GmshMesh::Line line{{node(), node()}, {}};
      for (const int group : groups_[entity]) {
        const auto named = names_.find({1, group});
        line.groups.push_back(named == names_.end() ? std::to_string(group) : named->second);
      }
      result_.groups.insert(result_.groups.end(), line.groups.begin(), line.groups.end());
      std::ranges::sort(line.nodes);
      result_.lines.push_back(std::move(line));
    } else {
      const std::size_t a = node(), b = node(), c = node();
      result_.mesh.triangles.push_back({a, b, c});
      tags_.triangles.push_back(tag), triangle_places_.push_back(place);
    }
  }

  void finish() {
    TriangleMesh& mesh = result_.mesh;
    double extent = 0;
    for (const Point p : mesh.nodes) extent = std::max({extent, std::abs(p.x), std::abs(p.y)});
    for (std::size_t i = 0; i < heights_.size(); ++i)
      // What a rotation of the plane by rounding would give.
      if (std::abs(heights_[i] - heights_[0]) > 1e-12 * extent)
        tokens_.fail(node_places_[i],
                     fmt::format("node {} has z = {}, the first one {}: the mesh is "
                                 "in no plane of constant z",
                                 tags_.nodes[i], heights_[i], heights_[0]));
    bool clockwise = true;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      clockwise = clockwise && doubled_area(mesh, t) < 0;
    if (clockwise)
      for (auto& ids : mesh.triangles) std::swap(ids[1], ids[2]);
    try {
      check(mesh, tags_);
    } catch (const MeshError& error) {
      tokens_.fail(error.of() == MeshError::Of::node       ? node_places_[error.number()]
                   : error.of() == MeshError::Of::triangle ? triangle_places_[error.number()]
                                                           : tokens_.place(),
                   error.what());
    }
    std::ranges::sort(result_.groups);
    result_.groups.erase(std::unique(result_.groups.begin(), result_.groups.end()),
                         result_.groups.end());
    std::ranges::sort(result_.lines,
                      [](const auto& l, const auto& r) { return l.nodes < r.nodes; });
  }

  TokenReader tokens_;
  GmshMesh result_;
  MeshTags tags_;
  std::map<std::pair<int, int>, std::string> names_;  // by dimension and tag
  std::map<int, std::vector<int>> groups_;            // of curves
  std::unordered_map<std::size_t, std::size_t> nodes_;
  std::set<std::size_t> elements_;
  std::vector<Place> node_places_, triangle_places_;
  std::vector<double> heights_;
};

}  // namespace

bool GmshMesh::in_group(const std::array<std::size_t, 2>& edge, const std::string& group) const {
  const std::array sorted{std::min(edge[0], edge[1]), std::max(edge[0], edge[1])};
  for (auto line = std::ranges::lower_bound(lines, sorted, {}, &Line::nodes);
       line != lines.end() && line->nodes == sorted; ++line)
    if (std::ranges::find(line->groups, group) != line->groups.end()) return true;
  return false;
}

GmshMesh read_gmsh(const std::string& file, const std::string& text) {
  return Reader(file, text).read();
}

GmshMesh read_gmsh_file(const std::string& file) {
  return read_gmsh(file, read_text_file(file, "mesh", most_mesh_bytes));
}

}  // namespace odeum::fem
