// STL as 3D Systems published it ("StereoLithography Interface Specification", 1988): binary, a
// head of 80 bytes, a count and 50 bytes a triangle; or text, "facet normal ... vertex x y z ...".

#include <fmt/format.h>

#include <bit>
#include <charconv>
#include <map>
#include <string_view>
#include <tuple>

#include "assets/readers.h"
#include "assets/shape_builder.h"

namespace ccmorse::assets {
namespace {

constexpr std::size_t kHead = 84;
constexpr std::size_t kTriangle = 50;

std::uint32_t Number(const Bytes& bytes, std::size_t at) {
  return static_cast<std::uint32_t>(bytes[at]) | static_cast<std::uint32_t>(bytes[at + 1]) << 8U |
         static_cast<std::uint32_t>(bytes[at + 2]) << 16U |
         static_cast<std::uint32_t>(bytes[at + 3]) << 24U;
}

// Corners that lie in one place become one vertex.
class Corners {
 public:
  Corners(ShapeBuilder& builder, AssetObject& object) : builder_(builder), object_(object) {}

  void Add(const Vec3& corner) {
    const auto [found, is_new] = vertices_.try_emplace({corner.x, corner.y, corner.z},
                                                       static_cast<int>(object_.vertices.size()));
    if (is_new) builder_.AddVertex(corner, object_);
    face_.push_back(found->second);
    if (face_.size() < 3) return;
    builder_.AddFace(face_, -1, object_);
    face_.clear();
  }

 private:
  ShapeBuilder& builder_;
  AssetObject& object_;
  std::map<std::tuple<double, double, double>, int> vertices_;
  std::vector<int> face_;
};

// The next word of a text; empty at its end.
std::string_view Word(std::string_view& text) {
  const std::size_t from = std::min(text.find_first_not_of(" \t\r\n\f\v"), text.size());
  const std::size_t to = std::min(text.find_first_of(" \t\r\n\f\v", from), text.size());
  const std::string_view word = text.substr(from, to - from);
  text.remove_prefix(to);
  return word;
}

}  // namespace

AssetScene ReadStl(const Bytes& bytes, const std::string& name, const AssetLimits& limits) {
  AssetScene scene;
  scene.format = "STL";
  ShapeBuilder builder(scene, name, limits);
  AssetObject& object = builder.AddObject("stl", {});
  Corners corners(builder, object);
  // Some binary files begin with "solid", too: the count settles it.
  const bool binary = bytes.size() >= kHead &&
                      (bytes.size() - kHead) / kTriangle >= Number(bytes, 80) &&
                      (bytes.size() - kHead == Number(bytes, 80) * kTriangle || bytes[0] != 's');
  if (binary) {
    for (std::size_t i = 0; i < Number(bytes, 80); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t at = kHead + i * kTriangle + 12 + 12 * k;
        const auto value = [&](std::size_t axis) {
          return static_cast<double>(std::bit_cast<float>(Number(bytes, at + 4 * axis)));
        };
        corners.Add({value(0), value(1), value(2)});
      }
    }
    return scene;
  }
  std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const std::size_t size = text.size();
  if (Word(text) != "solid") {
    builder.Fail(
        "is no STL: neither does it begin with 'solid', nor has it as many bytes as its "
        "count of triangles asks for");
  }
  std::size_t read = 0;
  for (std::string_view word = Word(text); !word.empty(); word = Word(text)) {
    if (word != "vertex") continue;
    Vec3 corner;
    for (double* const to : {&corner.x, &corner.y, &corner.z}) {
      word = Word(text);
      const char* first = word.data();
      if (!word.empty() && word[0] == '+') ++first;
      const auto result = std::from_chars(first, word.data() + word.size(), *to);
      if (result.ec != std::errc() || result.ptr != word.data() + word.size()) {
        builder.Fail(
            fmt::format("offset {}: a vertex must have three numbers", size - text.size()));
      }
    }
    corners.Add(corner);
    ++read;
  }
  if (read % 3 != 0) builder.Fail("is cut short within a facet");
  return scene;
}

}  // namespace ccmorse::assets
