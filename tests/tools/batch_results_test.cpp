// The file of a batch's results: found again after any kind of end, and never mixed with others.

#include "tools/batch_results.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <optional>

#include "base/error.h"
#include "tests/support/process.h"

namespace ccmorse::tools {
namespace {

using ccmorse::testing::TemporaryFolder;

std::vector<BatchJob> Jobs() {
  std::vector<BatchJob> jobs = ParseManifest(
      R"({"seconds": 1, "scenarios": ["a"], "seeds": {"from": 1, "to": 3}})", "m.json");
  return jobs;
}

Json LineOf(const BatchJob& job, const std::string& status = "ok") {
  Json line = JobLine(job);
  line.Set("status", status);
  return line;
}

std::string ErrorOf(const std::string& text, const std::vector<BatchJob>& jobs) {
  BatchResults results;
  try {
    ReadResults(text, "r.jsonl", jobs, "m.json", results);
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(BatchResults, ATornLastLineIsLeftOutWhereverItWasCut) {
  const auto jobs = Jobs();
  const std::string first = LineOf(jobs[0]).Dump() + "\n";
  const std::string second = LineOf(jobs[1]).Dump() + "\n";
  for (std::size_t cut = 0; cut < second.size(); ++cut) {
    BatchResults results;
    EXPECT_EQ(ReadResults(first + second.substr(0, cut), "r", jobs, "m", results), first.size());
    EXPECT_EQ(results.size(), 1U) << cut;
  }
  BatchResults results;
  EXPECT_EQ(ReadResults(first + second, "r", jobs, "m", results), first.size() + second.size());
  EXPECT_EQ(results.size(), 2U);
  // What a machine that went down may leave behind.
  results.clear();
  EXPECT_EQ(ReadResults(first + std::string(40, '\0') + "\n", "r", jobs, "m", results),
            first.size());
}

TEST(BatchResults, LinesOfSomethingElseAreErrorsThatSayWhere) {
  auto jobs = Jobs();
  const std::string line = LineOf(jobs[0]).Dump() + "\n";
  EXPECT_EQ(ErrorOf(line + "nonsense\n" + line, jobs), "r.jsonl:2: Expecting value (column 1)");
  EXPECT_EQ(ErrorOf("{}\n", jobs), "r.jsonl:1: this is no line of a batch's results");
  EXPECT_EQ(ErrorOf(line + "[]\n", jobs), "r.jsonl:2: this is no line of a batch's results");
  auto fewer = jobs;
  fewer.erase(fewer.begin());
  EXPECT_EQ(ErrorOf(line, fewer),
            "r.jsonl:1: m.json has no job 'a-1'; choose another --out, or remove the line");
  jobs[0].seconds = 2.0;
  EXPECT_EQ(ErrorOf(line, jobs),
            "r.jsonl:1: the seconds of job 'a-1' was 1.0 and is 2.0 in m.json now; choose another "
            "--out, or remove the line");
  jobs[0].index = 5;
  jobs[0].seconds = 1.0;
  EXPECT_EQ(ErrorOf(line, jobs), "no error") << "a manifest may grow at its front";
}

TEST(BatchResults, TheOrderIsTheManifestsWhateverTheOrderOfTheLines) {
  const auto jobs = Jobs();
  const TemporaryFolder folder;
  const std::string path = folder.path() + "/r.jsonl";
  const std::string sorted =
      LineOf(jobs[0]).Dump() + "\n" + LineOf(jobs[1]).Dump() + "\n" + LineOf(jobs[2]).Dump() + "\n";
  for (const auto& order : {std::vector<std::size_t>{0, 1, 2}, {2, 0, 1}, {1, 2, 0}}) {
    std::filesystem::remove(path);
    {
      ResultsFile file(path, jobs, "m.json");
      for (const std::size_t i : order) file.Add(jobs[i], LineOf(jobs[i]));
      file.Sort();
    }
    EXPECT_EQ(ReadFile(path), sorted);
  }
}

TEST(BatchResults, ItGoesOnBehindTheLastWholeLine) {
  const auto jobs = Jobs();
  const TemporaryFolder folder;
  const std::string path = folder.path() + "/r.jsonl";
  const std::string first = LineOf(jobs[0]).Dump() + "\n";
  std::ofstream(path) << first << LineOf(jobs[1]).Dump().substr(0, 30);
  {
    ResultsFile file(path, jobs, "m.json");
    EXPECT_EQ(file.results().size(), 1U);
    file.Add(jobs[2], LineOf(jobs[2]));
  }
  EXPECT_EQ(ReadFile(path), first + LineOf(jobs[2]).Dump() + "\n");
}

TEST(BatchResults, KeepLeavesOutWhatIsToBeDoneAgain) {
  const auto jobs = Jobs();
  const TemporaryFolder folder;
  const std::string path = folder.path() + "/r.jsonl";
  ResultsFile file(path, jobs, "m.json");
  file.Add(jobs[1], LineOf(jobs[1], "failed"));
  file.Add(jobs[0], LineOf(jobs[0]));
  file.Keep([](const Json& line) { return line.Find("status")->AsString() == "ok"; });
  EXPECT_EQ(ReadFile(path), LineOf(jobs[0]).Dump() + "\n");
  file.Add(jobs[1], LineOf(jobs[1]));
  EXPECT_EQ(ReadFile(path), LineOf(jobs[0]).Dump() + "\n" + LineOf(jobs[1]).Dump() + "\n");
}

TEST(BatchResults, TwoBatchesDoNotWriteToOneFile) {
  const auto jobs = Jobs();
  const TemporaryFolder folder;
  const std::string path = folder.path() + "/r.jsonl";
  std::optional<ResultsFile> first(std::in_place, path, jobs, "m.json");
  EXPECT_THROW(ResultsFile(path, jobs, "m.json"), Error);
  first->Add(jobs[1], LineOf(jobs[1]));
  first->Add(jobs[0], LineOf(jobs[0]));
  first->Sort();
  EXPECT_THROW(ResultsFile(path, jobs, "m.json"), Error) << "the sorted file is locked, too";
  first.reset();
  EXPECT_EQ(ResultsFile(path, jobs, "m.json").results().size(), 2U);
}

}  // namespace
}  // namespace ccmorse::tools
