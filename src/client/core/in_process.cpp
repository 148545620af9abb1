#include "client/core/in_process.h"

#include <dlfcn.h>

#include <cstdlib>
#include <map>
#include <mutex>
#include <set>
#include <utility>

#include "client/core/address.h"
#include "libCCMorse/MorseError.h"
#include "wire/in_process.h"

namespace CCMorse::core {
namespace {

constexpr const char* kLibrary = "libccmorse-sim.so." CCMORSE_VERSION_MAJOR;

/// libccmorse-sim's functions.
struct Library {
  decltype(&ccmorse_sim_abi) abi = nullptr;
  decltype(&ccmorse_sim_open) open = nullptr;
  decltype(&ccmorse_sim_connect) connect = nullptr;
  decltype(&ccmorse_sim_close) close = nullptr;
};

/// All simulations of the program.
struct LiveSimulations {
  std::mutex mutex;  // held while one is opened or ends
  Library library;   // open is set once it was loaded; it is never unloaded
  std::map<std::string, std::weak_ptr<InProcess>> simulations;
  std::set<CcmorseSim*> running;
};

// Never destroyed: clients may end after any static object.
LiveSimulations& TheLiveSimulations() {
  static auto* const registry = new LiveSimulations;
  return *registry;
}

// The folder of the file that this code is in, with a '/' at its end.
std::string OwnFolder() {
  Dl_info info{};
  if (::dladdr(reinterpret_cast<const void*>(&TheLiveSimulations), &info) == 0) return "";
  const std::string file = info.dli_fname;
  return file.substr(0, file.rfind('/') + 1);
}

// `keep` holds the text of the last error.
void* OpenLibrary(std::string& failures) {
  // It is not unloaded: its threads leave objects behind that end with the threads.
  constexpr int kHow = RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE;
  const char* const chosen = std::getenv("CCMORSE_SIM_LIBRARY");
  if (chosen != nullptr && *chosen != '\0') {
    void* const handle = ::dlopen(chosen, kHow);
    if (handle == nullptr) failures = ::dlerror();
    return handle;
  }
  const std::string folder = OwnFolder();
  void* handle = folder.empty() ? nullptr : ::dlopen((folder + kLibrary).c_str(), kHow);
  if (handle == nullptr && !folder.empty()) failures = std::string(::dlerror()) + "; ";
  if (handle == nullptr) handle = ::dlopen(kLibrary, kHow);
  if (handle == nullptr) failures += ::dlerror();
  return handle;
}

template <typename Function>
bool Find(void* handle, const char* name, Function& function) {
  function = reinterpret_cast<Function>(::dlsym(handle, name));
  return function != nullptr;
}

// The program ends with simulations running: they end before the statics of their library do.
void EndAll() {
  LiveSimulations& registry = TheLiveSimulations();
  const std::lock_guard lock(registry.mutex);
  for (CcmorseSim* const simulation : std::exchange(registry.running, {})) {
    registry.library.close(simulation, 1);
  }
}

Library Load(const char* function) {
  std::string failures;
  void* const handle = OpenLibrary(failures);
  if (handle == nullptr) {
    throw MorseError(std::string("a simulation within the program needs ") + kLibrary +
                         " beside libCCMorse, which installing CCMorse puts there; "
                         "CCMORSE_SIM_LIBRARY may name it: " +
                         failures,
                     function);
  }
  Library library;
  if (!Find(handle, "ccmorse_sim_abi", library.abi) || library.abi() != CCMORSE_SIM_ABI ||
      !Find(handle, "ccmorse_sim_open", library.open) ||
      !Find(handle, "ccmorse_sim_connect", library.connect) ||
      !Find(handle, "ccmorse_sim_close", library.close)) {
    Dl_info info{};
    const bool known =
        library.abi != nullptr && ::dladdr(reinterpret_cast<const void*>(library.abi), &info) != 0;
    throw MorseError(
        (known ? std::string(info.dli_fname) : std::string("what was opened as ") + kLibrary) +
            " is of another version than libCCMorse; install both from one CCMorse",
        function);
  }
  return library;
}

void Keep(void* context, const char* text) { *static_cast<std::string*>(context) = text; }

}  // namespace

std::shared_ptr<InProcess> InProcess::Open(const std::string& simulation, const char* function) {
  LiveSimulations& registry = TheLiveSimulations();
  const std::lock_guard lock(registry.mutex);
  std::weak_ptr<InProcess>& known = registry.simulations[simulation];
  if (std::shared_ptr<InProcess> running = known.lock()) return running;
  if (registry.library.open == nullptr) registry.library = Load(function);
  std::string why;
  CcmorseSim* const opened = registry.library.open(simulation.c_str(), Keep, &why);
  if (opened == nullptr) {
    registry.simulations.erase(simulation);
    throw MorseError(why, function);
  }
  registry.running.insert(opened);
  // Each time anew, behind what the library has made by now: what is registered last is called
  // first.
  std::atexit(EndAll);
  auto made = std::make_shared<InProcess>(opened);
  known = made;
  return made;
}

InProcess::~InProcess() {
  LiveSimulations& registry = TheLiveSimulations();
  const std::lock_guard lock(registry.mutex);
  if (registry.running.erase(simulation_) > 0) registry.library.close(simulation_, 0);
}

int InProcess::Connect(const std::string& protocol, const std::string& robot,
                       const char* function) {
  LiveSimulations& registry = TheLiveSimulations();
  const std::lock_guard lock(registry.mutex);
  if (!registry.running.contains(simulation_)) throw MorseError("the program ends", function);
  std::string why;
  const int handle =
      registry.library.connect(simulation_, protocol.c_str(), robot.c_str(), Keep, &why);
  if (handle < 0) throw MorseError(why, function);
  return handle;
}

InProcessSocket ConnectInProcess(const std::string& address, bool player, const char* function) {
  const InProcessAddress parsed = ParseInProcess(address, function);
  if (player != (parsed.protocol == "player")) {
    throw MorseError(player ? "this is for Player's protocol: add protocol=player to " + address
                            : "this is for simulators: leave protocol=player out of " + address,
                     function);
  }
  InProcessSocket socket;
  socket.simulation = InProcess::Open(parsed.simulation, function);
  socket.handle = socket.simulation->Connect(parsed.protocol, parsed.robot, function);
  return socket;
}

}  // namespace CCMorse::core
