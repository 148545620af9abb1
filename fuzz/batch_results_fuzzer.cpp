// ReadResults. What must hold, whatever the bytes:
// - it takes whole lines up to where it says, or throws an Error of one line that begins with the
//   file's name;
// - what it took is of jobs of the manifest, and written in order it is read again, all of it, and
//   written the same.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

#include "base/error.h"
#include "fuzz/check.h"
#include "tools/batch_results.h"

namespace {

using ccmorse::fuzz::Require;
using ccmorse::tools::BatchJob;
using ccmorse::tools::BatchResults;

const std::vector<BatchJob>& Jobs() {
  static const std::vector<BatchJob> jobs = ccmorse::tools::ParseManifest(
      R"({"seconds": 1, "scenarios": ["a"], "seeds": [1, 2], "programs": ["p"]})", "m.json");
  return jobs;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(data, data + size);
  BatchResults results;
  std::size_t taken = 0;
  try {
    taken = ccmorse::tools::ReadResults(text, "r.jsonl", Jobs(), "m.json", results);
  } catch (const ccmorse::Error& error) {
    const std::string message = error.what();
    Require(message.starts_with("r.jsonl:"), "an Error begins with the file's name", message);
    Require(std::none_of(message.begin(), message.end(),
                         [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }),
            "an Error is one line of text", message);
    return 0;
  }
  Require(taken <= size && (taken == 0 || text[taken - 1] == '\n'), "whole lines are taken");
  Require(results.size() <= Jobs().size(), "only jobs of the manifest have results");
  const std::string written = ccmorse::tools::InManifestOrder(Jobs(), results);
  BatchResults again;
  Require(
      ccmorse::tools::ReadResults(written, "r.jsonl", Jobs(), "m.json", again) == written.size(),
      "what is written is read", written);
  Require(ccmorse::tools::InManifestOrder(Jobs(), again) == written, "and written the same",
          written);
  return 0;
}
