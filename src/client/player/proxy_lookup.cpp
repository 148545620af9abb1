#include "client/player/proxy_lookup.h"

#include "libCCMorse/MorseProperties.h"
#include "libplayerc++/playerclient.h"

namespace CCMorse {

MorseClient& RequireClient(PlayerCc::PlayerClient* client, const char* function) {
  if (!client) throw MorseError("the client is a null pointer", function);
  return client->GetMorseClient();
}

MorseDevice& FindProxyDevice(MorseClient& client, const std::string& interface, std::uint32_t index,
                             const std::string& robot, DeviceFilter fits, const char* function) {
  if (!robot.empty()) client.GetRobot(robot);  // throws, and lists the robots
  const std::string key = std::to_string(index);
  std::string known;
  bool tables = false;
  for (const MorseRobot* candidate : client.GetRobots()) {
    if (!robot.empty() && candidate->GetName() != robot) continue;
    const MorseProperties* properties = candidate->FindDevice<MorseProperties>();
    const MorseValue proxies = properties ? properties->Get("proxies") : MorseValue();
    if (!proxies.IsObject()) continue;
    tables = true;
    const MorseValue table = proxies.Member(interface);
    for (const std::string& offered : table.GetKeys()) {
      const std::string name = table.Member(offered).GetString("");
      MorseDevice* device = name.empty() ? nullptr : candidate->FindDevice<MorseDevice>(name);
      if (offered == key) {
        if (device && fits(*device)) return *device;
        throw MorseError("robot " + candidate->GetName() + " is configured to have " + interface +
                             ":" + key + " from \"" + name + "\", which it does not carry",
                         function);
      }
      known +=
          (known.empty() ? "" : ", ") + interface + ":" + offered + " of " + candidate->GetName();
    }
  }
  if (!tables) {
    std::uint32_t count = 0;
    for (const MorseRobot* candidate : client.GetRobots()) {
      if (!robot.empty() && candidate->GetName() != robot) continue;
      for (MorseDevice* device : candidate->GetDevices()) {
        if (!fits(*device)) continue;
        if (count == index) return *device;
        known += (known.empty() ? "" : ", ") + interface + ":" + std::to_string(count) + " of " +
                 candidate->GetName();
        ++count;
      }
    }
  }
  throw MorseError("there is no " + interface + ":" + key + "; there is " +
                       (known.empty() ? "no " + interface + " at all" : known),
                   function);
}

}  // namespace CCMorse
