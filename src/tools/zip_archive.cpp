#include "tools/zip_archive.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zip.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <map>
#include <memory>
#include <string_view>
#include <system_error>

#include "base/error.h"
#include "scene/field.h"

namespace ccmorse::tools {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kSmall = std::uint64_t{16} << 20;  // bytes, too few to be a bomb
constexpr std::size_t kDeepest = 64;
constexpr std::size_t kLongestName = 255;  // of a folder or file, as Linux has it
constexpr zip_uint32_t kModeShift = 16;    // a Unix mode stands in the upper half of the attributes

struct ZipDiscard {
  void operator()(zip_t* archive) const { ::zip_discard(archive); }
};
using Zip = std::unique_ptr<zip_t, ZipDiscard>;

struct EntryClose {
  void operator()(zip_file_t* file) const { ::zip_fclose(file); }
};
using ZipEntry = std::unique_ptr<zip_file_t, EntryClose>;

Zip Open(const fs::path& file, int flags) {
  int code = 0;
  zip_t* const archive = ::zip_open(file.c_str(), flags, &code);
  if (archive != nullptr) return Zip(archive);
  zip_error_t error;
  ::zip_error_init_with_code(&error, code);
  const std::string why = ::zip_error_strerror(&error);
  ::zip_error_fini(&error);
  throw Error(fmt::format("cannot {} {}: {}", (flags & ZIP_RDONLY) != 0 ? "read" : "write",
                          file.string(), why));
}

[[noreturn]] void Refuse(const fs::path& archive, const std::string& why) {
  throw Error(fmt::format("{} is not unpacked: {}", archive.string(), why));
}

// What is wrong with the name of an entry; "" for a good one.
std::string ProblemOfPath(std::string_view name) {
  if (name.empty()) return "has no name";
  if (name.front() == '/') return "is an absolute path";
  std::size_t depth = 0;
  for (std::size_t begin = 0; begin <= name.size(); ++depth) {
    const std::size_t end = std::min(name.find('/', begin), name.size());
    const std::string_view part = name.substr(begin, end - begin);
    if (part == "..") return "leads out of the folder";
    if (part == "." || part.empty()) return "has an empty part";
    if (part.size() > kLongestName) return "has too long a name";
    begin = end + 1;
  }
  if (depth > kDeepest) return "lies too deep";
  for (const char letter : name) {
    const auto byte = static_cast<unsigned char>(letter);
    if (letter == '\\' || byte < 0x20 || byte == 0x7f) {
      return "has a backslash or a control character";
    }
  }
  return "";
}

// Every file and folder of an archive, to find two for one place.
class Places {
 public:
  // False when there is another there.
  bool Add(const std::string& name, bool folder) {
    for (std::size_t slash = name.find('/'); slash != std::string::npos;
         slash = name.find('/', slash + 1)) {
      if (!is_folder_.emplace(name.substr(0, slash), true).first->second) return false;
    }
    const auto [at, added] = is_folder_.emplace(name, folder);
    return added || (folder && at->second);
  }

 private:
  std::map<std::string, bool> is_folder_;
};

// What systems other than ours put into archives beside the files.
bool IsClutter(std::string_view name) {
  return name.starts_with("__MACOSX/") || name == "__MACOSX" || name.ends_with(".DS_Store");
}

std::string TopFolder(const std::vector<ZipContents::Entry>& entries) {
  std::string top;
  for (const ZipContents::Entry& entry : entries) {
    const std::size_t slash = entry.name.find('/');
    if (slash == std::string::npos && !entry.folder) return "";
    const std::string first = entry.name.substr(0, slash);
    if (!top.empty() && first != top) return "";
    top = first;
  }
  return top;
}

void WriteEntry(zip_t* zip, const ZipContents::Entry& entry, const fs::path& archive,
                const fs::path& place) {
  const ZipEntry in(::zip_fopen_index(zip, entry.index, 0));
  if (!in) {
    Refuse(archive, fmt::format("{}: {}", scene::Quoted(entry.name),
                                ::zip_error_strerror(::zip_get_error(zip))));
  }
  // Not through a link: nothing else writes here, and if it does, so much the worse for it.
  const int out = ::open(place.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC,
                         entry.executable ? 0777 : 0666);
  if (out < 0) {
    throw Error(fmt::format("cannot write {}: {}", place.string(), std::strerror(errno)));
  }
  const std::unique_ptr<const int, void (*)(const int*)> closer(
      &out, [](const int* file) { ::close(*file); });
  std::array<char, 65536> block;
  std::uint64_t written = 0;
  for (;;) {
    const zip_int64_t size = ::zip_fread(in.get(), block.data(), block.size());
    if (size < 0) {
      Refuse(archive, fmt::format("{} is broken: {}", scene::Quoted(entry.name),
                                  ::zip_error_strerror(::zip_file_get_error(in.get()))));
    }
    if (size == 0) break;
    written += static_cast<std::uint64_t>(size);
    if (written > entry.bytes) {
      Refuse(archive, scene::Quoted(entry.name) + " is larger than the archive says");
    }
    std::string_view rest(block.data(), static_cast<std::size_t>(size));
    while (!rest.empty()) {
      const ssize_t done = ::write(out, rest.data(), rest.size());
      if (done < 0 && errno == EINTR) continue;
      if (done <= 0) {
        throw Error(fmt::format("cannot write {}: {}", place.string(), std::strerror(errno)));
      }
      rest.remove_prefix(static_cast<std::size_t>(done));
    }
  }
  if (written != entry.bytes) {
    Refuse(archive, scene::Quoted(entry.name) + " is shorter than the archive says");
  }
}

}  // namespace

void WriteZip(const fs::path& archive, const std::vector<ZipSource>& files) {
  Zip zip = Open(archive, ZIP_CREATE | ZIP_TRUNCATE);
  const auto fail = [&](const std::string& what) {
    throw Error(fmt::format("cannot put {} into {}: {}", what, archive.string(),
                            ::zip_error_strerror(::zip_get_error(zip.get()))));
  };
  for (const ZipSource& file : files) {
    // -1: up to its end.
    zip_source_t* const source = ::zip_source_file(zip.get(), file.file.c_str(), 0, -1);
    if (source == nullptr) fail(file.file.string());
    const zip_int64_t index =
        ::zip_file_add(zip.get(), file.name.c_str(), source, ZIP_FL_ENC_UTF_8);
    if (index < 0) {
      ::zip_source_free(source);
      fail(file.file.string());
    }
    const zip_uint32_t mode = S_IFREG | (file.executable ? 0755U : 0644U);
    ::zip_file_set_external_attributes(zip.get(), static_cast<zip_uint64_t>(index), 0,
                                       ZIP_OPSYS_UNIX, mode << kModeShift);
  }
  // Only now is anything read and written.
  if (::zip_close(zip.get()) != 0) fail("the files");
  (void)zip.release();  // closed
}

ZipContents ReadZip(const fs::path& archive, const ZipLimits& limits) {
  const Zip zip = Open(archive, ZIP_RDONLY);
  const zip_int64_t count = ::zip_get_num_entries(zip.get(), 0);
  if (count < 0 || static_cast<std::uint64_t>(count) > limits.files) {
    Refuse(archive, fmt::format("it has {} files, where {} are the limit", count, limits.files));
  }
  ZipContents contents;
  Places places;
  std::uint64_t bytes = 0;
  for (zip_uint64_t i = 0; i < static_cast<zip_uint64_t>(count); ++i) {
    zip_stat_t stat;
    if (::zip_stat_index(zip.get(), i, ZIP_FL_ENC_GUESS, &stat) != 0 ||
        (stat.valid & (ZIP_STAT_NAME | ZIP_STAT_SIZE)) != (ZIP_STAT_NAME | ZIP_STAT_SIZE)) {
      Refuse(archive, "an entry has no name or no size");
    }
    ZipContents::Entry entry;
    entry.index = i;
    entry.name = stat.name;
    entry.bytes = stat.size;
    if (entry.name.ends_with('/')) {
      entry.folder = true;
      entry.name.pop_back();
    }
    const std::string quoted = scene::Quoted(entry.name);
    if (const std::string problem = ProblemOfPath(entry.name); !problem.empty()) {
      Refuse(archive, quoted + " " + problem);
    }
    zip_uint8_t system = 0;
    zip_uint32_t attributes = 0;
    ::zip_file_get_external_attributes(zip.get(), i, 0, &system, &attributes);
    if (system == ZIP_OPSYS_UNIX || system == ZIP_OPSYS_OS_X) {
      const mode_t mode = attributes >> kModeShift;
      const mode_t type = mode & S_IFMT;
      if (type == S_IFLNK) Refuse(archive, quoted + " is a link");
      const bool plain = type == 0 || type == (entry.folder ? S_IFDIR : S_IFREG);
      if (!plain) Refuse(archive, quoted + " is neither a file nor a folder");
      entry.executable = (mode & S_IXUSR) != 0;
    }
    if ((stat.valid & ZIP_STAT_ENCRYPTION_METHOD) != 0 && stat.encryption_method != ZIP_EM_NONE) {
      Refuse(archive, quoted + " is encrypted");
    }
    if (!places.Add(entry.name, entry.folder)) {
      Refuse(archive, "it has " + quoted + " twice, or as a file and a folder");
    }
    if (entry.bytes > limits.bytes || (bytes += entry.bytes) > limits.bytes) {
      Refuse(archive, fmt::format("it would fill more than {} MiB unpacked", limits.bytes >> 20));
    }
    if (!IsClutter(entry.name)) contents.entries.push_back(std::move(entry));
  }
  std::error_code failed;
  const std::uint64_t packed = fs::file_size(archive, failed);
  if (!failed && bytes > kSmall && bytes / limits.ratio > packed) {
    Refuse(archive, fmt::format("{} MiB out of {} KiB is no project", bytes >> 20, packed >> 10));
  }
  if (contents.entries.empty()) Refuse(archive, "it is empty");
  contents.top = TopFolder(contents.entries);
  return contents;
}

void Unzip(const fs::path& archive, const ZipContents& contents, const fs::path& folder) {
  const Zip zip = Open(archive, ZIP_RDONLY);
  for (const ZipContents::Entry& entry : contents.entries) {
    std::string name = entry.name;
    if (!contents.top.empty()) {
      if (name == contents.top) continue;
      name.erase(0, contents.top.size() + 1);
    }
    const fs::path place = folder / name;
    std::error_code failed;
    fs::create_directories(entry.folder ? place : place.parent_path(), failed);
    if (failed) {
      throw Error(
          fmt::format("cannot make the folder for {}: {}", place.string(), failed.message()));
    }
    if (!entry.folder) WriteEntry(zip.get(), entry, archive, place);
  }
}

}  // namespace ccmorse::tools
