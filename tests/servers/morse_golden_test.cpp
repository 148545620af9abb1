// Byte-level conformance with MORSE's sockets: the exchanges of golden/*.txt over real sockets, one
// test each (specs: morse.md A.2 to A.12). golden/README.md tells how they are written.

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <ostream>
#include <regex>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "base/json.h"
#include "tests/servers/served_simulation.h"
#include "tests/support/line_client.h"

namespace ccmorse::servers {
namespace {

using std::chrono::milliseconds;
using testing::LineClient;

constexpr milliseconds kSilence(150);

struct Exchange {
  std::string name;
  std::string file;
  int line = 0;  // of its heading
  std::string scene;
  Pace pace = Pace::kLockstep;
  std::vector<std::pair<int, std::string>> steps;  // line number, text
};

void PrintTo(const Exchange& exchange, std::ostream* out) {
  *out << exchange.file << ":" << exchange.line;
}

// "One token only" -> "OneTokenOnly"
std::string TestName(const std::string& heading) {
  std::string name;
  bool first = true;
  for (const char c : heading) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) {
      first = true;
      continue;
    }
    name += first ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    first = false;
  }
  return name;
}

std::vector<Exchange> Load(const std::string& name) {
  const std::string path = std::string(CCMORSE_SOURCE_DIR) + "/tests/servers/golden/" + name;
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot read " + path);
  std::vector<Exchange> exchanges;
  std::string scene = "{}";
  Pace pace = Pace::kLockstep;
  std::string text;
  for (int number = 1; std::getline(file, text); ++number) {
    if (text.empty() || text.starts_with("#")) continue;
    if (text.starts_with("%scene ")) {
      scene = text.substr(7);
    } else if (text.starts_with("%pace ")) {
      pace = text.substr(6) == "real" ? Pace::kRealTime : Pace::kLockstep;
    } else if (text.starts_with("== ")) {
      exchanges.push_back({TestName(text.substr(3)), name, number, scene, pace, {}});
    } else if (exchanges.empty()) {
      throw std::runtime_error(path + ": a step before the first heading");
    } else {
      exchanges.back().steps.emplace_back(number, text);
    }
  }
  return exchanges;
}

// C's escapes: \n \r \t \0 \\ \xHH.
std::string Unescaped(const std::string& text) {
  std::string bytes;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\\' || i + 1 == text.size()) {
      bytes += text[i];
      continue;
    }
    const char next = text[++i];
    if (next == 'x') {
      bytes += static_cast<char>(std::stoi(text.substr(i + 1, 2), nullptr, 16));
      i += 2;
    } else {
      bytes += next == 'n'   ? '\n'
               : next == 'r' ? '\r'
               : next == 't' ? '\t'
               : next == '0' ? '\0'
                             : next;
    }
  }
  return bytes;
}

// Services that are there for the tests alone, as the component "toy".
class Toy {
 public:
  void AddTo(ServiceDirectory& directory) {
    const auto add = [&directory](const char* name, std::vector<sim::ServiceParameter> parameters,
                                  std::function<Json(sim::Arguments)> run) {
      sim::Service service{name, std::move(parameters), std::move(run)};
      service.changes_simulation = false;
      directory.Add("toy", std::move(service));
    };
    add("echo", {{"value"}}, [](sim::Arguments arguments) { return arguments[0]; });
    add("fail", {}, [](sim::Arguments) -> Json { throw sim::ServiceFailed("it \"cannot\" be\n"); });
    add("finish", {}, [this](sim::Arguments) {
      for (sim::Completion& done : std::exchange(running_, {})) {
        done({sim::Outcome::kSuccess, "done"});
      }
      return Json();
    });
    AddSlow(directory, "slow", sim::WhileRunning::kRefused);
    AddSlow(directory, "brave", sim::WhileRunning::kNeverPreempted);
    AddSlow(directory, "polite", sim::WhileRunning::kPreempts);
  }

 private:
  void AddSlow(ServiceDirectory& directory, const char* name, sim::WhileRunning policy) {
    sim::Service service{
        name, {{"number"}}, nullptr, [this](sim::Arguments arguments, sim::Completion done) {
          sim::NumberArgument(arguments, 0, "number");
          for (sim::Completion& old : std::exchange(running_, {})) {
            old({sim::Outcome::kPreempted, Json()});
          }
          running_.push_back(std::move(done));
        }};
    service.changes_simulation = false;
    service.while_running = policy;
    directory.Add("toy", std::move(service));
  }

  std::vector<sim::Completion> running_;
};

// One exchange as it goes on.
class Play {
 public:
  explicit Play(const Exchange& exchange)
      : served_(exchange.scene, exchange.pace, 0.0, {}, 1, {}, 10.0, {},
                [this](Runner& runner) { toy_.AddTo(runner.directory()); }) {}

  void Do(const std::string& step) {
    const auto word = std::find_if_not(step.begin(), step.end(),
                                       [](unsigned char c) { return std::isalnum(c) != 0; });
    const std::string who(step.begin(), word);
    std::string text(word, step.end());
    std::string verb;
    for (const char* known : {">>", ">", "<~", "<", "!", "@"}) {
      if (verb.empty() && text.starts_with(known)) verb = known;
    }
    ASSERT_FALSE(verb.empty()) << "no step: " << step;
    text.erase(0, verb.size());
    if (text.starts_with(" ")) text.erase(0, 1);
    if (verb == "@") return Open(who, text);
    if (clients_.count(who) == 0) {
      clients_[who] = std::make_unique<LineClient>(served_.port());
    }
    LineClient& client = *clients_[who];
    if (verb == ">") return client.Send(text + "\n");
    if (verb == ">>") return client.Send(Unescaped(text));
    if (verb == "!") return Act(client, who, text);
    const std::optional<std::string> line = client.ReadLine();
    ASSERT_TRUE(line) << "nothing comes where it should be " << text;
    if (verb == "<") {
      EXPECT_EQ(*line, text);
    } else {
      EXPECT_TRUE(std::regex_match(*line, std::regex(text))) << *line << "\nis not\n" << text;
    }
  }

 private:
  void Open(const std::string& who, const std::string& component) {
    LineClient asks(served_.port());
    const std::string reply = asks.Ask("1 simulation get_stream_port [\"" + component + "\"]");
    ASSERT_TRUE(reply.starts_with("1 SUCCESS ")) << reply;
    clients_[who] = std::make_unique<LineClient>(std::stoi(reply.substr(10)));
  }

  void Act(LineClient& client, const std::string& who, const std::string& what) {
    if (what == "silent") {
      const auto line = client.ReadLine(kSilence);
      EXPECT_FALSE(line) << *line;
    } else if (what == "close") {
      clients_.erase(who);
    } else if (what == "reset") {
      client.Reset();
      clients_.erase(who);
    } else if (what == "drain") {
      while (client.ReadLine(kSilence)) {
      }
    } else {
      ADD_FAILURE() << "nobody can " << what;
    }
  }

  Toy toy_;
  ServedSimulation served_;
  std::map<std::string, std::unique_ptr<LineClient>> clients_;
};

class Golden : public ::testing::TestWithParam<Exchange> {};

TEST_P(Golden, IsByteForByte) {
  const Exchange& exchange = GetParam();
  Play play(exchange);
  for (const auto& [number, text] : exchange.steps) {
    SCOPED_TRACE(exchange.file + ":" + std::to_string(number));
    play.Do(text);
    if (HasFatalFailure()) return;
  }
  // Whatever it was, the simulation lives.
  if (exchange.name == "QuitIsAnsweredAndEndsTheRun") return;
  play.Do("alive> alive toy echo [1]");
  play.Do("alive< alive SUCCESS 1");
}

std::string NameOf(const ::testing::TestParamInfo<Exchange>& info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(A2, Golden, ::testing::ValuesIn(Load("a2_encoding.txt")), NameOf);
INSTANTIATE_TEST_SUITE_P(A3, Golden, ::testing::ValuesIn(Load("a3_sensor_streams.txt")), NameOf);
INSTANTIATE_TEST_SUITE_P(A4, Golden, ::testing::ValuesIn(Load("a4_actuator_streams.txt")), NameOf);
INSTANTIATE_TEST_SUITE_P(A5, Golden, ::testing::ValuesIn(Load("a5_services.txt")), NameOf);
INSTANTIATE_TEST_SUITE_P(A5Errors, Golden, ::testing::ValuesIn(Load("a5_errors.txt")), NameOf);
INSTANTIATE_TEST_SUITE_P(A8, Golden, ::testing::ValuesIn(Load("a8_simulation.txt")), NameOf);
INSTANTIATE_TEST_SUITE_P(A9, Golden, ::testing::ValuesIn(Load("a9_time.txt")), NameOf);
INSTANTIATE_TEST_SUITE_P(A10, Golden, ::testing::ValuesIn(Load("a10_communication.txt")), NameOf);
INSTANTIATE_TEST_SUITE_P(A11, Golden, ::testing::ValuesIn(Load("a11_components.txt")), NameOf);

}  // namespace
}  // namespace ccmorse::servers
