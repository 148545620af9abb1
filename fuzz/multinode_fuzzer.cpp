// What simulators that share a scene tell each other (wire/multinode.h). The input is a line. What
// must hold: it is read, as a node's message or as a server's answer, or turned down with a reason;
// what was read has finite numbers, and written again it is one line that reads as the same.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

#include "base/error.h"
#include "fuzz/check.h"
#include "wire/multinode.h"

namespace {

using ccmorse::fuzz::Require;
using ccmorse::wire::NodeMessage;
using ccmorse::wire::NodeScene;

void CheckScene(const NodeScene& scene) {
  for (const double number : scene.time) Require(std::isfinite(number), "a time is finite");
  for (const auto& [name, robot] : scene.robots) {
    Require(name.substr(0, 2) != "__", "no robot has the name of something else", name);
    for (const auto& numbers : {robot.position, robot.rotation}) {
      for (const double number : numbers) Require(std::isfinite(number), "a place is finite");
    }
  }
}

void CheckMessage(const std::string& line) {
  NodeMessage message;
  try {
    message = ccmorse::wire::ParseNodeMessage(line);
  } catch (const ccmorse::Error& error) {
    Require(*error.what() != '\0', "it says why");
    return;
  }
  CheckScene(message.scene);
  const std::string text = ccmorse::wire::NodeMessageLine(message);
  Require(text.find('\n') == text.size() - 1, "a message is one line", text);
  const NodeMessage again = ccmorse::wire::ParseNodeMessage(text);
  Require(again.node == message.node && again.scene == message.scene,
          "a message written again is the same", text);
}

void CheckAnswer(const std::string& line) {
  NodeScene scene;
  try {
    scene = ccmorse::wire::ParseNodeAnswer(line);
  } catch (const ccmorse::Error& error) {
    Require(*error.what() != '\0', "it says why");
    return;
  }
  CheckScene(scene);
  const std::string text = ccmorse::wire::NodeAnswerLine(scene);
  Require(text.find('\n') == text.size() - 1, "an answer is one line", text);
  Require(ccmorse::wire::ParseNodeAnswer(text) == scene, "an answer written again is the same",
          text);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string line(data, data + size);
  CheckMessage(line);
  CheckAnswer(line);
  return 0;
}
