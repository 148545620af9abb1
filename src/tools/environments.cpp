#include "tools/environments.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <pwd.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/error.h"
#include "scene/field.h"

namespace ccmorse::tools {
namespace {

namespace fs = std::filesystem;

fs::path HomeFolder() {
  if (const char* const home = std::getenv("HOME"); home != nullptr && *home != '\0') return home;
  const passwd* const user = ::getpwuid(::getuid());
  if (user != nullptr && user->pw_dir != nullptr && *user->pw_dir != '\0') return user->pw_dir;
  return {};
}

// A file that is not there is an empty one; one that cannot be read is an error.
std::string TextOf(const fs::path& file) {
  std::error_code failed;
  const fs::file_status status = fs::status(file, failed);
  if (status.type() == fs::file_type::not_found) return "";
  // HOME below a file, say: nothing can be there.
  if (failed == std::errc::not_a_directory) return "";
  if (fs::is_directory(status)) {
    throw Error(fmt::format("{} is a folder where MORSE's config file belongs; move it away",
                            file.string()));
  }
  return ReadFile(file.string());
}

void WriteAll(int file, std::string_view text, const fs::path& name) {
  while (!text.empty()) {
    const ssize_t written = ::write(file, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) {
      throw Error(fmt::format("cannot write {}: {}", name.string(), std::strerror(errno)));
    }
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

// Holds others off who would change the same files; freed by the system if we die.
class Lock {
 public:
  explicit Lock(const fs::path& file)
      : file_(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600)) {
    if (file_ < 0) {
      throw Error(
          fmt::format("cannot write in {}: {}; environments are remembered there, so give "
                      "yourself the right to write, or set HOME to another folder",
                      file.parent_path().string(), std::strerror(errno)));
    }
    while (::flock(file_, LOCK_EX) != 0 && errno == EINTR) {
    }
  }
  ~Lock() { ::close(file_); }
  Lock(const Lock&) = delete;
  Lock& operator=(const Lock&) = delete;

 private:
  int file_;
};

fs::path Expanded(const std::string& path, const fs::path& home) {
  if (path.starts_with("~/")) return home / path.substr(2);
  return path;
}

std::string PercentEncoded(std::string_view path) {
  std::string text;
  for (const char letter : path) {
    const auto byte = static_cast<unsigned char>(letter);
    const bool plain = (byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z') ||
                       (byte >= '0' && byte <= '9') ||
                       std::string_view("-_.~/").find(letter) != std::string_view::npos;
    text += plain ? std::string(1, letter) : fmt::format("%{:02X}", byte);
  }
  return text;
}

}  // namespace

void ReplaceFile(const fs::path& file, const std::string& text) {
  std::error_code failed;
  fs::path target = file;
  if (fs::is_symlink(file, failed)) {
    target = fs::weakly_canonical(file, failed);
    if (failed) target = file;
  }
  std::string temporary = target.string() + ".XXXXXX";
  const int made = ::mkostemp(temporary.data(), O_CLOEXEC);
  if (made < 0) {
    throw Error(
        fmt::format("cannot write in {}: {}", target.parent_path().string(), std::strerror(errno)));
  }
  try {
    struct stat old {};
    const bool is_there = ::stat(target.c_str(), &old) == 0;
    constexpr mode_t kPermissions = 07777;
    (void)::fchmod(made, is_there ? old.st_mode & kPermissions : 0644);
    WriteAll(made, text, temporary);
    if (::fsync(made) != 0 || ::rename(temporary.c_str(), target.c_str()) != 0) {
      throw Error(fmt::format("cannot write {}: {}", target.string(), std::strerror(errno)));
    }
    ::close(made);
  } catch (...) {
    ::close(made);
    ::unlink(temporary.c_str());
    throw;
  }
}

Environments::Environments() : Environments(HomeFolder()) {}

Environments::Environments(fs::path home)
    : home_(std::move(home)),
      config_file_(home_ / ".morse" / "config"),
      created_file_(home_ / ".morse" / "created") {}

std::vector<Environment> Environments::List() const {
  if (home_.empty()) return {};
  const SiteConfig created(TextOf(created_file_), "created");
  std::vector<Environment> environments;
  for (const SiteConfig::Site& site : SiteConfig(TextOf(config_file_)).Sites()) {
    const auto made = created.Find(site.name);
    environments.push_back({site.name, fs::absolute(Expanded(site.path, home_)).lexically_normal(),
                            made && made->path == site.path});
  }
  return environments;
}

std::optional<Environment> Environments::Find(const std::string& name) const {
  if (home_.empty()) return std::nullopt;
  const std::optional<SiteConfig::Site> site = SiteConfig(TextOf(config_file_)).Find(name);
  if (!site) return std::nullopt;
  const auto made = SiteConfig(TextOf(created_file_), "created").Find(name);
  return Environment{site->name, fs::absolute(Expanded(site->path, home_)).lexically_normal(),
                     made && made->path == site->path};
}

void Environments::Change(
    const std::function<void(SiteConfig& sites, SiteConfig& created)>& change) {
  if (home_.empty()) {
    throw Error("there is no home folder to keep the list of environments in; set HOME");
  }
  const fs::path folder = config_file_.parent_path();
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed) {
    throw Error(
        fmt::format("cannot make the folder {} for the list of environments: {}; give "
                    "yourself the right to, or set HOME to another folder",
                    folder.string(), failed.message()));
  }
  const Lock lock(folder / "lock");
  const std::string old_sites = TextOf(config_file_);
  const std::string old_created = TextOf(created_file_);
  SiteConfig sites(old_sites);
  SiteConfig created(old_created, "created");
  change(sites, created);
  // In this order, what was imported is at no time taken for what was created.
  if (created.text() != old_created) ReplaceFile(created_file_, created.text());
  if (sites.text() != old_sites) ReplaceFile(config_file_, sites.text());
}

void Environments::Set(const Environment& environment) {
  Change([&environment](SiteConfig& sites, SiteConfig& created) {
    sites.Set(environment.name, environment.folder.string());
    if (environment.created) {
      created.Set(environment.name, environment.folder.string());
    } else {
      created.Remove(environment.name);
    }
  });
}

bool Environments::Forget(const std::string& name) {
  if (!Find(name)) return false;
  bool found = false;
  Change([&](SiteConfig& sites, SiteConfig& created) {
    found = sites.Remove(name);
    created.Remove(name);
  });
  return found;
}

void RequireEnvironmentName(const std::string& name, const std::string& how) {
  const std::string problem = SiteConfig::ProblemOfName(name);
  if (problem.empty()) return;
  throw Error(
      fmt::format("{} cannot be the name of an environment: it {}; choose one of letters, "
                  "digits and '_': {}",
                  scene::Quoted(name), problem, how));
}

fs::path MoveToTrash(const fs::path& what, const fs::path& home) {
  const char* const data = std::getenv("XDG_DATA_HOME");
  const fs::path trash =
      (data != nullptr && *data == '/' ? fs::path(data) : home / ".local" / "share") / "Trash";
  std::error_code failed;
  for (const char* const folder : {"files", "info"}) {
    fs::create_directories(trash / folder, failed);
    if (failed) {
      throw Error(fmt::format("cannot make the folder {}: {}", (trash / folder).string(),
                              failed.message()));
    }
  }
  const fs::path path = fs::absolute(what).lexically_normal();
  std::string name = path.filename().string();
  const std::string base = name;
  int note = -1;
  fs::path note_file;
  constexpr int kTries = 10'000;
  for (int i = 2; i < kTries; ++i) {
    note_file = trash / "info" / (name + ".trashinfo");
    // The specification's way to claim a name.
    note = ::open(note_file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    if (note >= 0 || errno != EEXIST) break;
    name = fmt::format("{}.{}", base, i);
  }
  if (note < 0) {
    throw Error(fmt::format("cannot write {}: {}", note_file.string(), std::strerror(errno)));
  }
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  ::localtime_r(&now, &local);
  std::array<char, 32> date{};
  std::strftime(date.data(), date.size(), "%Y-%m-%dT%H:%M:%S", &local);
  const fs::path target = trash / "files" / name;
  try {
    WriteAll(note,
             fmt::format("[Trash Info]\nPath={}\nDeletionDate={}\n", PercentEncoded(path.string()),
                         date.data()),
             note_file);
    if (fs::exists(fs::symlink_status(target))) {
      throw Error(target.string() + " is there already, without its note");
    }
    fs::rename(path, target, failed);
    if (failed) {
      throw Error(fmt::format("cannot move {} to the trash in {}: {}", path.string(),
                              trash.string(), failed.message()));
    }
  } catch (...) {
    ::close(note);
    ::unlink(note_file.c_str());
    throw;
  }
  ::close(note);
  return target;
}

}  // namespace ccmorse::tools
