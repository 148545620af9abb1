// Several simulators that share a scene (specs: morse.md A.7): in lock-step, with the hash of one.

#include "wire/multinode.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "base/error.h"
#include "base/json.h"
#include "scene/scenario.h"
#include "servers/morse/multinode_server.h"
#include "servers/runner.h"
#include "sim/simulation.h"
#include "tests/support/line_client.h"

namespace ccmorse::servers {
namespace {

using testing::LineClient;

// The server in a thread of its own.
class Server {
 public:
  Server() : port_(server_.port()), thread_([this] { server_.Run(); }) {}
  ~Server() {
    server_.Stop();
    thread_.join();
  }
  int port() const { return port_; }

 private:
  MultinodeServer server_{"127.0.0.1", 0};
  int port_;
  std::thread thread_;
};

// Four robots with scanners, two of which drive into the way of the others.
std::string Scene(int port, const std::string& nodes) {
  const auto robot = [](const std::string& name, double x, double y, int yaw) {
    return R"({"name": ")" + name + R"(", "pose": {"x": )" + std::to_string(x) + R"(, "y": )" +
           std::to_string(y) + R"(, "yaw_deg": )" + std::to_string(yaw) +
           R"(}, "laser": {"samples": 61, "range_std": 0.01}, "pose_noise": {"pos_std": 0.01}})";
  };
  return R"({"world": {"name": "hall", "size": [6, 6], "boxes": []}, "seed": 7, "robots": [)" +
         robot("a", 1, 3, 0) + "," + robot("b", 4, 3, 180) + "," + robot("c", 2, 1, 90) + "," +
         robot("d", 2, 5, 270) + R"(], "multinode": {"port": )" + std::to_string(port) +
         R"(, "nodes": )" + nodes + "}}";
}

constexpr double kSeconds = 6.0;

// A run of the scene as this node ("": all of it) to its end: its hash. All robots that are its own
// drive, each in its way.
std::uint64_t RunNode(const std::string& scene, const std::string& node) {
  sim::Simulation simulation(scene::ParseScenario(scene, "test.json"));
  RunOptions options;
  options.pace = Pace::kMax;
  options.seconds = kSeconds;
  options.morse.listen = false;
  options.node = node;
  Runner runner(simulation, options);
  const std::map<std::string, std::string> commands = {
      {"a", "[0.4, 0.02]"}, {"b", "[0.3, -0.01]"}, {"c", "[0.35, 0.0]"}, {"d", "[0.5, 0.1]"}};
  for (const auto& [robot, command] : commands) {
    runner.directory().Call(robot + ".motion", "set_speed", command, [](const auto&) {});
  }
  runner.Run();
  return simulation.Hash();
}

std::vector<std::uint64_t> RunNodes(const std::string& scene, std::vector<std::string> nodes) {
  std::vector<std::uint64_t> hashes(nodes.size());
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    threads.emplace_back([&, i] { hashes[i] = RunNode(scene, nodes[i]); });
  }
  for (std::thread& thread : threads) thread.join();
  return hashes;
}

TEST(Multinode, TheSameSceneOnOneNodeAndOnTwoHasTheSameHash) {
  const Server server;
  const std::string scene = Scene(server.port(), R"({"A": ["a", "c"], "B": ["b", "d"]})");
  const std::uint64_t alone = RunNode(scene, "");
  for (const std::uint64_t hash : RunNodes(scene, {"A", "B"})) EXPECT_EQ(hash, alone);
  // Again with the same server, and with nodes that come the other way round.
  for (const std::uint64_t hash : RunNodes(scene, {"B", "A"})) EXPECT_EQ(hash, alone);
}

TEST(Multinode, FourNodesWithARobotEachHaveItToo) {
  const Server server;
  const std::string scene =
      Scene(server.port(), R"({"A": ["a"], "B": ["b"], "C": ["c"], "D": ["d"]})");
  const std::uint64_t alone = RunNode(scene, "");
  for (const std::uint64_t hash : RunNodes(scene, {"A", "B", "C", "D"})) EXPECT_EQ(hash, alone);
}

TEST(Multinode, RobotsOfTwoNodesRunIntoEachOther) {
  // Otherwise the tests above would not tell much.
  sim::Simulation simulation(scene::ParseScenario(Scene(1, R"({"A": ["a", "b", "c", "d"]})"), "x"));
  RunOptions options;
  options.pace = Pace::kMax;
  options.seconds = kSeconds;
  options.morse.listen = false;
  Runner runner(simulation, options);
  runner.directory().Call("a.motion", "set_speed", "[0.4, 0.02]", [](const auto&) {});
  runner.directory().Call("b.motion", "set_speed", "[0.3, -0.01]", [](const auto&) {});
  runner.directory().Call("c.motion", "set_speed", "[0.35, 0.0]", [](const auto&) {});
  runner.directory().Call("d.motion", "set_speed", "[0.5, 0.1]", [](const auto&) {});
  runner.Run();
  std::uint64_t contacts = 0;
  for (const auto& robot : simulation.robots()) contacts += robot->tally().contacts;
  EXPECT_GT(contacts, 0U);
}

TEST(Multinode, RobotsOfOthersAreThereButSilent) {
  const Server server;
  const std::string scene = Scene(server.port(), R"({"A": ["a", "c"], "B": ["b", "d"]})");
  sim::Simulation simulation(scene::ParseScenario(scene, "test.json"));
  RunOptions options;
  options.morse.port = 0;
  options.morse.first_stream_port = 0;
  options.node = "A";
  Runner runner(simulation, options);
  const auto ask = [&runner](const char* component, const char* service, const char* arguments) {
    std::string answer;
    runner.directory().Call(component, service, arguments, [&](const sim::ServiceResult& result) {
      answer = result.text.empty() ? result.value.Dump() : std::string(result.text);
    });
    return answer;
  };
  EXPECT_EQ(ask("simulation", "list_robots", ""), R"(["a", "c"])");
  EXPECT_EQ(ask("simulation", "details", "").find("\"b."), std::string::npos);
  EXPECT_EQ(ask("simulation", "list_streams", "").find("\"b."), std::string::npos);
  EXPECT_EQ(ask("b.pose", "get_local_data", ""),
            R"("The request get_local_data has not been registered in Socket service manager")");
  // They are in the scene.
  EXPECT_NE(ask("simulation", "get_scene_objects", "").find("\"b\": "), std::string::npos);
}

TEST(Multinode, WithoutAServerTheRunDoesNotStart) {
  int port = 0;
  {
    const Server server;
    port = server.port();
  }
  sim::Simulation simulation(
      scene::ParseScenario(Scene(port, R"({"A": ["a", "b", "c", "d"]})"), "x"));
  RunOptions options;
  options.morse.listen = false;
  options.node = "A";
  try {
    const Runner runner(simulation, options);
    ADD_FAILURE() << "there is no server";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("multinode-server"), std::string::npos);
  }
}

TEST(Multinode, ANodeThatIsNotInTheSceneIsNamed) {
  sim::Simulation simulation(scene::ParseScenario(Scene(1, R"({"A": ["a", "b", "c", "d"]})"), "x"));
  RunOptions options;
  options.morse.listen = false;
  options.node = "Z";
  EXPECT_THROW(const Runner runner(simulation, options), Error);
}

TEST(Multinode, ADistributionThatIsNoneIsRefused) {
  for (const char* nodes : {R"({"A": ["a", "b", "c"]})", R"({"A": ["a", "b", "c", "d", "e"]})",
                            R"({"A": ["a", "b", "c", "d"], "B": ["a"]})", "{}", "[]"}) {
    EXPECT_THROW(scene::ParseScenario(Scene(1, nodes), "x"), Error) << nodes;
  }
}

TEST(Multinode, AScenarioKeepsIt) {
  const scene::Scenario scenario =
      scene::ParseScenario(Scene(65001, R"({"A": ["a", "b"], "B": ["c", "d"]})"), "x");
  const scene::Scenario again = scene::ParseScenario(scene::ToJson(scenario).Dump(), "y");
  ASSERT_TRUE(again.multinode);
  EXPECT_EQ(again.multinode->port, 65001);
  EXPECT_EQ(again.multinode->nodes, scenario.multinode->nodes);
}

// --- What goes over the wire, byte for byte.

constexpr const char* kHere =
    R"(["A", {"r": [[1.0, 2.0, 3.0], [0.0, 0.0, 0.5]], "__time": [1.5, 0.016666666666666666, 9.0]}])"
    "\n";
constexpr const char* kThere =
    R"(["B", {"s": [[4, 5, 6], [0, 0, 1e-07]], "__time": [2.5, 0.016666666666666666, 9.5]}])"
    "\n";

TEST(MultinodeWire, MorsesOwnNodesAreAnsweredAtOnceWithTheOthersRobots) {
  const Server server;
  LineClient a(server.port());
  LineClient b(server.port());
  a.Send(kHere);
  EXPECT_EQ(a.ReadLine(), R"({"__time": [1.5, 0.016666666666666666, 9.0]})");
  b.Send(kThere);
  EXPECT_EQ(
      b.ReadLine(),
      R"({"r": [[1.0, 2.0, 3.0], [0.0, 0.0, 0.5]], "__time": [2.5, 0.016666666666666666, 9.5]})");
  a.Send(kHere);
  EXPECT_EQ(
      a.ReadLine(),
      R"({"s": [[4.0, 5.0, 6.0], [0.0, 0.0, 1e-07]], "__time": [2.5, 0.016666666666666666, 9.5]})");
}

TEST(MultinodeWire, NodesInLockstepWaitForEachOther) {
  const Server server;
  const auto told = [](const std::string& node, const std::string& robot, double x) {
    wire::NodeMessage message;
    message.node = node;
    message.scene.nodes = 2;
    message.scene.robots[robot].position = {x, 0.0, 0.0};
    message.scene.robots[robot].command = {{0.25, 0.0, 0.0}};
    return wire::NodeMessageLine(message);
  };
  LineClient a(server.port());
  a.Send(told("A", "r", 1.0));
  EXPECT_FALSE(a.ReadLine(std::chrono::milliseconds(100))) << "the other is not there yet";
  LineClient b(server.port());
  b.Send(told("B", "s", 2.0));
  EXPECT_EQ(wire::ParseNodeAnswer(a.ReadLine().value()).robots.at("s").position[0], 2.0);
  EXPECT_EQ(wire::ParseNodeAnswer(b.ReadLine().value()).robots.at("r").position[0], 1.0);
  b.Send(told("B", "s", 3.0));
  EXPECT_FALSE(b.ReadLine(std::chrono::milliseconds(100)));
  a.Send(told("A", "r", 1.5));
  const wire::NodeScene answer = wire::ParseNodeAnswer(a.ReadLine().value());
  EXPECT_EQ(answer.robots.at("s").position[0], 3.0);
  EXPECT_EQ(answer.robots.at("s").command.value()[0], 0.25);
  b.ReadLine();
  // One that leaves is not waited for.
  a.Send(told("A", "r", 1.5));
  b.Reset();
  EXPECT_TRUE(wire::ParseNodeAnswer(a.ReadLine().value()).robots.empty());
}

TEST(MultinodeWire, WhatIsNoMessageCostsItsConnectionOnly) {
  const Server server;
  LineClient good(server.port());
  for (const char* bad :
       {"rubbish\n", "[]\n", "5\n", "{}\n", "[\"A\", 5]\n", "[\"A\", {\"r\": 5}]\n",
        "[\"A\", {\"r\": [[1, 2], [0, 0, 0]]}]\n", "[\"A\", {\"r\": [[1, 2, NaN], [0, 0, 0]]}]\n",
        "[\"A\", {\"__ccmorse\": {\"nodes\": -1}}]\n", "\xff\xfe\n"}) {
    LineClient client(server.port());
    client.Send(bad);
    EXPECT_TRUE(client.IsClosed()) << bad;
  }
  good.Send(kHere);
  EXPECT_TRUE(good.ReadLine());
}

}  // namespace
}  // namespace ccmorse::servers
