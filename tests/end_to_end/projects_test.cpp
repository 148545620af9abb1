// Projects from the command line, as the thesis's sections 4.1 and 4.3 and MORSE's users know it:
// real processes, with a home folder of their own.

#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "base/error.h"
#include "tests/support/line_client.h"
#include "tests/support/process.h"

namespace ccmorse::testing {
namespace {

namespace fs = std::filesystem;

const std::string kPar = CCMORSE_SOURCE_DIR "/courses/par/";

// A user who has just installed ccmorse.
class User {
 public:
  User() : home_(fs::canonical(folder_.path()).string()), work_(home_ + "/work") {
    fs::create_directory(work_);
  }

  const std::string& home() const { return home_; }
  const std::string& work() const { return work_; }
  std::string config() const { return ReadFile(home_ + "/.morse/config"); }

  // A command line of `program` in the folder work().
  std::vector<std::string> Words(const std::string& program,
                                 const std::vector<std::string>& words) const {
    std::vector<std::string> all = {
        "/usr/bin/env", "-u", "XDG_DATA_HOME", "-C", work_, "HOME=" + home_, BuiltProgram(program)};
    all.insert(all.end(), words.begin(), words.end());
    return all;
  }

  Finished Do(const std::string& program, const std::vector<std::string>& words) const {
    return RunToEnd(Words(program, words));
  }

  // The same with something on its stdin.
  Finished Answer(const std::string& answer, const std::string& program,
                  const std::vector<std::string>& words) const {
    const TemporaryFile input(".txt", answer);
    std::vector<std::string> all = {"/bin/sh", "-c", "exec \"$@\" <" + input.path(), "sh"};
    for (const std::string& word : Words(program, words)) all.push_back(word);
    return RunToEnd(all);
  }

 private:
  TemporaryFolder folder_;
  std::string home_;
  std::string work_;
};

bool Has(const Finished& run, const std::string& text) {
  return run.output.find(text) != std::string::npos;
}

void ExpectOk(const Finished& run) { EXPECT_EQ(run.status, 0) << run.output; }

// One line that says all of `what`, and a status that says failure.
void ExpectRefused(const Finished& run, const std::vector<std::string>& what) {
  EXPECT_EQ(run.status, 1) << run.output;
  EXPECT_EQ(std::count(run.output.begin(), run.output.end(), '\n'), 1) << run.output;
  for (const std::string& part : what) EXPECT_TRUE(Has(run, part)) << part << ": " << run.output;
}

const std::vector<std::string> kShort = {"--headless", "--pace", "max",           "--for", "0.1",
                                         "--port",     "0",      "--stream-port", "0"};

std::vector<std::string> RunWords(std::vector<std::string> words) {
  words.insert(words.begin(), "run");
  words.insert(words.end(), kShort.begin(), kShort.end());
  return words;
}

// Starts a simulation for a while and asks it for its robots.
void ExpectRobots(const User& user, const std::string& program,
                  const std::vector<std::string>& words, const std::string& robots) {
  Process process(user.Words(program, words));
  const std::string key = "MORSE services on 127.0.0.1 port ";
  const auto line = process.WaitForLine(key);
  ASSERT_TRUE(line) << process.output();
  EXPECT_TRUE(process.WaitForLine("SCENE INITIALIZED"));
  EXPECT_EQ(LineClient(std::atoi(line->c_str() + key.size())).Ask("1 simulation list_robots"),
            "1 SUCCESS " + robots);
  process.Signal(SIGINT);
  EXPECT_EQ(process.Wait(), 0);
}

const std::vector<std::string> kLive = {"--headless", "--port", "0", "--stream-port", "0"};

std::vector<std::string> LiveWords(std::vector<std::string> words) {
  words.insert(words.end(), kLive.begin(), kLive.end());
  return words;
}

TEST(S01, CreateSaysWhatMorseSays) {
  const User user;
  for (const std::string program : {"morse", "ccmorse"}) {
    const std::string name = "env_of_" + program;
    const Finished run = user.Do(program, {"create", name});
    ExpectOk(run);
    EXPECT_EQ(run.output, "* A new simulation environment has been successfully created in <" +
                              user.work() + "/" + name + ">.\n* You can run it directly with \"" +
                              program + " run " + name + "\" or you can start editing it.\n");
  }
  EXPECT_EQ(user.config(), "[sites]\nenv_of_morse = " + user.work() +
                               "/env_of_morse\nenv_of_ccmorse = " + user.work() +
                               "/env_of_ccmorse\n");
}

TEST(S01, CreateReplacesNothing) {
  const User user;
  ExpectOk(user.Do("morse", {"create", "x"}));
  ExpectRefused(user.Do("morse", {"create", "x"}),
                {"'x' already", user.work() + "/x", "morse rm x"});
  fs::create_directory(user.work() + "/mine");
  std::ofstream(user.work() + "/mine/precious") << "data";
  ExpectRefused(user.Do("morse", {"create", "mine"}), {user.work() + "/mine is there already"});
  // By force the old one goes where it can be found again.
  ExpectOk(user.Do("morse", {"create", "-f", "mine"}));
  EXPECT_EQ(ReadFile(user.home() + "/.local/share/Trash/files/mine/precious"), "data");
}

TEST(S01, CreateNamesABetterName) {
  const User user;
  ExpectRefused(user.Do("morse", {"create", "my env"}), {"has a blank", "morse create my_env"});
  ExpectRefused(user.Do("morse", {"create", "class"}), {"word of Python", "my_class"});
  ExpectRefused(user.Do("morse", {"create", "morse"}), {"my_morse"});
  ExpectRefused(user.Do("morse", {"create", "no/such/folder"}), {user.work() + "/no/such"});
  EXPECT_EQ(user.Do("morse", {"create"}).status, 2);
  EXPECT_TRUE(fs::is_empty(user.work()));
}

TEST(S02, AProjectHoldsMorsesFiles) {
  const User user;
  ExpectOk(user.Do("morse", {"create", "MorseSyrotek"}));
  const std::string root = user.work() + "/MorseSyrotek";
  for (const char* file :
       {"default.py", "scripts/MorseSyrotek_client.py", "src/MorseSyrotek/__init__.py",
        "src/MorseSyrotek/builder/__init__.py"}) {
    EXPECT_TRUE(fs::is_regular_file(root + "/" + file)) << file;
  }
  EXPECT_TRUE(fs::is_directory(root + "/data/MorseSyrotek"));
  for (const auto& entry : fs::directory_iterator(user.work())) {
    EXPECT_EQ(entry.path().filename(), "MorseSyrotek");  // and nothing half done
  }
}

TEST(S03, ANewProjectRunsAtOnceByNameInAnyCaseAndByItsFolder) {
  const User user;
  ExpectOk(user.Do("morse", {"create", "First"}));
  for (const std::string what : {"First", "first", "./First", "First/"}) {
    ExpectRobots(user, "morse", LiveWords({"run", what}), "[\"robot\"]");
  }
  // Its robot has what default.py gives it.
  Process process(user.Words("morse", LiveWords({"run", "First"})));
  const std::string key = "MORSE services on 127.0.0.1 port ";
  const auto line = process.WaitForLine(key);
  ASSERT_TRUE(line) << process.output();
  LineClient client(std::atoi(line->c_str() + key.size()));
  for (const char* const component : {"robot.motion", "robot.pose"}) {
    EXPECT_EQ(client.Ask(std::string("1 ") + component + " get_properties").substr(0, 9),
              "1 SUCCESS");
  }
}

TEST(S04, AddRobotMakesTemplatesInDataAndSrc) {
  const User user;
  ExpectOk(user.Do("morse", {"create", "MorseSyrotek"}));
  ExpectOk(user.Do("morse", {"add", "robot", "syrotek", "MorseSyrotek"}));
  const std::string root = user.work() + "/MorseSyrotek/";
  EXPECT_NE(ReadFile(root + "src/MorseSyrotek/robots/syrotek.py").find("class Syrotek("),
            std::string::npos);
  const std::string builder = ReadFile(root + "src/MorseSyrotek/builder/robots/syrotek.py");
  EXPECT_NE(builder.find("class Syrotek(GroundRobot):"), std::string::npos);
  EXPECT_NE(builder.find("def __init__(self, name=None, debug=True):"), std::string::npos);
  EXPECT_NE(builder.find("MorseSyrotek.robots.syrotek.Syrotek"), std::string::npos);
  EXPECT_EQ(ReadFile(root + "src/MorseSyrotek/builder/robots/__init__.py"),
            "from .syrotek import Syrotek\n");
  EXPECT_TRUE(fs::exists(root + "src/MorseSyrotek/robots/__init__.py"));
  EXPECT_TRUE(fs::exists(root + "data/MorseSyrotek/robots/syrotek.obj"));
}

TEST(S05, AddSensorAsksForADescriptionAndReplacesNothing) {
  const User user;
  ExpectOk(user.Do("morse", {"create", "env1"}));
  ExpectOk(user.Answer("Tells the robot's settings.\n", "morse",
                       {"add", "sensor", "robotproperties", "env1"}));
  const std::string sensor = user.work() + "/env1/src/env1/sensors/robotproperties.py";
  const std::string text = ReadFile(sensor);
  EXPECT_NE(text.find("class Robotproperties(morse.core.sensor.Sensor):"), std::string::npos);
  EXPECT_NE(text.find("_short_desc = \"Tells the robot's settings.\""), std::string::npos);
  std::ofstream(sensor) << "# mine\n";
  ExpectRefused(user.Do("morse", {"add", "sensor", "robotproperties", "env1", "-d", "x"}),
                {sensor, "-f"});
  EXPECT_EQ(ReadFile(sensor), "# mine\n");
  // A second one joins the first; the first one again does not come twice.
  ExpectOk(user.Do("morse", {"add", "sensor", "other", "env1", "-d", "x"}));
  ExpectOk(user.Do("morse", {"add", "sensor", "other", "env1", "-d", "x", "-f"}));
  EXPECT_EQ(ReadFile(user.work() + "/env1/src/env1/builder/sensors/__init__.py"),
            "from .robotproperties import Robotproperties\nfrom .other import Other\n");
}

TEST(S06, AddActuatorMakesPythonThatCompiles) {
  const User user;
  ExpectOk(user.Do("morse", {"create", "env1"}));
  ExpectOk(user.Answer("", "morse", {"add", "actuator", "pen", "env1"}));
  ExpectOk(user.Do("morse", {"add", "sensor", "probe", "env1", "-d", "it's \"x\" \\"}));
  ExpectOk(user.Do("morse", {"add", "robot", "rover", "env1"}));
  EXPECT_NE(ReadFile(user.work() + "/env1/src/env1/builder/actuators/pen.py")
                .find("class Pen(ActuatorCreator):"),
            std::string::npos);
  const Finished compiled =
      RunToEnd({"/usr/bin/python3", "-m", "compileall", "-q", user.work() + "/env1"});
  EXPECT_EQ(compiled.status, 0) << compiled.output;
}

TEST(S06, AddNamesWhatIsWrong) {
  const User user;
  ExpectOk(user.Do("morse", {"create", "env1"}));
  ExpectRefused(user.Do("morse", {"add", "camera", "pen", "env1"}), {"'camera'", "sensor"});
  ExpectRefused(user.Do("morse", {"add", "sensor", "x", "evn1"}), {"did you mean 'env1'"});
  ExpectRefused(user.Do("morse", {"add", "sensor", "my pen", "env1"}), {"my_pen env1"});
  EXPECT_EQ(user.Do("morse", {"add", "sensor"}).status, 2);
  fs::remove_all(user.work() + "/env1");
  ExpectRefused(user.Do("morse", {"add", "sensor", "x", "env1"}), {"gone", "import -f"});
}

TEST(S07, ImportTakesTheFoldersNameUnlessThereIsAnother) {
  const User user;
  fs::copy(kPar + "planning/scenario.json", user.work() + "/scenario.json");
  const std::string project = user.work() + "/PAR_INTRO";
  fs::create_directory(project);
  fs::rename(user.work() + "/scenario.json", project + "/scenario.json");
  for (const std::string path : {"PAR_INTRO", "PAR_INTRO/", "./PAR_INTRO/."}) {
    ExpectOk(user.Do("morse", {"import", path}));
    EXPECT_EQ(user.config(), "[sites]\nPAR_INTRO = " + project + "\n");
  }
  ExpectOk(user.Do("ccmorse", {"import", project, "another name"}));
  EXPECT_EQ(user.config(),
            "[sites]\nPAR_INTRO = " + project + "\nanother name = " + project + "\n");
  ExpectOk(user.Do("morse", RunWords({"another name"})));
  const Finished list = user.Do("ccmorse", {"list"});
  EXPECT_TRUE(Has(list, "\nPAR_INTRO  (" + project + ")\n")) << list.output;
  EXPECT_TRUE(Has(user.Do("ccmorse", {"list", "--names"}), "\nanother name\n"));
}

TEST(S07, ImportNamesWhatIsWrong) {
  const User user;
  ExpectRefused(user.Do("morse", {"import", "nowhere"}), {"nowhere", "No such file"});
  fs::create_directory(user.work() + "/empty");
  ExpectRefused(user.Do("morse", {"import", "empty"}), {"scenario.json", "default.py", "-f"});
  ExpectOk(user.Do("morse", {"create", "x"}));
  ExpectRefused(user.Do("morse", {"import", "x/default.py"}),
                {"is a file", "import " + user.work()});
  ExpectRefused(user.Do("morse", {"import", "x", "a=b"}), {"'a=b'", "has a '='"});
  ExpectRefused(user.Do("morse", {"import", "x", "syrotek"}), {"'syrotek'", "scenario", "NAME"});
  ExpectRefused(user.Do("morse", {"import", kPar + "planning", "X"}), {"'x' is " + user.work()});
  EXPECT_EQ(user.config(), "[sites]\nx = " + user.work() + "/x\n");
}

TEST(S07, AUsersConfigFileOfMorseIsKept) {
  const User user;
  fs::create_directory(user.home() + "/.morse");
  const std::string own = "# mine\n[other]\nkey: 1\n\n[sites]\nold = ~/work/old\n?? broken line\n";
  std::ofstream(user.home() + "/.morse/config") << own;
  ExpectOk(user.Do("morse", {"create", "fresh"}));
  EXPECT_EQ(user.config(), own + "fresh = " + user.work() + "/fresh\n");
  ExpectOk(user.Do("morse", {"rm", "-f", "fresh"}));
  EXPECT_EQ(user.config(), own);
  ExpectRefused(user.Do("morse", RunWords({"old"})),
                {user.work() + "/old", "gone", "import -f", "rm old"});
}

TEST(S07, ManyProcessesImportAtATime) {
  const User user;
  ExpectOk(user.Do("morse", {"create", "base"}));
  std::vector<std::unique_ptr<Process>> all;
  constexpr int kProcesses = 20;
  for (int i = 0; i < kProcesses; ++i) {
    all.push_back(std::make_unique<Process>(
        user.Words("morse", {"import", "base", "copy" + std::to_string(i)})));
  }
  for (const auto& each : all) EXPECT_EQ(each->Wait(), 0) << each->output();
  const std::string config = user.config();
  EXPECT_EQ(std::count(config.begin(), config.end(), '\n'), kProcesses + 2);
}

TEST(S08, TwoCommandsStartATaskOfTheCourse) {
  for (const std::string program : {"morse", "ccmorse"}) {
    const User user;
    ExpectOk(user.Do(program, {"import", kPar + "planning", "PAR_PLANNING"}));
    ExpectRobots(user, program, LiveWords({"run", "PAR_PLANNING"}), "[\"s1r\"]");
    ExpectOk(user.Do(program, {"import", kPar + "exploration", "PAR_EXPLORATION"}));
    ExpectOk(user.Do(program, RunWords({"PAR_EXPLORATION"})));
  }
}

TEST(S08, MorseexecIsMorseRun) {
  const User user;
  ExpectOk(user.Do("morse", {"import", kPar + "planning", "PAR_PLANNING"}));
  std::vector<std::string> words = RunWords({"PAR_PLANNING"});
  words.erase(words.begin());
  ExpectOk(user.Do("morseexec", words));
  ExpectRefused(user.Do("morseexec", {"nothing"}), {"'nothing'"});
  EXPECT_EQ(user.Do("morse", {"--version"}).output.substr(0, 10), "morse 1.4 ");
}

TEST(S08, RunTakesAFileOfTheEnvironmentAndNamesTheNearest) {
  const User user;
  ExpectOk(user.Do("morse", {"create", "x"}));
  std::ofstream(user.work() + "/x/harder.json") << "{}";
  ExpectOk(user.Do("morse", RunWords({"x", "harder.json"})));
  ExpectRefused(user.Do("morse", RunWords({"x", "hader.json"})),
                {"'x'", "did you mean 'harder.json'"});
  ExpectRefused(user.Do("morse", RunWords({"xx.json"})), {"'xx.json'"});
  ExpectRefused(user.Do("morse", RunWords({"x", "harder.json", "word"})), {"'word'"});
  // MORSE: an environment comes before a file of that name.
  std::ofstream(user.work() + "/y") << "{}";
  ExpectOk(user.Do("morse", {"import", "x", "y"}));
  EXPECT_TRUE(Has(user.Do("morse", RunWords({"y"})), "Scenario y: 1 robot"));
}

TEST(S08, MorsesOptionsOfRunAreTakenOrAnswered) {
  const User user;
  ExpectOk(user.Do("morse", {"create", "x"}));
  std::vector<std::string> words = RunWords({"x", "--name", "node1", "-g", "800x600"});
  words.insert(words.begin(), {"-n", "-c"});
  const Finished run = user.Do("morse", words);
  ExpectOk(run);
  EXPECT_TRUE(Has(run, "--color has no effect")) << run.output;
  EXPECT_TRUE(Has(run, "-g has no effect")) << run.output;
  ExpectRefused(user.Do("morse", RunWords({"x", "-b", "base.blend"})),
                {"base.blend", "Environment("});
  ExpectRefused(user.Do("morse", RunWords({"x", "--log", "file"})), {">file 2>&1"});
  const Finished edit = user.Do("morse", {"edit", "x"});
  EXPECT_EQ(edit.status, 1);
  EXPECT_TRUE(Has(edit, user.work() + "/x/")) << edit.output;
}

TEST(S09, DefaultPyBeginsAsABuilderScript) {
  const User user;
  ExpectOk(user.Do("morse", {"create", "x"}));
  const std::string script = ReadFile(user.work() + "/x/default.py");
  EXPECT_TRUE(script.starts_with("#! /usr/bin/env morseexec\n"));
  EXPECT_NE(script.find("\nfrom morse.builder import *\n"), std::string::npos);
  EXPECT_NE(fs::status(user.work() + "/x/default.py").permissions() & fs::perms::owner_exec,
            fs::perms::none);
}

TEST(Rm, AnImportedEnvironmentIsOnlyForgotten) {
  const User user;
  const std::string project = user.work() + "/mine";
  fs::create_directory(project);
  std::ofstream(project + "/scenario.json") << "{}";
  ExpectOk(user.Do("morse", {"import", "mine"}));
  const Finished run = user.Do("morse", {"rm", "-f", "mine"});
  ExpectOk(run);
  EXPECT_TRUE(Has(run, "stays as it is")) << run.output;
  EXPECT_TRUE(fs::exists(project + "/scenario.json"));
  EXPECT_EQ(user.config(), "[sites]\n");
  ExpectRefused(user.Do("morse", {"rm", "mine"}), {"'mine'"});
}

TEST(Rm, ACreatedOneGoesIntoTheTrashAfterAYes) {
  const User user;
  ExpectOk(user.Do("morse", {"create", "x"}));
  for (const std::string answer : {"", "n\n", "\n"}) {
    EXPECT_EQ(user.Answer(answer, "morse", {"rm", "x"}).status, 1);
    EXPECT_TRUE(fs::exists(user.work() + "/x/default.py"));
  }
  ExpectOk(user.Answer("y\n", "morse", {"rm", "X"}));
  EXPECT_FALSE(fs::exists(user.work() + "/x"));
  EXPECT_TRUE(fs::exists(user.home() + "/.local/share/Trash/files/x/default.py"));
  ExpectOk(user.Do("morse", {"create", "x"}));
  ExpectOk(user.Do("morse", {"rm", "-y", "--delete", "x"}));
  EXPECT_FALSE(fs::exists(user.work() + "/x"));
}

TEST(Rm, AFolderThatAnotherNameNeedsStays) {
  const User user;
  ExpectOk(user.Do("morse", {"create", "x"}));
  ExpectOk(user.Do("morse", {"import", "x", "y"}));
  const Finished run = user.Do("morse", {"rm", "-f", "x"});
  EXPECT_TRUE(Has(run, "\"y\" is there, too")) << run.output;
  ExpectOk(user.Do("morse", {"rm", "-f", "y"}));
  EXPECT_TRUE(fs::exists(user.work() + "/x/default.py"));
}

TEST(G11, AProjectGoesThroughAZipToAnotherMachineAndOneCommandStartsIt) {
  const User teacher;
  const std::string project = teacher.work() + "/planning";
  fs::copy(kPar + "planning", project, fs::copy_options::recursive);
  // What was built here is of no use there.
  fs::create_directories(project + "/template/obj-morse");
  std::ofstream(project + "/template/obj-morse/planner.o") << "x";
  fs::copy_file(BuiltProgram("ccmorse"), project + "/template/planner");
  ExpectOk(teacher.Do("ccmorse", {"import", "planning", "PAR_PLANNING"}));
  const std::string zip = teacher.work() + "/planning/x.zip";
  ExpectOk(teacher.Do("ccmorse", {"export", "PAR_PLANNING", "-o", zip}));
  ExpectOk(teacher.Do("ccmorse", {"export", "PAR_PLANNING", "-o", zip}));  // not into itself

  const User student;
  ExpectOk(student.Do("ccmorse", {"import", zip}));
  const std::string there = student.work() + "/PAR_PLANNING";
  for (const auto& entry : fs::recursive_directory_iterator(kPar + "planning")) {
    const std::string file = fs::relative(entry.path(), kPar + "planning").string();
    if (!entry.is_regular_file() || file.find("obj-") != std::string::npos ||
        (fs::status(entry.path()).permissions() & fs::perms::owner_exec) != fs::perms::none) {
      continue;
    }
    ASSERT_TRUE(fs::exists(there + "/" + file)) << file;
    EXPECT_EQ(ReadFile(there + "/" + file), ReadFile(entry.path().string())) << file;
  }
  EXPECT_FALSE(fs::exists(there + "/template/obj-morse"));
  EXPECT_FALSE(fs::exists(there + "/template/planner"));
  EXPECT_FALSE(fs::exists(there + "/x.zip"));
  fs::remove_all(project);
  ExpectOk(student.Do("ccmorse", RunWords({"PAR_PLANNING"})));

  // Unpacked by hand, its folder runs without an import.
  const User other;
  const Finished unzip = RunToEnd(
      {"/usr/bin/python3", "-m", "zipfile", "-e", there + "/../PAR_PLANNING.zip", other.work()});
  EXPECT_NE(unzip.status, 0);
  ExpectOk(student.Do("ccmorse", {"export", "PAR_PLANNING"}));
  ExpectOk(RunToEnd({"/usr/bin/python3", "-m", "zipfile", "-e",
                     student.work() + "/PAR_PLANNING.zip", other.work()}));
  ExpectOk(other.Do("ccmorse", RunWords({"PAR_PLANNING/"})));
}

TEST(G11, ImportOfAZipLeavesNothingWhereItFails) {
  const User user;
  const std::string script =
      "import zipfile\n"
      "z = zipfile.ZipFile('" +
      user.home() +
      "/evil.zip', 'w')\n"
      "z.writestr('p/scenario.json', '{}')\n"
      "z.writestr('p/../../escaped', 'x')\n"
      "z.close()\n"
      "z = zipfile.ZipFile('" +
      user.home() +
      "/bomb.zip', 'w', zipfile.ZIP_DEFLATED)\n"
      "z.writestr('p/scenario.json', '{}')\n"
      "z.writestr('p/zeros', bytes(100 << 20))\n"
      "z.close()\n"
      "z = zipfile.ZipFile('" +
      user.home() +
      "/none.zip', 'w')\n"
      "z.writestr('p/readme', 'x')\n"
      "z.close()\n";
  ExpectOk(RunToEnd({"/usr/bin/python3", "-c", script}));
  ExpectRefused(user.Do("ccmorse", {"import", "../evil.zip"}), {"escaped", "leads out"});
  ExpectRefused(user.Do("ccmorse", {"import", "../bomb.zip"}), {"no project"});
  ExpectRefused(user.Do("ccmorse", {"import", "../none.zip"}), {"scenario.json"});
  EXPECT_TRUE(fs::is_empty(user.work()));
  EXPECT_FALSE(fs::exists(user.home() + "/.morse/config"));
  ExpectOk(user.Do("ccmorse", {"create", "p"}));
  ExpectOk(user.Do("ccmorse", {"export", "p"}));
  ExpectRefused(user.Do("ccmorse", {"import", "p.zip"}), {"is there already", "--to"});
  ExpectOk(user.Do("ccmorse", {"import", "p.zip", "q", "--to", "elsewhere"}));
  ExpectOk(user.Do("ccmorse", RunWords({"q"})));
}

TEST(G11, ExportNamesWhatCannotComeAlong) {
  const User user;
  ExpectOk(user.Do("ccmorse", {"create", "p"}));
  fs::create_symlink("/etc/passwd", user.work() + "/p/data/link");
  ExpectRefused(user.Do("ccmorse", {"export", "p"}), {"p/data/link", "/etc/passwd", "outside"});
  fs::remove(user.work() + "/p/data/link");
  std::ofstream(user.work() + "/world.json") << "{}";
  std::ofstream(user.work() + "/p/scenario.json") << R"({"world": {"file": "../world.json"}})";
  ExpectRefused(user.Do("ccmorse", {"export", "p"}),
                {"p/scenario.json", user.work() + "/world.json"});
  ExpectRefused(user.Do("ccmorse", {"export", "pp"}), {"'pp'", "ccmorse list"});
  ExpectRefused(user.Do("ccmorse", {"export", "p", "-o", "no/x.zip"}), {user.work() + "/no"});
  EXPECT_FALSE(fs::exists(user.work() + "/p.zip"));
}

TEST(Check, NamesAnEnvironmentThatIsGone) {
  const User user;
  ExpectOk(user.Do("morse", {"check"}));
  ExpectOk(user.Do("morse", {"create", "x"}));
  fs::remove_all(user.work() + "/x");
  const Finished run = user.Do("morse", {"check"});
  EXPECT_EQ(run.status, 1);
  EXPECT_TRUE(Has(run, "PROBLEM  environment 'x'")) << run.output;
  ExpectOk(user.Do("morse", {"rm", "x"}));
  ExpectOk(user.Do("morse", {"check"}));
}

TEST(Environments, AHomeThatCannotBeWrittenIsNamedAndNothingElseFails) {
  const User user;
  std::ofstream(user.home() + "/file") << "";
  const auto at = [&user](const std::vector<std::string>& words) {
    std::vector<std::string> all = {"/usr/bin/env", "HOME=" + user.home() + "/file",
                                    BuiltProgram("ccmorse")};
    all.insert(all.end(), words.begin(), words.end());
    return RunToEnd(all);
  };
  ExpectRefused(at({"import", kPar + "planning"}), {user.home() + "/file/.morse", "set HOME"});
  ExpectRefused(at({"rm", "x"}), {"'x'"});
  ExpectOk(at(RunWords({kPar + "planning/scenario.json"})));
  ExpectOk(at({"list"}));
}

// As in a sandbox, or with a config file that is not the user's to read.
TEST(Environments, ScenariosRunWhereNoEnvironmentsCanBeKnown) {
  const User user;
  fs::create_directories(user.home() + "/.morse/config");
  const Finished run = user.Do("ccmorse", RunWords({"syrotek"}));
  ExpectOk(run);
  EXPECT_TRUE(Has(run, user.home() + "/.morse/config is a folder")) << run.output;
  ExpectRefused(user.Do("ccmorse", {"create", "x"}), {"/.morse/config is a folder"});
}

TEST(Environments, RenderKnowsThemToo) {
  const User user;
  ExpectOk(user.Do("ccmorse", {"create", "x"}));
  ExpectOk(user.Do("ccmorse", {"render", "x", "--size", "64x48", "--samples", "1"}));
  EXPECT_GT(fs::file_size(user.work() + "/x.png"), 100U);
}

TEST(Completion, KnowsCommandsOptionsAndNames) {
  const User user;
  ExpectOk(user.Do("ccmorse", {"import", kPar + "planning", "PAR_PLANNING"}));
  const Finished script = user.Do("ccmorse", {"completion", "bash"});
  ExpectOk(script);
  const TemporaryFile file(".bash", script.output);
  const auto offers = [&](const std::string& words, int at) {
    const std::string bin = fs::path(BuiltProgram("ccmorse")).parent_path().string();
    return RunToEnd({"/usr/bin/env", "HOME=" + user.home(), "PATH=" + bin + ":/usr/bin:/bin",
                     "/bin/bash", "-c",
                     ". " + file.path() + "; COMP_WORDS=(" + words + "); COMP_CWORD=" +
                         std::to_string(at) + "; _ccmorse; printf '%s\\n' \"${COMPREPLY[@]}\""})
        .output;
  };
  EXPECT_EQ(offers("ccmorse imp", 1), "import\n");
  EXPECT_EQ(offers("morse run PAR_P", 2), "PAR_PLANNING\n");
  EXPECT_EQ(offers("morse run --hea", 2), "--headless\n");
  EXPECT_EQ(offers("morseexec PAR_P", 1), "PAR_PLANNING\n");
  EXPECT_EQ(offers("morse add sens", 2), "sensor\n");
  EXPECT_EQ(offers("morse rm syr", 2), "\n");
  EXPECT_EQ(user.Do("ccmorse", {"completion", "fish"}).status, 2);
}

}  // namespace
}  // namespace ccmorse::testing
