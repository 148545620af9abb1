#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace ccmorse::tools {

/// A file for what a program prints, however much that is: of more than the limit only the first
/// and the last half are kept, with a line between them that says how much is missing. The first
/// half is written as it comes, the last with Close(). Nothing printed makes no file. Not thread
/// safe.
class BoundedLog {
 public:
  /// `most`: bytes, > 0. An older file of that name goes.
  BoundedLog(std::string path, std::size_t most);
  ~BoundedLog();
  BoundedLog(const BoundedLog&) = delete;
  BoundedLog& operator=(const BoundedLog&) = delete;

  void Add(std::string_view text);
  /// Writes what is missing, once. Errors are left out of account: a log that could not be written
  /// is no reason to lose a result.
  void Close();

  const std::string& path() const { return path_; }
  bool empty() const { return total_ == 0; }

 private:
  void Write(std::string_view text);

  std::string path_;
  std::size_t half_;
  std::uint64_t total_ = 0;    // bytes that came
  std::uint64_t written_ = 0;  // bytes of them in the file
  std::string tail_;           // what came behind those; only its last half_ bytes count
  int file_ = -1;
};

}  // namespace ccmorse::tools
