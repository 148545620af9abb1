// Wavefront OBJ and MTL (Wavefront, "Object Files", version 3.0): v, f, o, g, usemtl, mtllib; of
// materials newmtl, Kd, d, Tr, map_Kd.

#include <fmt/format.h>

#include <charconv>
#include <string_view>
#include <unordered_map>

#include "assets/readers.h"
#include "assets/shape_builder.h"
#include "base/error.h"

namespace ccmorse::assets {
namespace {

std::string_view Trimmed(std::string_view text) {
  const std::size_t from = text.find_first_not_of(" \t\r");
  if (from == std::string_view::npos) return {};
  return text.substr(from, text.find_last_not_of(" \t\r") - from + 1);
}

// Takes the first word off a line.
std::string_view TakeWord(std::string_view& line) {
  line = Trimmed(line);
  const std::size_t to = std::min(line.find_first_of(" \t"), line.size());
  const std::string_view word = line.substr(0, to);
  line.remove_prefix(to);
  return word;
}

template <typename T>
bool ToNumber(std::string_view word, T& value) {
  if (!word.empty() && word[0] == '+') word.remove_prefix(1);
  const auto result = std::from_chars(word.data(), word.data() + word.size(), value);
  return result.ec == std::errc() && result.ptr == word.data() + word.size();
}

// Calls use(words, number) for each line that says something, joined where one ends with '\'.
template <typename Use>
void EachLine(std::string_view text, const Use& use) {
  std::string joined;
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = Trimmed(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.ends_with('\\')) {
      joined.append(line.substr(0, line.size() - 1)).push_back(' ');
      continue;
    }
    if (!joined.empty()) {
      joined.append(line);
      line = joined;
    }
    if (!line.empty() && line[0] != '#') use(line, number);
    joined.clear();
  }
}

class ObjReader {
 public:
  ObjReader(const std::string& name, const FindFile& find, const AssetLimits& limits)
      : name_(name), find_(find), limits_(limits), builder_(scene_, name_, limits_) {}

  AssetScene Read(std::string_view text) {
    scene_.format = "Wavefront OBJ";
    EachLine(text, [&](std::string_view line, int number) {
      line_ = number;
      const std::string_view word = TakeWord(line);
      if (word == "v") {
        ReadVertex(line);
      } else if (word == "f") {
        ReadFace(line);
      } else if (word == "o" || word == "g") {
        object_ = -1;
        next_name_ = std::string(Trimmed(line));
      } else if (word == "usemtl") {
        const auto found = material_at_.find(std::string(Trimmed(line)));
        material_ = found != material_at_.end() ? found->second : -1;
      } else if (word == "mtllib") {
        ReadMaterials(std::string(Trimmed(line)));
      }
    });
    return std::move(scene_);
  }

 private:
  [[noreturn]] void Fail(const std::string& text) const {
    throw Error(fmt::format("{}:{}: {}", name_, line_, text));
  }

  void ReadVertex(std::string_view line) {
    Vec3 vertex;
    for (double* const to : {&vertex.x, &vertex.y, &vertex.z}) {
      if (!ToNumber(TakeWord(line), *to)) Fail("'v' must be followed by three numbers");
    }
    vertices_.push_back(vertex);
    if (vertices_.size() / 3 > limits_.triangles) Fail("there are too many vertices");
  }

  void ReadFace(std::string_view line) {
    if (object_ < 0) {
      builder_.AddObject(next_name_.empty() ? "obj" : next_name_, {});
      object_ = static_cast<int>(scene_.objects.size()) - 1;
      vertex_of_.clear();
    }
    AssetObject& object = scene_.objects[static_cast<std::size_t>(object_)];
    std::vector<int> face;
    for (std::string_view word = TakeWord(line); !word.empty(); word = TakeWord(line)) {
      long index = 0;
      if (!ToNumber(word.substr(0, word.find('/')), index)) Fail("a face's corner is no number");
      const auto count = static_cast<long>(vertices_.size());
      const long at = index > 0 ? index - 1 : count + index;  // from 1, or from the last
      if (index == 0 || index > count || at < 0) {
        Fail(fmt::format("a face has vertex {}, and there are {}", index, count));
      }
      const auto [found, is_new] =
          vertex_of_.try_emplace(at, static_cast<int>(object.vertices.size()));
      if (is_new) builder_.AddVertex(vertices_[static_cast<std::size_t>(at)], object);
      face.push_back(found->second);
    }
    if (face.size() < 3) Fail("a face must have three corners or more");
    builder_.AddFace(face, material_, object);
  }

  void ReadMaterials(const std::string& path) {
    Bytes bytes;
    try {
      bytes = find_(path);
    } catch (const Error& error) {
      scene_.notes.emplace_back(error.what());
      return;
    }
    AssetMaterial* material = nullptr;
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    EachLine(text, [&](std::string_view line, int) {
      const std::string_view word = TakeWord(line);
      if (word == "newmtl") {
        material = &scene_.materials.emplace_back();
        material->name = std::string(Trimmed(line));
        material_at_[material->name] = static_cast<int>(scene_.materials.size()) - 1;
        return;
      }
      if (material == nullptr) return;
      double value = 0.0;
      if (word == "Kd") {
        double green = 0.0;
        double blue = 0.0;
        if (!ToNumber(TakeWord(line), value) || !ToNumber(TakeWord(line), green) ||
            !ToNumber(TakeWord(line), blue)) {
          return;
        }
        material->color = {FromShare(value), FromShare(green), FromShare(blue)};
      } else if (word == "d" && ToNumber(TakeWord(line), value)) {
        material->alpha = value >= 0.0 && value <= 1.0 ? value : 1.0;
      } else if (word == "Tr" && ToNumber(TakeWord(line), value)) {
        material->alpha = value >= 0.0 && value <= 1.0 ? 1.0 - value : 1.0;
      } else if (word == "map_Kd") {
        const std::string_view rest = Trimmed(line);
        const std::size_t space = rest.find_last_of(" \t");  // options come before the name
        const std::string_view file = rest.starts_with('-') && space != std::string_view::npos
                                          ? rest.substr(space + 1)
                                          : rest;
        material->image = static_cast<int>(scene_.images.size());
        scene_.images.push_back({std::string(file), std::string(file), 0});
      }
    });
  }

  const std::string& name_;
  const FindFile& find_;
  const AssetLimits& limits_;
  AssetScene scene_;
  ShapeBuilder builder_;
  int line_ = 0;
  std::vector<Vec3> vertices_;
  int object_ = -1;
  std::string next_name_;
  int material_ = -1;
  std::unordered_map<std::string, int> material_at_;
  std::unordered_map<long, int> vertex_of_;  // the file's to the object's
};

}  // namespace

AssetScene ReadObj(std::string_view text, const std::string& name, const FindFile& find,
                   const AssetLimits& limits) {
  return ObjReader(name, find, limits).Read(text);
}

}  // namespace ccmorse::assets
