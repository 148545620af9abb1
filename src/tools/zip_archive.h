#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace ccmorse::tools {

/// A file for an archive.
struct ZipSource {
  std::string name;            ///< in the archive, with '/' between folders
  std::filesystem::path file;  ///< what it holds
  bool executable = false;
};

/// Writes an archive, whole or not at all; one that is there is replaced. Throws Error.
void WriteZip(const std::filesystem::path& archive, const std::vector<ZipSource>& files);

/// What an archive may hold at most: projects are small, and what comes from others may be a bomb.
struct ZipLimits {
  std::uint64_t files = 20'000;
  std::uint64_t bytes = std::uint64_t{1} << 29;  ///< unpacked: 512 MiB
  /// Unpacked over packed size of all of it, once it is larger than 16 MiB.
  std::uint64_t ratio = 200;
};

/// Files and folders that an archive holds, checked.
struct ZipContents {
  struct Entry {
    std::uint64_t index = 0;  ///< in the archive
    std::string name;         ///< relative, without "." and ".."; no '/' at its end
    bool folder = false;
    bool executable = false;
    std::uint64_t bytes = 0;  ///< as the archive says; more is refused when it is unpacked
  };
  std::vector<Entry> entries;
  std::string top;  ///< the one folder that all of it lies in, or ""
};

/// Reads what is in an archive. Throws Error for what is no archive, and for one that could harm:
/// a name that leads out of the folder (absolute, with "..", a backslash or a control character),
/// a link or device, two entries for one place, an encrypted entry, and what is beyond the limits.
ZipContents ReadZip(const std::filesystem::path& archive, const ZipLimits& limits = {});

/// Unpacks what ReadZip() has let pass into `folder`, which is empty, without the top folder. No
/// more bytes are written than the entries say. Throws Error; what was written stays.
void Unzip(const std::filesystem::path& archive, const ZipContents& contents,
           const std::filesystem::path& folder);

}  // namespace ccmorse::tools
