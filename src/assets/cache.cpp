#include "assets/cache.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <type_traits>

namespace ccmorse::assets {
namespace {

namespace fs = std::filesystem;

// Counts up whenever a reader reads something else than before, or the form below changes.
constexpr std::uint32_t kVersion = 2;
constexpr std::uint32_t kCacheMagic = 0x41434343;  // "CCCA" on a little-endian machine

// The form is the machine's own: a cache is not for carrying about. Reading and writing go through
// the same Visit(), so that they cannot disagree.
struct Writer {
  static constexpr bool kReads = false;
  std::string out;
  void Raw(const void* from, std::size_t bytes) {
    out.append(static_cast<const char*>(from), bytes);
  }
};

struct Reader {
  static constexpr bool kReads = true;
  const char* at;
  const char* end;
  bool good = true;
  void Raw(void* to, std::size_t bytes) {
    if (static_cast<std::size_t>(end - at) < bytes) {
      good = false;
      return;
    }
    if (bytes == 0) return;  // into an empty vector: there is no place to copy to
    std::memcpy(to, at, bytes);
    at += bytes;
  }
};

template <typename Archive, typename T>
requires std::is_trivially_copyable_v<T>
void Visit(Archive& archive, T& value) { archive.Raw(&value, sizeof value); }

template <typename Archive>
void Visit(Archive& archive, std::string& text) {
  auto size = static_cast<std::uint64_t>(text.size());
  Visit(archive, size);
  if constexpr (Archive::kReads) {
    if (!archive.good || size > static_cast<std::uint64_t>(archive.end - archive.at)) {
      archive.good = false;
      return;
    }
    text.resize(static_cast<std::size_t>(size));
  }
  archive.Raw(text.data(), text.size());
}

template <typename Archive>
void Visit(Archive& archive, AssetImage& image);
template <typename Archive>
void Visit(Archive& archive, AssetMaterial& material);
template <typename Archive>
void Visit(Archive& archive, AssetProperty& property);
template <typename Archive>
void Visit(Archive& archive, AssetPhysics& physics);
template <typename Archive>
void Visit(Archive& archive, AssetLight& light);
template <typename Archive>
void Visit(Archive& archive, AssetObject& object);
template <typename Archive>
void Visit(Archive& archive, FileState& file);

template <typename Archive, typename T>
void Visit(Archive& archive, std::vector<T>& list) {
  auto size = static_cast<std::uint64_t>(list.size());
  Visit(archive, size);
  // Everything takes a byte at least, so no more than those that are left.
  constexpr std::size_t kLeast = std::is_trivially_copyable_v<T> ? sizeof(T) : 1;
  if constexpr (Archive::kReads) {
    if (!archive.good || size > static_cast<std::uint64_t>(archive.end - archive.at) / kLeast) {
      archive.good = false;
      return;
    }
    list.resize(static_cast<std::size_t>(size));
  }
  if constexpr (std::is_trivially_copyable_v<T>) {
    archive.Raw(list.data(), list.size() * sizeof(T));
  } else {
    for (T& item : list) Visit(archive, item);
  }
}

template <typename Archive, typename T>
void Visit(Archive& archive,
           std::optional<T>& value) requires(!std::is_trivially_copyable_v<std::optional<T>>) {
  bool there = value.has_value();
  Visit(archive, there);
  if (!there) return;
  if constexpr (Archive::kReads) value.emplace();
  Visit(archive, *value);
}

template <typename Archive>
void Visit(Archive& archive, AssetImage& image) {
  Visit(archive, image.name);
  Visit(archive, image.path);
  Visit(archive, image.packed_size);
}

template <typename Archive>
void Visit(Archive& archive, AssetMaterial& material) {
  Visit(archive, material.name);
  Visit(archive, material.color);
  Visit(archive, material.specular);
  Visit(archive, material.alpha);
  Visit(archive, material.friction);
  Visit(archive, material.restitution);
  Visit(archive, material.image);
  Visit(archive, material.pictured);
}

template <typename Archive>
void Visit(Archive& archive, AssetProperty& property) {
  Visit(archive, property.name);
  std::string text;
  if constexpr (!Archive::kReads) text = property.value.Dump();
  Visit(archive, text);
  if constexpr (Archive::kReads) {
    try {
      property.value = Json::Parse(text);
    } catch (const JsonError&) {
      archive.good = false;
    }
  }
}

template <typename Archive>
void Visit(Archive& archive, AssetPhysics& physics) {
  Visit(archive, physics.type);
  Visit(archive, physics.actor);
  Visit(archive, physics.ghost);
  Visit(archive, physics.mass);
  Visit(archive, physics.radius);
  Visit(archive, physics.linear_damping);
  Visit(archive, physics.angular_damping);
  Visit(archive, physics.margin);
  Visit(archive, physics.form_factor);
  Visit(archive, physics.lock_move);
  Visit(archive, physics.lock_rotate);
  Visit(archive, physics.bounds);
  Visit(archive, physics.compound);
}

template <typename Archive>
void Visit(Archive& archive, AssetLight& light) {
  Visit(archive, light.kind);
  Visit(archive, light.color);
  Visit(archive, light.energy);
  Visit(archive, light.distance);
  Visit(archive, light.spot_angle);
}

template <typename Archive>
void Visit(Archive& archive, AssetObject& object) {
  Visit(archive, object.name);
  Visit(archive, object.type);
  Visit(archive, object.parent);
  Visit(archive, object.matrix);
  Visit(archive, object.layers);
  Visit(archive, object.shown);
  Visit(archive, object.hidden);
  Visit(archive, object.instance);
  Visit(archive, object.vertices);
  Visit(archive, object.triangles);
  Visit(archive, object.material_of);
  Visit(archive, object.color_of);
  Visit(archive, object.faces);
  Visit(archive, object.physics);
  Visit(archive, object.properties);
  Visit(archive, object.light);
  Visit(archive, object.camera);
}

template <typename Archive>
void Visit(Archive& archive, FileState& file) {
  Visit(archive, file.path);
  Visit(archive, file.size);
  Visit(archive, file.modified);
}

template <typename Archive>
void Visit(Archive& archive, AssetScene& scene) {
  Visit(archive, scene.format);
  Visit(archive, scene.gravity);
  Visit(archive, scene.objects);
  Visit(archive, scene.materials);
  Visit(archive, scene.images);
  Visit(archive, scene.camera);
  Visit(archive, scene.notes);
}

std::uint32_t Checksum(const char* from, std::size_t bytes) {
  return static_cast<std::uint32_t>(crc32_z(0, reinterpret_cast<const Bytef*>(from), bytes));
}

// What a cache begins with, so that nothing else is taken for one.
struct Head {
  std::uint32_t magic = kCacheMagic;
  std::uint32_t version = kVersion;
  std::uint64_t size = 0;  // bytes behind it
  std::uint32_t checksum = 0;
  std::uint32_t spare = 0;
};

}  // namespace

std::optional<FileState> StateOf(const std::string& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
  return FileState{path, static_cast<std::uint64_t>(status.st_size),
                   std::int64_t{status.st_mtim.tv_sec} * 1'000'000'000 + status.st_mtim.tv_nsec};
}

std::string CacheFile(const std::string& path) {
  const char* const choice = std::getenv("CCMORSE_CACHE");
  if (choice != nullptr && std::string(choice) == "off") return "";
  fs::path folder;
  const char* const caches = std::getenv("XDG_CACHE_HOME");
  const char* const home = std::getenv("HOME");
  if (caches != nullptr && fs::path(caches).is_absolute()) {
    folder = caches;  // a relative one is to be ignored (XDG Base Directory Specification)
  } else if (home != nullptr && *home != '\0') {
    folder = fs::path(home) / ".cache";
  } else {
    return "";
  }
  std::error_code error;
  const fs::path whole = fs::weakly_canonical(path, error);
  if (error) return "";
  std::uint64_t hash = 0xcbf29ce484222325U;  // FNV-1a; the path itself stands in the cache
  for (const char c : whole.string()) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  }
  return (folder / "ccmorse" / fmt::format("{:016x}.asset", hash)).string();
}

std::optional<AssetScene> ReadCache(const std::string& cache, const std::string& path) {
  std::ifstream file(cache, std::ios::binary | std::ios::ate);
  if (!file) return std::nullopt;
  const auto size = static_cast<std::size_t>(std::max<std::streamoff>(0, file.tellg()));
  Head head;
  if (size < sizeof head) return std::nullopt;
  std::vector<char> bytes(size - sizeof head);
  file.seekg(0);
  if (!file.read(reinterpret_cast<char*>(&head), sizeof head) || head.magic != kCacheMagic ||
      head.version != kVersion || head.size != bytes.size() ||
      !file.read(bytes.data(), static_cast<std::streamsize>(bytes.size())) ||
      head.checksum != Checksum(bytes.data(), bytes.size())) {
    return std::nullopt;
  }
  Reader reader{bytes.data(), bytes.data() + bytes.size()};
  std::vector<FileState> files;
  Visit(reader, files);
  if (!reader.good || files.empty() || files[0].path != path) return std::nullopt;
  for (const FileState& state : files) {
    if (StateOf(state.path) != state) return std::nullopt;
  }
  AssetScene scene;
  Visit(reader, scene);
  if (!reader.good || reader.at != reader.end) return std::nullopt;
  return scene;
}

bool WriteCache(const std::string& cache, const std::vector<FileState>& files,
                const AssetScene& scene) {
  std::error_code error;
  fs::create_directories(fs::path(cache).parent_path(), error);
  Writer writer;
  // Visit() serves both ways, so it takes what it only reads here by reference.
  std::vector<FileState> states = files;
  Visit(writer, states);
  Visit(writer, const_cast<AssetScene&>(scene));  // NOLINT(cppcoreguidelines-pro-type-const-cast)
  Head head;
  head.size = writer.out.size();
  head.checksum = Checksum(writer.out.data(), writer.out.size());
  const std::string temporary = fmt::format("{}.{}", cache, ::getpid());
  {
    std::ofstream file(temporary, std::ios::binary);
    file.write(reinterpret_cast<const char*>(&head), sizeof head);
    file.write(writer.out.data(), static_cast<std::streamsize>(writer.out.size()));
    if (!file.flush()) {
      fs::remove(temporary, error);
      return false;
    }
  }
  fs::rename(temporary, cache, error);
  if (error) {
    std::error_code ignored;
    fs::remove(temporary, ignored);
    return false;
  }
  return true;
}

}  // namespace ccmorse::assets
