// Archives that come from others. Written by hand, as no honest library writes the hostile ones.

#include "tools/zip_archive.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "base/error.h"
#include "tests/support/process.h"

namespace ccmorse::tools {
namespace {

namespace fs = std::filesystem;
using testing::TemporaryFile;
using testing::TemporaryFolder;

struct Entry {
  std::string name;
  std::string content;
  std::uint32_t mode = 0100644;
  std::uint32_t claimed = UINT32_MAX;  // unpacked size that the directory says, else the true one
  std::uint16_t flags = 0;
};

std::string Number(std::uint32_t value, int bytes) {
  std::string text;
  for (int i = 0; i < bytes; ++i) text += static_cast<char>(value >> (8 * i) & 0xFFU);
  return text;
}

// An archive of stored entries (PKWARE's APPNOTE 6.3: 4.3.7, 4.3.12, 4.3.16).
std::string Archive(const std::vector<Entry>& entries) {
  std::string text;
  std::string directory;
  for (const Entry& entry : entries) {
    const auto crc =
        static_cast<std::uint32_t>(::crc32(0, reinterpret_cast<const Bytef*>(entry.content.data()),
                                           static_cast<uInt>(entry.content.size())));
    const auto size = static_cast<std::uint32_t>(entry.content.size());
    const std::uint32_t claimed = entry.claimed == UINT32_MAX ? size : entry.claimed;
    const std::string common =
        Number(20, 2) + Number(entry.flags, 2) + Number(0, 2) + Number(0, 4) + Number(crc, 4) +
        Number(size, 4) + Number(claimed, 4) +
        Number(static_cast<std::uint32_t>(entry.name.size()), 2) + Number(0, 2);
    directory += "PK\x01\x02" + Number(3 << 8 | 20, 2) + common + Number(0, 2) + Number(0, 2) +
                 Number(0, 2) + Number(entry.mode << 16U, 4) +
                 Number(static_cast<std::uint32_t>(text.size()), 4) + entry.name;
    text += "PK\x03\x04" + common + entry.name + entry.content;
  }
  const auto count = static_cast<std::uint32_t>(entries.size());
  const auto at = static_cast<std::uint32_t>(text.size());
  return text + directory + "PK\x05\x06" + Number(0, 4) + Number(count, 2) + Number(count, 2) +
         Number(static_cast<std::uint32_t>(directory.size()), 4) + Number(at, 4) + Number(0, 2);
}

// What ReadZip(), or then Unzip(), says against an archive; "" when it is taken.
std::string Complaint(const std::vector<Entry>& entries, const ZipLimits& limits = {}) {
  const TemporaryFile file(".zip", Archive(entries));
  const TemporaryFolder folder;
  try {
    Unzip(file.path(), ReadZip(file.path(), limits), folder.path());
    return "";
  } catch (const Error& error) {
    return error.what();
  }
}

TEST(G11, AnHonestArchiveIsUnpackedWithoutItsTopFolder) {
  const TemporaryFile file(".zip", Archive({{"top/", "", 040755},
                                            {"top/scenario.json", "{}"},
                                            {"top/run.sh", "#!/bin/sh\n", 0104755},
                                            {"top/maps/a b.txt", "x"},
                                            {"__MACOSX/top/._x", "junk"}}));
  const TemporaryFolder folder;
  const ZipContents contents = ReadZip(file.path());
  EXPECT_EQ(contents.top, "top");
  Unzip(file.path(), contents, folder.path());
  EXPECT_EQ(ReadFile(folder.path() + "/scenario.json"), "{}");
  EXPECT_EQ(ReadFile(folder.path() + "/maps/a b.txt"), "x");
  EXPECT_FALSE(fs::exists(folder.path() + "/__MACOSX"));
  const fs::perms mode = fs::status(folder.path() + "/run.sh").permissions();
  EXPECT_NE(mode & fs::perms::owner_exec, fs::perms::none);
  EXPECT_EQ(mode & fs::perms::set_uid, fs::perms::none);
}

TEST(G11, AnArchiveWhosePathsLeaveTheFolderIsRefused) {
  for (const char* name :
       {"../x", "a/../../x", "/etc/x", "a/..", "..", "a//b", "./a", "a\\..\\x", "a\nb", "a/./b"}) {
    EXPECT_NE(Complaint({{"a/ok", "x"}, {name, "x"}}).find("is not unpacked"), std::string::npos)
        << name;
  }
  EXPECT_NE(Complaint({{std::string(300, 'n'), "x"}}).find("too long"), std::string::npos);
  std::string deep = "d";
  for (int i = 0; i < 100; ++i) deep += "/d";
  EXPECT_NE(Complaint({{deep, "x"}}).find("too deep"), std::string::npos);
}

TEST(G11, AnArchiveWithLinksAndDevicesIsRefused) {
  EXPECT_NE(Complaint({{"a/link", "/etc/passwd", 0120777}}).find("is a link"), std::string::npos);
  EXPECT_NE(Complaint({{"a/pipe", "", 0010644}}).find("neither"), std::string::npos);
  EXPECT_NE(Complaint({{"a/tty", "", 0020644}}).find("neither"), std::string::npos);
  // A file that calls itself a folder.
  EXPECT_NE(Complaint({{"a/b", "x", 0040755}}).find("neither"), std::string::npos);
}

TEST(G11, TwoEntriesForOnePlaceAreRefused) {
  EXPECT_NE(Complaint({{"a/x", "1"}, {"a/x", "2"}}).find("twice"), std::string::npos);
  EXPECT_NE(Complaint({{"a/x", "1"}, {"a/x/y", "2"}}).find("twice"), std::string::npos);
  EXPECT_NE(Complaint({{"a/x/y", "1"}, {"a/x", "2"}}).find("twice"), std::string::npos);
}

TEST(G11, ABombIsRefused) {
  ZipLimits limits;
  limits.files = 2;
  EXPECT_NE(Complaint({{"a/1", ""}, {"a/2", ""}, {"a/3", ""}}, limits).find("3 files"),
            std::string::npos);
  limits = {};
  limits.bytes = 10;
  EXPECT_NE(Complaint({{"a/1", "123456"}, {"a/2", "123456"}}, limits).find("would fill"),
            std::string::npos);
  // What it claims counts, whatever is in it.
  EXPECT_NE(Complaint({{"a/1", "x", 0100644, 0xFFFFFFF0U}}).find("would fill"), std::string::npos);
  EXPECT_NE(Complaint({{"a/1", "x", 0100644, 100U << 20U}}).find("no project"), std::string::npos);
}

TEST(G11, AnArchiveThatLiesOfItsSizesIsRefused) {
  EXPECT_NE(Complaint({{"a/1", "123456", 0100644, 3}}), "");
  EXPECT_NE(Complaint({{"a/1", "123456", 0100644, 9}}), "");
}

TEST(G11, WhatIsNoArchiveIsRefused) {
  EXPECT_NE(Complaint({}), "");
  EXPECT_NE(Complaint({{"a/1", "x", 0100644, UINT32_MAX, 1}}), "");  // encrypted
  for (const std::string& text : {std::string(), std::string("PK"), std::string(1000, 'x'),
                                  Archive({{"a", "b"}}).substr(5)}) {
    const TemporaryFile file(".zip", text);
    EXPECT_THROW(Unzip(file.path(), ReadZip(file.path()), "/nowhere"), Error);
  }
}

TEST(G11, WhatWriteZipWritesReadZipReads) {
  const TemporaryFolder folder;
  const TemporaryFile file(".txt", std::string(100'000, 'a'));
  const std::string archive = folder.path() + "/x.zip";
  WriteZip(archive, {{"top/ä b.txt", file.path(), true}});
  const ZipContents contents = ReadZip(archive);
  ASSERT_EQ(contents.entries.size(), 1U);
  EXPECT_TRUE(contents.entries[0].executable);
  EXPECT_LT(fs::file_size(archive), 10'000U);
  fs::create_directory(folder.path() + "/out");
  Unzip(archive, contents, folder.path() + "/out");
  EXPECT_EQ(ReadFile(folder.path() + "/out/ä b.txt"), std::string(100'000, 'a'));
  EXPECT_THROW(WriteZip(folder.path() + "/no/x.zip", {{"a", file.path(), false}}), Error);
}

}  // namespace
}  // namespace ccmorse::tools
