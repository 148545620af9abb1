// COLLADA (Khronos Group, "COLLADA - Digital Asset Schema Release 1.4.1", 2008): geometry of
// triangles, polylist and polygons; nodes of the visual scene with their transforms; diffuse
// colours.

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <pugixml.hpp>
#include <string_view>
#include <unordered_map>

#include "assets/readers.h"
#include "assets/shape_builder.h"
#include "base/error.h"
#include "base/trig.h"

namespace ccmorse::assets {
namespace {

constexpr int kDeepestNode = 64;  // nodes within nodes

// A library's elements by id, and the words of their texts as numbers.
class ColladaReader {
 public:
  ColladaReader(const std::string& name, const AssetLimits& limits)
      : name_(name), limits_(limits), builder_(scene_, name_, limits_) {}

  AssetScene Read(const Bytes& bytes) {
    pugi::xml_document document;
    const pugi::xml_parse_result result =
        document.load_buffer(bytes.data(), bytes.size(), pugi::parse_default, pugi::encoding_auto);
    if (!result) {
      builder_.Fail(fmt::format("offset {}: {}", result.offset, result.description()));
    }
    const pugi::xml_node root = document.child("COLLADA");
    if (!root) builder_.Fail("is no COLLADA: its outermost element is another");
    scene_.format = fmt::format("COLLADA {}", root.attribute("version").as_string("?"));
    Affine to_world;
    const double unit = root.child("asset").child("unit").attribute("meter").as_double(1.0);
    const double metre = std::isfinite(unit) && unit > 0.0 ? unit : 1.0;
    const std::string_view up = root.child("asset").child_value("up_axis");
    if (up.find('Z') != std::string_view::npos) {
      to_world = {{metre, 0, 0}, {0, metre, 0}, {0, 0, metre}, {}};
    } else if (up.find('X') != std::string_view::npos) {
      to_world = {{0, 0, metre}, {-metre, 0, 0}, {0, -metre, 0}, {}};  // x up, y to the left
    } else {
      to_world = {{metre, 0, 0}, {0, 0, metre}, {0, -metre, 0}, {}};
    }
    // Flat, so that a file's depth of elements is no concern.
    for (const pugi::xml_node library : root.children()) {
      for (const pugi::xml_node element : library.children()) Note(element);
    }
    ReadMaterials(root);
    const pugi::xml_node shown =
        Find(root.child("scene").child("instance_visual_scene").attribute("url"));
    const pugi::xml_node scene =
        shown ? shown : root.child("library_visual_scenes").child("visual_scene");
    for (const pugi::xml_node node : scene.children("node")) ReadNode(node, to_world, -1, 1);
    if (!scene) {
      // Geometry alone, without a scene of it.
      for (const pugi::xml_node geometry : root.child("library_geometries").children("geometry")) {
        AddGeometry(geometry, {}, geometry.attribute("name").as_string("geometry"), to_world, -1);
      }
    }
    return std::move(scene_);
  }

 private:
  void Note(const pugi::xml_node& element) {
    const pugi::xml_attribute id = element.attribute("id");
    if (id) by_id_.emplace(id.value(), element);
  }

  // The element that "#id" names.
  pugi::xml_node Find(const pugi::xml_attribute& url) const {
    const std::string_view text = url.value();
    if (!text.starts_with('#')) return {};
    const auto found = by_id_.find(std::string(text.substr(1)));
    return found != by_id_.end() ? found->second : pugi::xml_node();
  }

  template <typename T>
  std::vector<T> Numbers(const pugi::xml_node& element) const {
    std::vector<T> numbers;
    const std::string_view text = element.child_value();
    for (std::size_t at = 0;;) {
      at = text.find_first_not_of(" \t\r\n", at);
      if (at == std::string_view::npos) break;
      T number{};
      const auto result = std::from_chars(text.data() + at, text.data() + text.size(), number);
      if (result.ec != std::errc()) {
        builder_.Fail(fmt::format("offset {}: <{}> holds something that is no number",
                                  element.offset_debug(), element.name()));
      }
      numbers.push_back(number);
      at = static_cast<std::size_t>(result.ptr - text.data());
    }
    return numbers;
  }

  // An effect's diffuse colour stands beneath one of phong, lambert, blinn and constant.
  void ReadMaterials(const pugi::xml_node& root) {
    for (const pugi::xml_node image : root.child("library_images").children("image")) {
      const pugi::xml_node from = image.child("init_from");
      const pugi::xml_node ref = from.child("ref");
      scene_.images.push_back({image.attribute("name").as_string(image.attribute("id").value()),
                               ref ? ref.child_value() : from.child_value(), 0});
      image_at_.emplace(image.attribute("id").value(), static_cast<int>(scene_.images.size()) - 1);
    }
    for (const pugi::xml_node given : root.child("library_materials").children("material")) {
      AssetMaterial material;
      material.name = given.attribute("name").as_string(given.attribute("id").value());
      const pugi::xml_node profile =
          Find(given.child("instance_effect").attribute("url")).child("profile_COMMON");
      for (const pugi::xml_node shading : profile.child("technique").children()) {
        const pugi::xml_node diffuse = shading.child("diffuse");
        if (const pugi::xml_node color = diffuse.child("color")) {
          const std::vector<double> parts = Numbers<double>(color);
          if (parts.size() >= 3) {
            material.color = {FromShare(parts[0]), FromShare(parts[1]), FromShare(parts[2])};
          }
        }
        if (const pugi::xml_node texture = diffuse.child("texture")) {
          material.image = ImageOf(profile, texture.attribute("texture").value());
        }
      }
      material_at_.emplace(given.attribute("id").value(),
                           static_cast<int>(scene_.materials.size()));
      scene_.materials.push_back(std::move(material));
    }
  }

  // A texture names a sampler, that a surface, that an image; or the image at once.
  int ImageOf(const pugi::xml_node& profile, std::string name) const {
    for (int step = 0; step < 3; ++step) {
      const auto found = image_at_.find(name);
      if (found != image_at_.end()) return found->second;
      const pugi::xml_node param = profile.find_child_by_attribute("newparam", "sid", name.c_str());
      if (!param) return -1;
      name = param.child("sampler2D") ? param.child("sampler2D").child_value("source")
                                      : param.child("surface").child_value("init_from");
    }
    return -1;
  }

  // Transforms of a node, applied in the order in which they stand.
  Affine MatrixOf(const pugi::xml_node& node) const {
    Affine matrix;
    for (const pugi::xml_node step : node.children()) {
      const std::string_view kind = step.name();
      const bool is_step =
          kind == "matrix" || kind == "translate" || kind == "rotate" || kind == "scale";
      if (!is_step) continue;
      const std::vector<double> v = Numbers<double>(step);
      Affine own;
      if (kind == "matrix" && v.size() == 16) {  // row by row
        own = {{v[0], v[4], v[8]}, {v[1], v[5], v[9]}, {v[2], v[6], v[10]}, {v[3], v[7], v[11]}};
      } else if (kind == "translate" && v.size() == 3) {
        own.position = {v[0], v[1], v[2]};
      } else if (kind == "rotate" && v.size() == 4) {
        const double half = v[3] * kPi / 360.0;
        const Vec3 axis{v[0], v[1], v[2]};
        const double length = std::sqrt(Dot(axis, axis));
        if (length > 0.0) own = FromQuaternion(std::cos(half), (std::sin(half) / length) * axis);
      } else if (kind == "scale" && v.size() == 3) {
        own = {{v[0], 0, 0}, {0, v[1], 0}, {0, 0, v[2]}, {}};
      } else {
        builder_.Fail(fmt::format("offset {}: <{}> has {} numbers", step.offset_debug(),
                                  step.name(), v.size()));
      }
      matrix = matrix * own;
    }
    return matrix;
  }

  void ReadNode(const pugi::xml_node& node, const Affine& above, int parent, int depth) {
    if (depth > kDeepestNode) builder_.Fail("has nodes within nodes too deep, or in a circle");
    const Affine matrix = above * MatrixOf(node);
    std::string name = node.attribute("name").as_string(node.attribute("id").value());
    if (name.empty()) name = "node";
    int own = -1;
    for (const pugi::xml_node instance : node.children("instance_geometry")) {
      AddGeometry(Find(instance.attribute("url")), instance, name, matrix, parent);
      own = static_cast<int>(scene_.objects.size()) - 1;
    }
    if (own < 0) {
      builder_.AddObject(name, matrix, "EMPTY").parent = parent;
      own = static_cast<int>(scene_.objects.size()) - 1;
    }
    for (const pugi::xml_node child : node.children("node")) {
      ReadNode(child, matrix, own, depth + 1);
    }
    for (const pugi::xml_node instance : node.children("instance_node")) {
      const pugi::xml_node other = Find(instance.attribute("url"));
      if (other) ReadNode(other, matrix, own, depth + 1);
    }
  }

  void AddGeometry(const pugi::xml_node& geometry, const pugi::xml_node& instance,
                   const std::string& name, const Affine& matrix, int parent) {
    AssetObject& object = builder_.AddObject(name, matrix);
    object.parent = parent;
    const pugi::xml_node mesh = geometry.child("mesh");
    const auto in_mesh = [&](std::string_view url) {
      if (!url.starts_with('#')) return pugi::xml_node();
      return mesh.find_child_by_attribute("id", std::string(url.substr(1)).c_str());
    };
    // <vertices> stands for the source of its positions.
    pugi::xml_node positions = in_mesh(mesh.child("vertices")
                                           .find_child_by_attribute("input", "semantic", "POSITION")
                                           .attribute("source")
                                           .value());
    const std::vector<double> numbers = Numbers<double>(positions.child("float_array"));
    const std::size_t stride = std::max<std::size_t>(
        3, positions.child("technique_common").child("accessor").attribute("stride").as_uint(3));
    for (std::size_t i = 0; i + 2 < numbers.size(); i += stride) {
      builder_.AddVertex(matrix({numbers[i], numbers[i + 1], numbers[i + 2]}), object);
    }
    const bool mirrored = matrix.Determinant() < 0.0;
    for (const pugi::xml_node faces : mesh.children()) {
      const std::string_view kind = faces.name();
      if (kind != "triangles" && kind != "polylist" && kind != "polygons") continue;
      const int material = MaterialOf(instance, faces.attribute("material").value());
      std::size_t inputs = 0;
      std::size_t offset = 0;
      for (const pugi::xml_node input : faces.children("input")) {
        const std::size_t at = input.attribute("offset").as_uint(0);
        inputs = std::max(inputs, at + 1);
        if (std::string_view(input.attribute("semantic").value()) == "VERTEX") offset = at;
      }
      const std::vector<int> counts =
          kind == "polylist" ? Numbers<int>(faces.child("vcount")) : std::vector<int>();
      for (const pugi::xml_node list : faces.children("p")) {
        AddFaces(Numbers<int>(list), kind, counts, inputs, offset, mirrored, material, object);
      }
    }
  }

  void AddFaces(const std::vector<int>& list, std::string_view kind, const std::vector<int>& counts,
                std::size_t inputs, std::size_t offset, bool mirrored, int material,
                AssetObject& object) {
    if (inputs == 0) return;
    const std::size_t corners = list.size() / inputs;
    std::size_t at = 0;
    std::vector<int> face;
    for (std::size_t i = 0; at < corners; ++i) {
      std::size_t count = 3;
      if (kind == "polygons") count = corners;
      if (kind == "polylist") {
        if (i >= counts.size()) break;
        if (counts[i] < 0) builder_.Fail("has a face of less than no corners");
        count = static_cast<std::size_t>(counts[i]);
      }
      if (count > corners - at) {
        builder_.Fail(fmt::format("a face of '{}' lacks corners", object.name));
      }
      face.clear();
      for (std::size_t k = 0; k < count; ++k) face.push_back(list[(at + k) * inputs + offset]);
      if (mirrored) std::reverse(face.begin(), face.end());
      builder_.AddFace(face, material, object);
      at += count;
    }
  }

  // Faces name a symbol, which each instance binds to a material.
  int MaterialOf(const pugi::xml_node& instance, const char* symbol) const {
    const pugi::xml_node binding =
        instance.child("bind_material")
            .child("technique_common")
            .find_child_by_attribute("instance_material", "symbol", symbol);
    const std::string_view target = binding.attribute("target").value();
    const auto found =
        material_at_.find(target.starts_with('#') ? std::string(target.substr(1)) : symbol);
    return found != material_at_.end() ? found->second : -1;
  }

  const std::string& name_;
  const AssetLimits& limits_;
  AssetScene scene_;
  ShapeBuilder builder_;
  std::unordered_map<std::string, pugi::xml_node> by_id_;
  std::unordered_map<std::string, int> image_at_;
  std::unordered_map<std::string, int> material_at_;
};

}  // namespace

AssetScene ReadCollada(const Bytes& bytes, const std::string& name, const AssetLimits& limits) {
  return ColladaReader(name, limits).Read(bytes);
}

}  // namespace ccmorse::assets
