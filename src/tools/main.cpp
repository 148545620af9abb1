// The `ccmorse` program: reads the command line and hands over to the sub-command.

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/log.h"
#include "tools/batch_command.h"
#include "tools/bench_all.h"
#include "tools/bench_program.h"
#include "tools/command_line.h"
#include "tools/fleet_bench.h"
#include "tools/grade_command.h"
#include "tools/info_command.h"
#include "tools/list_command.h"
#include "tools/morse_options.h"
#include "tools/rays_bench.h"
#include "tools/render_command.h"
#include "tools/replay_command.h"
#include "tools/run_command.h"
#include "tools/sandbox_init.h"
#include "tools/scene_choice.h"

namespace {

// A number from low to high; NaN, which CLI::Range takes, is none.
CLI::Validator Within(double low, double high) {
  return {[low, high](const std::string& text) -> std::string {
            double value = std::numeric_limits<double>::quiet_NaN();
            const char* const end = text.data() + text.size();
            const auto read = std::from_chars(text.data(), end, value);
            const bool fine =
                read.ec == std::errc{} && read.ptr == end && value >= low && value <= high;
            return fine ? "" : fmt::format("{} is no number from {} to {}", text, low, high);
          },
          ""};
}

void AddRenderOptions(CLI::App& command, ccmorse::tools::RenderArguments& render) {
  command.add_option("what", render.what, "a scenario, by name or path, or a record (.mcap)")
      ->required()
      ->type_name("SCENARIO|RECORD");
  command.add_option("-o,--out", render.out, "the picture  [NAME.png]")->type_name("FILE.png");
  command
      .add_option("--camera", render.camera, "scene, top, follow[:ROBOT] or robot[:ROBOT]  [scene]")
      ->type_name("NAME");
  command.add_option("--from", render.from, "the camera's place instead, m")
      ->expected(3)
      ->type_name("X Y Z");
  command.add_option("--at", render.at, "with --from: what it looks at, m  [the floor's middle]")
      ->expected(3)
      ->type_name("X Y Z");
  command.add_option("--size", render.size, "pixels  [1280x720]")->type_name("WxH");
  command
      .add_option("--samples", render.samples,
                  "light paths a pixel: four times as many halve the noise  [32]")
      ->check(CLI::Range(1, 65536))
      ->type_name("N");
  command
      .add_option("--time", render.time,
                  "simulated second to show  [a scenario's start, a record's end]")
      ->check(Within(0.0, 1e6))
      ->type_name("S");
  command.add_flag("--lasers", render.lasers, "shows what laser scanners see");
  command.add_flag_callback(
      "--no-canvas", [&render] { render.canvas = false; }, "leaves the grid map on the floor out");
  command.add_flag("--noise", render.noise, "leaves the noise of light paths in");
  command.add_option("--threads", render.threads, "that share the work  [all cores]")
      ->check(CLI::Range(0, 256))
      ->type_name("T");
  command.add_flag("-q,--quiet", render.quiet, "prints nothing but errors");
  command.footer(
      "Examples:\n"
      "  ccmorse render docks -o docks.png\n"
      "  ccmorse render run.mcap --time 12.5 --camera follow:s1r --lasers\n"
      "  ccmorse render syrotek --from 1 0.2 1.7 --at 1.6 2.1 0 --size 1920x1080 --samples 128");
}

void AddBatchOptions(CLI::App& command, ccmorse::tools::BatchArguments& batch) {
  command.add_option("manifest", batch.manifest, "the jobs, as JSON (docs/batch.md)")
      ->required()
      ->type_name("MANIFEST.json");
  command.add_option("-j,--jobs", batch.at_once, "so many at a time  [the number of cores]")
      ->check(CLI::Range(1, 256))
      ->type_name("N");
  command
      .add_option("--out", batch.out,
                  "one JSON line a job; those of an earlier start stay  [MANIFEST.results.jsonl]")
      ->type_name("FILE.jsonl");
  CLI::Option* const retry =
      command.add_flag("--retry", batch.retry, "do jobs again that failed or ran out of time");
  command.add_flag("--timing", batch.timing, "add wall-clock times to the results");
  command
      .add_option("--log-kib", batch.log_kib,
                  "of what a program prints keep the first and the last half of this, KiB  [256]")
      ->check(CLI::Range(1, 1 << 20))
      ->type_name("N");
  command.add_flag("-q,--quiet", batch.quiet, "no progress");
  CLI::Option* const slurm =
      command.add_flag("--slurm", batch.slurm, "submit the jobs as a Slurm job array")
          ->excludes(retry);
  command.add_option("--tasks", batch.tasks, "of the array  [one a job, 100 at most]")
      ->check(CLI::Range(1, 100000))
      ->needs(slurm)
      ->type_name("T");
  command.add_option("--sbatch", batch.sbatch, "an option for sbatch, as --sbatch=--time=1:00:00")
      ->needs(slurm)
      ->type_name("OPTION");
  command.add_flag("--dry-run", batch.dry_run, "print the job script, submit nothing")
      ->needs(slurm);
  CLI::Option* const task =
      command
          .add_option("--task", batch.task,
                      "only every T-th job from the K-th on, into a part of the results: what each "
                      "task of the array does")
          ->excludes(slurm)
          ->type_name("K/T");
  command.add_flag("--collect", batch.collect, "merge the parts into --out")
      ->excludes(slurm)
      ->excludes(task);
  command.footer(
      "Examples:\n"
      "  ccmorse batch sweep.json -j 8\n"
      "  ccmorse batch sweep.json --slurm --tasks 40 --sbatch=--partition=long\n"
      "  ccmorse batch sweep.json --collect\n"
      "Exit status: 0 when every job has a result, good or bad; 1 after an error.");
}

void AddGradeOptions(CLI::App& command, ccmorse::tools::GradeArguments& grade) {
  command.add_option("task", grade.task, "a task's name, as intro, or its folder")
      ->required()
      ->type_name("TASK");
  CLI::Option* const submission =
      command
          .add_option("submission", grade.submission,
                      "a folder with a Makefile, or a program that was built already")
          ->type_name("DIR|PROGRAM");
  command.add_option("--seeds", grade.seeds, "worlds to run it in  [5]")
      ->check(CLI::Range(1, 10000))
      ->type_name("K");
  command.add_option("--first-seed", grade.first_seed, "of the first world  [1]")
      ->check(CLI::Range(std::int64_t{0}, std::int64_t{1} << 62))
      ->type_name("N");
  command.add_option("--report", grade.report, "write the result as a page")
      ->type_name("FILE.html");
  command.add_option("--json", grade.json, "write it as data; -: to the standard output")
      ->type_name("FILE.json");
  command.add_option("--keep-records", grade.keep_records, "keep the runs' records here")
      ->type_name("DIR");
  CLI::Option* const record =
      command.add_option("--record", grade.record, "judge this record, and run nothing")
          ->type_name("FILE.mcap");
  CLI::Option* const whole_class =
      command
          .add_option("--class", grade.class_folder,
                      "grade each submission in this folder; started again, it goes on")
          ->excludes(submission)
          ->excludes(record)
          ->type_name("DIR");
  command.add_option("--out", grade.out, "of a class: folder for its results  [DIR-grades]")
      ->needs(whole_class)
      ->type_name("DIR");
  command.add_option("-j,--jobs", grade.at_once, "so many at a time  [the number of cores]")
      ->check(CLI::Range(1, 256))
      ->type_name("N");
  command.add_flag("--no-sandbox", grade.no_sandbox,
                   "run it unprotected, where no sandbox can be made; the report says so");
  command.add_flag("-q,--quiet", grade.quiet, "no progress");
  command.footer(
      "Examples:\n"
      "  ccmorse grade planning my_planner --report report.html\n"
      "  ccmorse grade intro my_intro --seeds 20 --keep-records records\n"
      "  ccmorse grade exploration --class submissions\n"
      "Exit status: 0 passed, 3 below the pass mark, 1 after an error.");
}

int Run(int argc, char** argv) {
  const std::string program = ccmorse::tools::ProgramName(argc, argv);
  CLI::App app{"ccmorse - robots for programs written for Player, MORSE and SyRoTek", program};
  ccmorse::tools::AddVersionOption(app, program);
  app.require_subcommand(0, 1);
  ccmorse::tools::MorseOptions morse;
  ccmorse::tools::AddMorseOptions(app, morse);
  ccmorse::tools::RunArguments run;
  std::vector<std::string> what;
  std::vector<std::string> behind;  // "--"
  CLI::App* const run_command = app.add_subcommand("run", "simulate a scenario and serve clients");
  run_command
      ->add_option("scenario", what,
                   "an environment, or one of its files after it; a scenario's name or path (see "
                   "ccmorse list), a .cfg of Player or a .world of Stage; further words, behind "
                   "--, are for a builder script")
      ->required()
      ->type_name("SCENARIO");
  ccmorse::tools::AddMorseRunOptions(*run_command, morse);
  run_command->add_flag("--headless", run.headless, "without the live view");
  run_command
      ->add_option("--clients", run.clients,
                   "in lock-step, time starts when this many clients read  [1]")
      ->check(CLI::Range(1, 256))
      ->type_name("N");
  run_command
      ->add_option(
          "--client-timeout", run.client_timeout,
          "in lock-step, let a client go that keeps others waiting and has sent nothing for "
          "so long, in wall-clock time; 0: never  [10]")
      ->check(Within(0.0, 1e6))
      ->type_name("SECONDS");
  run_command
      ->add_option("--component-timeout", run.component_timeout,
                   "switch a component of one's own off whose Python code takes longer, in "
                   "wall-clock time  [1]")
      ->check(Within(0.01, 3600.0))
      ->type_name("SECONDS");
  run_command
      ->add_option("--pace", run.pace,
                   "real: wall-clock time; lockstep: time waits for the clients' next Read(); "
                   "max: as fast as possible  [what the scenario says, else real]")
      ->check(CLI::IsMember({"real", "lockstep", "max"}))
      ->type_name("PACE");
  run_command->add_option("--for", run.seconds, "stop after this much simulated time  [never]")
      ->check(Within(0.001, 1e9))
      ->type_name("SECONDS");
  run_command
      ->add_option("--threads", run.threads,
                   "that share the work; they change the time it takes and nothing else  [as many "
                   "as are sensible]")
      ->check(CLI::Range(1, 256))
      ->type_name("N");
  run_command->add_option("--seed", run.seed, "of all random numbers  [the scenario's]")
      ->check([](const std::string& text) -> std::string {
        std::int64_t value = 0;  // CLI11 itself takes what is too large for the largest there is
        const char* const end = text.data() + text.size();
        const auto read = std::from_chars(text.data(), end, value);
        const bool fine = read.ec == std::errc{} && read.ptr == end && value >= 0;
        return fine ? "" : text + " is no whole number from 0 to 9223372036854775807";
      })
      ->type_name("N");
  run_command->add_option("--port", run.port, "of MORSE's services; 0 takes any free one  [4000]")
      ->check(CLI::Range(0, 65535))
      ->type_name("N");
  run_command
      ->add_option("--stream-port", run.stream_port,
                   "first port of the components' streams; 0 takes any free ones  [60000]")
      ->check(CLI::Range(0, 65535))
      ->type_name("N");
  run_command
      ->add_option("--view-port", run.view_port,
                   "of the live view in a browser, or the next that is free; 0 takes any  [8000]")
      ->check(CLI::Range(0, 65535))
      ->type_name("N");
  run_command->add_flag("--open", run.open, "show the live view in the browser");
  run_command->add_flag("--view-read-only", run.view_read_only,
                        "whoever sees the live view may look, and neither drive nor stop time");
  run_command
      ->add_option("--token", run.token,
                   "word that the live view's address must carry; with --bind to other addresses "
                   "than this machine's there is no view without one")
      ->type_name("WORD");
  CLI::Option* const player_port =
      run_command
          ->add_option("--player-port", run.player_port,
                       "of Player's protocol for the first robot, the next one's is one higher; 0 "
                       "takes any free ones  [6665; without Player where that is taken]")
          ->check(CLI::Range(0, 65535))
          ->type_name("N");
  run_command->add_flag("--no-player", run.no_player, "do not serve Player's protocol")
      ->excludes(player_port);
  run_command
      ->add_option("--mirror", run.mirrors,
                   "show a real robot: put ROBOT (else the first) where the Player server says its "
                   "robot is, with its laser scan; once for each robot")
      ->type_name("[ROBOT=]player://HOST[:PORT]")
      ->take_all();
  run_command->add_option("--bind", run.bind, "address to listen on  [127.0.0.1]")
      ->type_name("ADDRESS");
  run_command->add_option("--out", run.out, "folder for pictures that clients save  [.]")
      ->type_name("FOLDER");
  run_command->add_option("--picture", run.picture, "write the arena from above here at the end")
      ->type_name("FILE.png");
  run_command->add_option("--report", run.report, "write the report of the run here as JSON")
      ->type_name("FILE.json");
  CLI::Option* const record =
      run_command
          ->add_option("--record", run.record,
                       "write the record of the run here, as MCAP (docs/records.md)")
          ->type_name("FILE.mcap");
  run_command
      ->add_option("--record-data", run.record_data,
                   "what the record shows beside what a replay needs: none, or a list of poses, "
                   "all, sensors (s1r.hokuyo, or hokuyo of every robot)  [poses]")
      ->needs(record)
      ->type_name("LIST");
  run_command
      ->add_option("--hash-every", run.hash_every,
                   "print the state hash every N ticks; a record has its hashes then, instead of "
                   "every tick")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1'000'000'000}))
      ->type_name("N");
  run_command->add_flag("--contest", run.contest,
                        "programs are judged: refuse them what is no robot's to do, as teleporting "
                        "or asking where the obstacles are (docs/grading.md)");
  run_command
      ->add_option("--listen-socket", run.listen_socket,
                   "serve on this file descriptor, a socket that listens, instead of --port")
      ->check(CLI::Range(0, 1 << 20))
      ->type_name("FD");
  run_command->add_flag("-q,--quiet", run.quiet, "print errors only");
  run_command->footer(
      "Examples:\n"
      "  ccmorse run syrotek --headless --pace lockstep --for 120\n"
      "  ccmorse run two_robots --port 0          prints the port it took\n"
      "  ccmorse run syrotek --record run.mcap --record-data hokuyo,poses\n"
      "  ccmorse replay run.mcap --verify         does it come out the same again?\n"
      "  ccmorse run syrotek --mirror player://syrotek:38000\n"
      "  ccmorse run simple.cfg                   a world of Stage with Player's drivers\n"
      "  ccmorse run PAR_PLANNING                 an environment (see ccmorse import)\n"
      "Ctrl-C ends a run and prints its report.");

  ccmorse::tools::ReplayArguments replay;
  CLI::App* const replay_command =
      app.add_subcommand("replay", "show a recorded run in the live view, or verify it");
  replay_command->add_option("record", replay.file, "what `ccmorse run --record` wrote")
      ->required()
      ->type_name("FILE");
  CLI::Option* const verify = replay_command->add_flag(
      "--verify", replay.verify,
      "only say whether the run comes out the same, bit for bit; else the first tick and component "
      "that differ");
  replay_command->add_flag("--headless", replay.headless,
                           "play it in the terminal, without the live view");
  replay_command
      ->add_option("--view-port", replay.view_port,
                   "of the live view in a browser, or the next that is free; 0 takes any  [8000]")
      ->check(CLI::Range(0, 65535))
      ->type_name("N");
  replay_command->add_flag("--open", replay.open, "show the live view in the browser");
  replay_command
      ->add_option("--speed", replay.speed, "simulated seconds per wall-clock second, or max  [1]")
      ->check([](const std::string& text) -> std::string {
        double factor = 0.0;
        const char* const end = text.data() + text.size();
        const auto read = std::from_chars(text.data(), end, factor);
        const bool fine =
            read.ec == std::errc{} && read.ptr == end && factor >= 0.001 && factor <= 1e6;
        return fine || text == "max" ? "" : text + " is neither a factor from 0.001 to 1e6 nor max";
      })
      ->excludes(verify)
      ->type_name("FACTOR");
  replay_command->add_option("--from", replay.from, "where to begin  [0]")
      ->check(Within(0.0, 1e9))
      ->excludes(verify)
      ->type_name("SECONDS");
  replay_command->add_option("--to", replay.to, "where to stop  [the end]")
      ->check(Within(0.0, 1e9))
      ->excludes(verify)
      ->type_name("SECONDS");
  replay_command->footer(
      "Examples:\n"
      "  ccmorse replay run.mcap                  in a browser, with a time line\n"
      "  ccmorse replay run.mcap --verify         status 0: equal; 1: it differs; 2: no use; 3: "
      "not whole\n"
      "  ccmorse replay run.mcap --headless --from 40 --speed 4\n"
      "  ccmorse replay run.mcap --headless --to 12.5 --speed max\n"
      "docs/records.md tells what a record holds and how to open it elsewhere.");

  ccmorse::tools::ConvertArguments convert;
  CLI::App* const convert_command = app.add_subcommand(
      "convert", "write a world of Stage, a .cfg of Player or a .blend as a scenario");
  convert_command
      ->add_option("file", convert.file, "a .world, a .cfg or a file of shapes (docs/assets.md)")
      ->required()
      ->type_name("FILE");
  convert_command->add_option("-o,--out", convert.out, "where to  [standard output]")
      ->type_name("SCENE.json");
  convert_command->footer(
      "Example:\n"
      "  ccmorse convert simple.world -o simple.json && ccmorse run simple.json\n"
      "What a scenario cannot have is named with its file and line (docs/scenario.md).");

  ccmorse::tools::InfoArguments info;
  CLI::App* const info_command = app.add_subcommand(
      "info", "what a file of shapes holds: objects, sizes, physics (docs/assets.md)");
  info_command
      ->add_option("file", info.file,
                   "a .blend, .gltf, .glb, .obj, .stl or .dae; also of $MORSE_RESOURCE_PATH and of "
                   "MORSE's own, as environments/sandbox.blend")
      ->required()
      ->type_name("FILE");
  info_command->add_flag("--json", info.json, "for programs");

  ccmorse::tools::RenderArguments render;
  CLI::App* const render_command = app.add_subcommand(
      "render", "a ray-traced picture of a scenario, or of a moment of a record");
  AddRenderOptions(*render_command, render);

  ccmorse::tools::ListArguments list;
  CLI::App* const list_command =
      app.add_subcommand("list", "list the scenarios and the environments");
  list_command->add_flag("--names", list.names, "nothing but names");
  list_command->add_flag("--environments", list.environments, "without the scenarios");

  ccmorse::tools::CommandLine projects(app, program);
  ccmorse::tools::AddProjectCommands(projects);

  ccmorse::tools::BatchArguments batch;
  CLI::App* const batch_command = app.add_subcommand(
      "batch", "run many scenarios, seeds and programs, and go on where it was stopped");
  AddBatchOptions(*batch_command, batch);

  CLI::App* const bench_command = app.add_subcommand("bench", "measure this machine's speed");
  bench_command->require_subcommand(1);
  ccmorse::tools::FleetArguments fleet;
  CLI::App* const fleet_command =
      bench_command->add_subcommand("fleet", "many robots with lasers, each in its own arena");
  fleet_command->add_option("--robots", fleet.robots, "how many  [100]")
      ->check(CLI::Range(1, 10000))
      ->type_name("N");
  fleet_command->add_option("--seconds", fleet.seconds, "simulated time  [10]")
      ->check(Within(0.1, 1e6))
      ->type_name("S");
  fleet_command
      ->add_option("--threads", fleet.threads,
                   "that share the work; 0: as many as are sensible  [0]")
      ->check(CLI::Range(0, 256))
      ->type_name("T");
  fleet_command->add_flag("--json", fleet.json, "one JSON object instead of a table");
  ccmorse::tools::RaysArguments rays;
  CLI::App* const rays_command =
      bench_command->add_subcommand("rays", "scans on one core, in two arenas");
  rays_command->add_option("--seconds", rays.seconds, "wall-clock time for each figure  [1]")
      ->check(Within(0.01, 1e3))
      ->type_name("S");
  rays_command->add_flag("--json", rays.json, "one JSON object instead of a table");
  ccmorse::tools::BenchProgramArguments link;
  CLI::App* const link_command = bench_command->add_subcommand(
      "link", "a client's Read() and canvas updates over TCP, by the fast link and by JSON");
  link_command->add_option("--seconds", link.seconds, "wall-clock time of each measurement  [2]")
      ->check(Within(0.01, 1000.0))
      ->type_name("S");
  link_command->add_flag("--json", link.json, "one JSON object instead of a table");
  ccmorse::tools::BenchProgramArguments player;
  CLI::App* const player_command = bench_command->add_subcommand(
      "player", "a Player client's Read() over TCP, and a hundred of them");
  player_command
      ->add_option("--seconds", player.seconds, "wall-clock time of each measurement  [2]")
      ->check(Within(0.01, 1000.0))
      ->type_name("S");
  player_command->add_flag("--json", player.json, "one JSON object instead of a table");
  ccmorse::tools::BenchProgramArguments view;
  CLI::App* const view_command = bench_command->add_subcommand(
      "view", "the live view: bytes of a frame, what 20 viewers cost, time to the first page byte");
  view_command->add_option("--seconds", view.seconds, "wall-clock time of each measurement  [2]")
      ->check(Within(0.01, 1000.0))
      ->type_name("S");
  view_command->add_flag("--json", view.json, "one JSON object instead of a table");
  ccmorse::tools::BenchProgramArguments embree;
  CLI::App* const embree_command = bench_command->add_subcommand(
      "embree", "rays against triangles among 1,000 robots on one core, beside Embree alone");
  embree_command
      ->add_option("--seconds", embree.seconds, "wall-clock time of each measurement  [2]")
      ->check(Within(0.01, 1000.0))
      ->type_name("S");
  embree_command->add_flag("--json", embree.json, "one JSON object instead of a table");

  ccmorse::tools::BenchAllArguments all;
  CLI::App* const all_command = bench_command->add_subcommand(
      "all", "everything, as one table with what is required (docs/performance.md)");
  all_command
      ->add_option("--seconds", all.seconds, "wall-clock time of each measurement of a fleet  [4]")
      ->check(Within(0.01, 1e3))
      ->type_name("S");
  all_command->add_flag("--json", all.json, "one JSON object instead of a table");

  ccmorse::tools::GradeArguments grade;
  CLI::App* const grade_command =
      app.add_subcommand("grade", "run a submission of a course's task, and say how good it is");
  AddGradeOptions(*grade_command, grade);

  // Last, as sub-commands inherit what is there when they are made.
  app.footer(
      "Examples:\n"
      "  ccmorse run syrotek                      the SyRoTek arena with one S1R, in real time\n"
      "  ccmorse run docks --port 4100            13 robots in their docks, on another port\n"
      "  ccmorse run my_scene.json --pace lockstep --for 120 --picture out/run.png\n"
      "  ccmorse run syrotek --record run.mcap    with a record of all that happens\n"
      "  ccmorse replay run.mcap --verify         does that run come out the same again?\n"
      "  ccmorse list                             the scenarios and environments there are\n"
      "  ccmorse create mine && ccmorse run mine  an environment of one's own\n"
      "`ccmorse run --help` explains the options of a run.");

  try {
    ccmorse::tools::Words words = ccmorse::tools::SplitWords(argc, argv);
    behind = std::move(words.behind);
    app.parse(std::move(words.reversed));
  } catch (const CLI::ParseError& error) {
    constexpr int kUsage = 2;  // as other programs have it, where CLI11 counts from 100
    return app.exit(error) == 0 ? 0 : kUsage;
  }
  try {
    if (app.get_subcommands().empty()) {
      std::fputs(app.help().c_str(), stdout);
      return 0;
    }
    if (const auto status = projects.Execute()) return *status;
    if (replay_command->parsed()) return ccmorse::tools::Replay(replay);
    if (render_command->parsed()) {
      const ccmorse::tools::Environments environments;
      if (environments.Find(render.what)) {
        const auto scene = ccmorse::tools::ChooseScene({render.what}, environments);
        ccmorse::tools::PrepareScene(scene);
        render.what = scene.file;
        if (render.out.empty()) render.out = scene.name + ".png";
      }
    }
    if (render_command->parsed()) return ccmorse::tools::Render(render);
    if (convert_command->parsed()) return ccmorse::tools::Convert(convert);
    if (info_command->parsed()) return ccmorse::tools::Info(info);
    if (list_command->parsed()) return ccmorse::tools::List(list);
    if (rays_command->parsed()) return ccmorse::tools::BenchRays(rays);
    if (link_command->parsed()) ccmorse::tools::ExecuteBench("link", link);
    if (player_command->parsed()) ccmorse::tools::ExecuteBench("player", player);
    if (view_command->parsed()) ccmorse::tools::ExecuteBench("view", view);
    if (embree_command->parsed()) ccmorse::tools::ExecuteBench("embree", embree);
    if (batch_command->parsed()) return ccmorse::tools::Batch(batch);
    if (grade_command->parsed()) {
      if (grade.submission.empty() && grade.class_folder.empty() && grade.record.empty()) {
        throw ccmorse::Error("what is to be graded? Give a folder, a program, --class or --record");
      }
      return ccmorse::tools::Grade(grade);
    }
    if (all_command->parsed()) return ccmorse::tools::BenchAll(all);
    if (fleet_command->parsed()) return ccmorse::tools::BenchFleet(fleet);
    ccmorse::tools::TellOfMorseOptions(morse, program);
    const ccmorse::tools::SceneChoice scene =
        ccmorse::tools::ChooseScene(what, ccmorse::tools::Environments());
    ccmorse::tools::PrepareScene(scene);
    if (!scene.note.empty() && !run.quiet) ccmorse::LogInfo("{}", scene.note);
    run.scenario = scene.file;
    run.script_arguments = scene.arguments;
    run.script_arguments.insert(run.script_arguments.end(), behind.begin(), behind.end());
    run.name = scene.name;
    return ccmorse::tools::Run(run);
  } catch (const ccmorse::Error& error) {
    std::fprintf(stderr, "ccmorse: %s\n", error.what());
    return 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "ccmorse: unexpected: %s\n", error.what());
    return 1;
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 1 && std::string_view(argv[1]) == "sandbox-init") {
    return ccmorse::tools::SandboxInit(argc, argv);
  }
  const int status = Run(argc, argv);
  // What could not be written, to a full disk say, must not look like success.
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return status;
  std::fprintf(stderr, "ccmorse: cannot write to standard output\n");
  return status == 0 ? 1 : status;
}
