#include "assets/load.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "assets/cache.h"
#include "assets/picture.h"
#include "assets/readers.h"
#include "base/error.h"

namespace ccmorse::assets {
namespace {

namespace fs = std::filesystem;

std::string EndingOf(const std::string& name) {
  std::string ending = fs::path(name).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](char c) {
    return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  });
  return ending;
}

Bytes ReadBytes(const std::string& path, std::size_t limit) {
  std::error_code error;
  const std::uintmax_t size = fs::file_size(path, error);
  if (error) throw Error(fmt::format("cannot read {}: {}", path, error.message()));
  if (size > limit) {
    throw Error(fmt::format("{}: has {} bytes, and {} can be read", path, size, limit));
  }
  std::ifstream file(path, std::ios::binary);
  Bytes bytes(static_cast<std::size_t>(size));
  if (!file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size))) {
    throw Error(fmt::format("cannot read {}: {}", path, std::strerror(errno)));
  }
  return bytes;
}

AssetScene Read(const std::string& path, const FindFile& find, const AssetLimits& limits) {
  const std::string ending = EndingOf(path);
  Bytes bytes = ReadBytes(path, limits.bytes);
  if (ending == ".blend") return ReadBlend(std::move(bytes), path, limits, find);
  if (ending == ".gltf" || ending == ".glb") return ReadGltf(bytes, path, find, limits);
  if (ending == ".stl") return ReadStl(bytes, path, limits);
  if (ending == ".dae") return ReadCollada(bytes, path, limits);
  if (ending == ".obj") {
    return ReadObj({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, path, find, limits);
  }
  throw Error(fmt::format("{}: is none of .blend, .gltf, .glb, .obj, .stl and .dae", path));
}

// What pictures beside the file make of its materials' colours.
void MixPictures(const FindFile& find, AssetScene& scene) {
  for (AssetMaterial& material : scene.materials) {
    if (material.image < 0) continue;
    const std::string& name = scene.images[static_cast<std::size_t>(material.image)].path;
    if (name.empty()) continue;
    try {
      if (const std::optional<Picture> picture = ReadPicture(find(name))) {
        material.pictured = picture->mean;
      }
    } catch (const Error&) {
      scene.notes.push_back(fmt::format("the picture '{}' is not there", name));
    }
  }
}

}  // namespace

bool IsAssetName(const std::string& name) {
  const std::string ending = EndingOf(name);
  return ending == ".blend" || ending == ".gltf" || ending == ".glb" || ending == ".obj" ||
         ending == ".stl" || ending == ".dae";
}

std::string FindAsset(const std::string& name, const std::string& folder) {
  if (name.find('\0') != std::string::npos) throw Error("a file's name cannot have a zero byte");
  if (fs::path(name).is_absolute()) return name;
  std::vector<fs::path> folders = {folder.empty() ? "." : folder};
  if (const char* const list = std::getenv("MORSE_RESOURCE_PATH"); list != nullptr) {
    const std::string text = list;
    for (std::size_t at = 0; at <= text.size();) {
      const std::size_t colon = std::min(text.find(':', at), text.size());
      if (colon > at) folders.emplace_back(text.substr(at, colon - at));
      at = colon + 1;
    }
  }
  folders.emplace_back("/usr/share/morse/data");
  std::string looked;
  for (const fs::path& each : folders) {
    std::error_code error;
    const fs::path path = each / name;
    if (fs::is_regular_file(path, error))
      return folder.empty() && each == "." ? name : path.string();
    looked += (looked.empty() ? "" : ", ") + each.string();
  }
  throw Error(fmt::format("there is no file '{}'; looked in {}", name, looked));
}

AssetScene LoadAsset(const std::string& path, const AssetLimits& limits, LoadReport* report) {
  const auto start = std::chrono::steady_clock::now();
  const auto finish = [&](bool from_cache) {
    if (report == nullptr) return;
    report->from_cache = from_cache;
    report->seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  const std::string cache = CacheFile(path);
  if (!cache.empty()) {
    if (std::optional<AssetScene> kept = ReadCache(cache, path)) {
      finish(true);
      return std::move(*kept);
    }
  }
  // States are taken before reading: a file that changes meanwhile is read again next time.
  std::vector<FileState> files;
  const auto note = [&files](const std::string& file) {
    if (const std::optional<FileState> state = StateOf(file)) files.push_back(*state);
  };
  note(path);
  const fs::path folder = fs::path(path).parent_path();
  const auto find = [&](const std::string& name) {
    const std::string file = (folder / name).string();
    note(file);
    return ReadBytes(file, limits.bytes);
  };
  AssetScene scene = Read(path, find, limits);
  if (EndingOf(path) != ".blend") MixPictures(find, scene);
  for (std::string& text : scene.notes) text = OneLine(std::move(text));
  // A file that was looked for in vain is not noted: such a scene is not kept.
  const bool whole = std::none_of(scene.notes.begin(), scene.notes.end(), [](const auto& text) {
    return text.find("cannot read") != std::string::npos;
  });
  if (!cache.empty() && whole && !files.empty()) WriteCache(cache, files, scene);
  finish(false);
  return scene;
}

}  // namespace ccmorse::assets
