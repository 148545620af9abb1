#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "assets/asset_scene.h"

namespace ccmorse::assets {

/// A file as it was when it was read.
struct FileState {
  std::string path;
  std::uint64_t size = 0;     ///< bytes
  std::int64_t modified = 0;  ///< ns, of whatever clock the file system has
  bool operator==(const FileState&) const = default;
};

/// The file as it is; nothing where there is none.
std::optional<FileState> StateOf(const std::string& path);

/// The file that keeps what was read of `path`; "" where there is no place for caches, or they are
/// turned off.
std::string CacheFile(const std::string& path);

/// What was kept in `cache`, when it is whole, of this version of the readers, and all files that
/// it was read from are as they were; the first of them must be `path`.
std::optional<AssetScene> ReadCache(const std::string& cache, const std::string& path);

/// Keeps a scene that was read from `files`. The cache appears whole or not at all; that it cannot
/// be written is no error: false.
bool WriteCache(const std::string& cache, const std::vector<FileState>& files,
                const AssetScene& scene);

}  // namespace ccmorse::assets
