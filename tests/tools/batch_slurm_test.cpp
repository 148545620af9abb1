// The job script for Slurm; tests/end_to_end/slurm_test.cpp has a real one run it.

#include "tools/batch_slurm.h"

#include <gtest/gtest.h>

#include "tests/support/process.h"

namespace ccmorse::tools {
namespace {

TEST(BatchSlurm, TheListOfTasksIsShort) {
  EXPECT_EQ(TaskList({1}), "1");
  EXPECT_EQ(TaskList({1, 2, 3, 4}), "1-4");
  EXPECT_EQ(TaskList({1, 3, 4, 7, 8, 9, 12}), "1,3-4,7-9,12");
}

TEST(BatchSlurm, AnyTextIsOneWordOfTheShell) {
  EXPECT_EQ(ShellWord("/home/me/a-b_1.json"), "/home/me/a-b_1.json");
  for (const std::string text :
       {"", "a b", "it's", "$HOME", "`id`", "a\nb", "\"", "\\", "*", "'"}) {
    const auto echoed =
        ccmorse::testing::RunToEnd({"sh", "-c", "printf %s " + ShellWord(text) + ""});
    EXPECT_EQ(echoed.output, text);
  }
}

TEST(BatchSlurm, TheScriptStartsOneTaskOfTheBatch) {
  SlurmArray array;
  array.name = "n";
  array.ccmorse = "/usr/bin/ccmorse";
  array.manifest = "/my files/m.json";
  array.out = "/out/r.jsonl";
  array.folder = "/out/r.slurm";
  array.tasks = 40;
  array.at_once = 2;
  array.words = {"--log-kib", "64"};
  array.options = {"--partition=long", "--time=1:00:00"};
  EXPECT_EQ(SlurmScript(array),
            "#!/bin/sh\n"
            "# One task of a batch of simulations; written by `ccmorse batch --slurm`.\n"
            "#SBATCH --job-name=n\n"
            "#SBATCH --output=/out/r.slurm/task-%a.out\n"
            "#SBATCH --cpus-per-task=2\n"
            "#SBATCH --partition=long\n"
            "#SBATCH --time=1:00:00\n"
            "exec /usr/bin/ccmorse batch '/my files/m.json' --out /out/r.jsonl --task "
            "\"$SLURM_ARRAY_TASK_ID/40\" -j 2 --log-kib 64\n");
}

}  // namespace
}  // namespace ccmorse::tools
