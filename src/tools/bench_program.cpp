#include "tools/bench_program.h"

#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <string>

#include "base/error.h"
#include "tools/child_process.h"

namespace ccmorse::tools {

void ExecuteBench(const std::string& name, const BenchProgramArguments& arguments) {
  const std::filesystem::path self = OwnProgram();
  const std::string program = (self.parent_path() / ("ccmorse-bench-" + name)).string();
  const std::string seconds = fmt::format("{}", arguments.seconds);
  std::fflush(stdout);
  ::execl(program.c_str(), program.c_str(), self.c_str(), seconds.c_str(),
          arguments.json ? "json" : "table", nullptr);
  throw Error("cannot run " + program + ": " + std::strerror(errno));
}

}  // namespace ccmorse::tools
