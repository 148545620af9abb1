// glTF 2.0 (Khronos Group, "glTF 2.0 Specification", 2021): section numbers below are its.

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <unordered_map>

#include "assets/readers.h"
#include "assets/shape_builder.h"
#include "base/base64.h"
#include "base/error.h"

namespace ccmorse::assets {
namespace {

constexpr std::uint32_t kGltfMagic = 0x46546C67;  // "glTF" (4.4.2)
constexpr std::uint32_t kJson = 0x4E4F534A;       // "JSON"
constexpr std::uint32_t kBinary = 0x004E4942;     // "BIN"
constexpr int kDeepestGltfNode = 64;              // nodes within nodes

// y up and z forward there, z up here (3.4).
Vec3 Upright(const Vec3& v) { return {v.x, -v.z, v.y}; }

class GltfReader {
 public:
  GltfReader(const std::string& name, const FindFile& find, const AssetLimits& limits)
      : name_(name), find_(find), limits_(limits), builder_(scene_, name_, limits_) {}

  AssetScene Read(const Bytes& bytes) {
    std::string text(bytes.begin(), bytes.end());
    if (bytes.size() >= 12 && Little(bytes, 0, 4) == kGltfMagic) text = Unpack(bytes);
    try {
      root_ = Json::Parse(text);
    } catch (const JsonError& error) {
      throw Error(fmt::format("{}:{}: {} (column {})", name_, error.line(), error.reason(),
                              error.column()));
    }
    if (!root_.IsObject()) builder_.Fail("must be a JSON object");
    const Json* const asset = root_.Find("asset");
    const std::string version = asset != nullptr ? Text(*asset, "version") : "";
    if (!version.starts_with("2")) {
      builder_.Fail(fmt::format("is of glTF {}, and 2.0 can be read",
                                version.empty() ? "an unknown version" : "another version"));
    }
    scene_.format = "glTF 2.0";
    if (const Json* const required = root_.Find("extensionsRequired");
        required != nullptr && required->IsArray() && !required->AsArray().empty()) {
      builder_.Fail(
          "needs extensions, such as compressed meshes, which are not read; save it "
          "without them");
    }
    ReadMaterials();
    const std::size_t chosen = Index(root_, "scene").value_or(0);
    const Json* const shown = Item("scenes", chosen);
    if (shown != nullptr) {
      for (const std::size_t node : Indexes(*shown, "nodes")) ReadNode(node, {}, -1, 1);
    } else {
      for (std::size_t i = 0; Item("nodes", i) != nullptr; ++i) {
        if (!IsChild(i)) ReadNode(i, {}, -1, 1);
      }
    }
    return std::move(scene_);
  }

 private:
  static std::uint64_t Little(std::span<const std::uint8_t> bytes, std::size_t at,
                              std::size_t size) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < size; ++i) value |= std::uint64_t{bytes[at + i]} << (8 * i);
    return value;
  }

  // A .glb: a head and chunks, of which the first is the JSON (4.4).
  std::string Unpack(const Bytes& bytes) {
    std::string text;
    for (std::size_t at = 12; bytes.size() - at >= 8;) {
      const std::uint64_t size = Little(bytes, at, 4);
      const std::uint64_t kind = Little(bytes, at + 4, 4);
      at += 8;
      if (size > bytes.size() - at) {
        builder_.Fail(fmt::format("offset {}: is cut short within a chunk", at - 8));
      }
      const auto first = bytes.begin() + static_cast<std::ptrdiff_t>(at);
      const auto last = first + static_cast<std::ptrdiff_t>(size);
      if (kind == kJson && text.empty()) text.assign(first, last);
      if (kind == kBinary && binary_.empty()) binary_.assign(first, last);
      at += static_cast<std::size_t>(size);
    }
    if (text.empty()) builder_.Fail("has no chunk of JSON");
    return text;
  }

  static std::string Text(const Json& object, const char* key) {
    const Json* const value = object.Find(key);
    return value != nullptr && value->IsString() ? value->AsString() : "";
  }

  // A whole number >= 0; nothing where there is none.
  std::optional<std::size_t> Index(const Json& object, const char* key) const {
    const Json* const value = object.Find(key);
    if (value == nullptr) return std::nullopt;
    if (!value->IsInt() || value->AsInt() < 0) {
      throw Error(
          fmt::format("{}:{}: '{}' must be a whole number >= 0", name_, value->line(), key));
    }
    return static_cast<std::size_t>(value->AsInt());
  }

  std::vector<std::size_t> Indexes(const Json& object, const char* key) const {
    std::vector<std::size_t> indexes;
    const Json* const list = object.Find(key);
    if (list == nullptr || !list->IsArray()) return indexes;
    for (const Json& item : list->AsArray()) {
      if (!item.IsInt() || item.AsInt() < 0) {
        throw Error(
            fmt::format("{}:{}: '{}' must be of whole numbers >= 0", name_, item.line(), key));
      }
      indexes.push_back(static_cast<std::size_t>(item.AsInt()));
    }
    return indexes;
  }

  const Json* Item(const char* list, std::size_t index) const {
    const Json* const items = root_.Find(list);
    if (items == nullptr || !items->IsArray() || index >= items->AsArray().size()) return nullptr;
    const Json& item = items->AsArray()[index];
    return item.IsObject() ? &item : nullptr;
  }

  const Json& Need(const char* list, std::size_t index) const {
    const Json* const item = Item(list, index);
    if (item == nullptr)
      builder_.Fail(fmt::format("refers to {}[{}], which is not there", list, index));
    return *item;
  }

  // Numbers of a list, as many as `values` has; false where it is not there.
  static bool Numbers(const Json& object, const char* key, std::span<double> values) {
    const Json* const list = object.Find(key);
    if (list == nullptr || !list->IsArray() || list->AsArray().size() != values.size())
      return false;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!list->AsArray()[i].IsNumber()) return false;
      values[i] = list->AsArray()[i].AsDouble();
    }
    return true;
  }

  void ReadMaterials() {
    for (std::size_t i = 0; const Json* const image = Item("images", i); ++i) {
      const std::string uri = Text(*image, "uri");
      scene_.images.push_back(
          {Text(*image, "name"), uri.starts_with("data:") ? "" : uri, uri.size()});
      if (!scene_.images.back().path.empty()) scene_.images.back().packed_size = 0;
    }
    for (std::size_t i = 0; const Json* const given = Item("materials", i); ++i) {
      AssetMaterial material;
      material.name = Text(*given, "name");
      material.color = {255, 255, 255};
      if (const Json* const surface = given->Find("pbrMetallicRoughness")) {
        std::array<double, 4> factor{};
        if (Numbers(*surface, "baseColorFactor", factor)) {
          material.color = {FromLinear(factor[0]), FromLinear(factor[1]), FromLinear(factor[2])};
          if (factor[3] >= 0.0 && factor[3] <= 1.0) material.alpha = factor[3];
        }
        if (const Json* const slot = surface->Find("baseColorTexture")) {
          const std::size_t at = Index(*slot, "index").value_or(0);
          if (const Json* const texture = Item("textures", at)) {
            const std::size_t image = Index(*texture, "source").value_or(scene_.images.size());
            if (image < scene_.images.size()) material.image = static_cast<int>(image);
          }
        }
      }
      scene_.materials.push_back(std::move(material));
    }
  }

  bool IsChild(std::size_t index) const {
    for (std::size_t i = 0; const Json* const node = Item("nodes", i); ++i) {
      for (const std::size_t child : Indexes(*node, "children")) {
        if (child == index) return true;
      }
    }
    return false;
  }

  static Affine MatrixOf(const Json& node) {
    std::array<double, 16> m{};
    if (Numbers(node, "matrix", m)) {  // column by column (3.5.3)
      return {{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}, {m[12], m[13], m[14]}};
    }
    std::array<double, 3> t{};
    std::array<double, 4> r{0.0, 0.0, 0.0, 1.0};
    std::array<double, 3> s{1.0, 1.0, 1.0};
    Numbers(node, "translation", t);
    Numbers(node, "rotation", r);
    if (!Numbers(node, "scale", s)) s = {1.0, 1.0, 1.0};
    Affine matrix = FromQuaternion(r[3], {r[0], r[1], r[2]});
    matrix.x = s[0] * matrix.x;
    matrix.y = s[1] * matrix.y;
    matrix.z = s[2] * matrix.z;
    matrix.position = {t[0], t[1], t[2]};
    return matrix;
  }

  void ReadNode(std::size_t index, const Affine& above, int parent, int depth) {
    if (depth > kDeepestGltfNode) builder_.Fail("has nodes within nodes too deep, or in a circle");
    const Json& node = Need("nodes", index);
    const Affine matrix = above * MatrixOf(node);
    const std::optional<std::size_t> mesh = Index(node, "mesh");
    std::string name = Text(node, "name");
    if (name.empty()) name = fmt::format("node_{}", index);
    // What the file calls forward, right and up are our axes turned.
    const Affine upright = {Upright(matrix.x), -1.0 * Upright(matrix.z), Upright(matrix.y),
                            Upright(matrix.position)};
    builder_.AddObject(name, upright, mesh ? "MESH" : "EMPTY").parent = parent;
    const std::size_t object = scene_.objects.size() - 1;
    if (mesh) {
      const Json* const primitives = Need("meshes", *mesh).Find("primitives");
      if (primitives != nullptr && primitives->IsArray()) {
        for (const Json& primitive : primitives->AsArray()) {
          ReadPrimitive(primitive, matrix, scene_.objects[object]);
        }
      }
    }
    for (const std::size_t child : Indexes(node, "children")) {
      ReadNode(child, matrix, static_cast<int>(object), depth + 1);
    }
  }

  // Numbers in a buffer (3.6.2).
  struct View {
    std::span<const std::uint8_t> bytes;
    std::size_t stride = 0;
    std::size_t count = 0;
    std::int64_t kind = 0;
  };

  const Bytes& Buffer(std::size_t index) {
    const auto found = buffers_.find(index);
    if (found != buffers_.end()) return found->second;
    const std::string uri = Text(Need("buffers", index), "uri");
    Bytes bytes;
    if (uri.empty() && index == 0) {
      bytes = binary_;
    } else if (uri.starts_with("data:")) {
      const std::size_t comma = uri.find(";base64,");
      if (comma == std::string::npos) builder_.Fail("has a buffer that is not in base64");
      std::string decoded;
      try {
        decoded = FromBase64(uri.substr(comma + 8));
      } catch (const Error&) {
        builder_.Fail("has a buffer whose base64 is broken");
      }
      bytes.assign(decoded.begin(), decoded.end());
    } else {
      bytes = find_(uri);
    }
    return buffers_.emplace(index, std::move(bytes)).first->second;
  }

  View ReadAccessor(std::size_t index, const char* type, std::size_t parts) {
    const Json& accessor = Need("accessors", index);
    View view;
    view.count = Index(accessor, "count").value_or(0);
    view.kind = static_cast<std::int64_t>(Index(accessor, "componentType").value_or(0));
    if (Text(accessor, "type") != type || accessor.Find("sparse") != nullptr) {
      builder_.Fail(fmt::format("accessors[{}] must be a plain {}", index, type));
    }
    std::size_t size = 0;
    if (view.kind == 5121) size = 1;
    if (view.kind == 5123) size = 2;
    if (view.kind == 5125 || view.kind == 5126) size = 4;
    if (size == 0) {
      builder_.Fail(
          fmt::format("accessors[{}] has numbers of kind {}, which positions and indexes "
                      "have not",
                      index, view.kind));
    }
    const Json& place =
        Need("bufferViews",
             Index(accessor, "bufferView").value_or(std::numeric_limits<std::size_t>::max()));
    const Bytes& buffer = Buffer(Index(place, "buffer").value_or(0));
    const std::size_t start = Index(place, "byteOffset").value_or(0);
    const std::size_t length = Index(place, "byteLength").value_or(0);
    const std::size_t offset = Index(accessor, "byteOffset").value_or(0);
    view.stride = Index(place, "byteStride").value_or(size * parts);
    if (start > buffer.size() || length > buffer.size() - start || offset > length ||
        view.stride < size * parts ||
        (view.count > 0 && (length - offset < size * parts ||
                            (length - offset - size * parts) / view.stride < view.count - 1))) {
      builder_.Fail(fmt::format("accessors[{}] reaches beyond its buffer", index));
    }
    view.bytes = std::span(buffer).subspan(start + offset, length - offset);
    return view;
  }

  void ReadPrimitive(const Json& primitive, const Affine& matrix, AssetObject& object) {
    const std::size_t mode = Index(primitive, "mode").value_or(4);
    if (mode < 4) return;  // points and lines have no surface
    const Json* const attributes = primitive.Find("attributes");
    const std::optional<std::size_t> positions =
        attributes != nullptr ? Index(*attributes, "POSITION") : std::nullopt;
    if (!positions) return;
    const View view = ReadAccessor(*positions, "VEC3", 3);
    if (view.kind != 5126) builder_.Fail("has positions that are not floats");
    const std::size_t first = object.vertices.size();
    for (std::size_t i = 0; i < view.count; ++i) {
      const auto value = [&](std::size_t axis) {
        return static_cast<double>(std::bit_cast<float>(
            static_cast<std::uint32_t>(Little(view.bytes, i * view.stride + 4 * axis, 4))));
      };
      builder_.AddVertex(Upright(matrix({value(0), value(1), value(2)})), object);
    }
    std::vector<std::size_t> corners;
    if (const std::optional<std::size_t> indices = Index(primitive, "indices")) {
      const View list = ReadAccessor(*indices, "SCALAR", 1);
      if (list.kind == 5126) builder_.Fail("has indexes that are no whole numbers");
      const std::size_t size = list.kind == 5121 ? 1 : list.kind == 5123 ? 2 : 4;
      for (std::size_t i = 0; i < list.count; ++i) {
        corners.push_back(static_cast<std::size_t>(Little(list.bytes, i * list.stride, size)));
      }
    } else {
      for (std::size_t i = 0; i < view.count; ++i) corners.push_back(i);
    }
    for (const std::size_t corner : corners) {
      if (corner >= view.count) {
        builder_.Fail(fmt::format("a triangle of '{}' has vertex {}, and there are {}", object.name,
                                  corner, view.count));
      }
    }
    const std::optional<std::size_t> material = Index(primitive, "material");
    const int chosen =
        material && *material < scene_.materials.size() ? static_cast<int>(*material) : -1;
    const bool mirrored = matrix.Determinant() < 0.0;
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
      if (mirrored) std::swap(b, c);
      builder_.AddFace({static_cast<int>(first + corners[a]), static_cast<int>(first + corners[b]),
                        static_cast<int>(first + corners[c])},
                       chosen, object);
    };
    if (mode == 4) {
      for (std::size_t i = 0; i + 2 < corners.size(); i += 3) add(i, i + 1, i + 2);
    } else if (mode == 5) {
      for (std::size_t i = 0; i + 2 < corners.size(); ++i) {
        i % 2 == 0 ? add(i, i + 1, i + 2) : add(i + 1, i, i + 2);
      }
    } else {
      for (std::size_t i = 1; i + 1 < corners.size(); ++i) add(0, i, i + 1);
    }
  }

  const std::string& name_;
  const FindFile& find_;
  const AssetLimits& limits_;
  AssetScene scene_;
  ShapeBuilder builder_;
  Json root_;
  Bytes binary_;
  std::unordered_map<std::size_t, Bytes> buffers_;
};

}  // namespace

AssetScene ReadGltf(const Bytes& bytes, const std::string& name, const FindFile& find,
                    const AssetLimits& limits) {
  return GltfReader(name, find, limits).Read(bytes);
}

}  // namespace ccmorse::assets
