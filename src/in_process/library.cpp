// libccmorse-sim: the simulator for a program's own process, behind wire/in_process.h.

#include <exception>
#include <memory>
#include <string_view>

#include "in_process/options.h"
#include "in_process/simulation_thread.h"
#include "wire/in_process.h"

struct CcmorseSim {
  explicit CcmorseSim(ccmorse::in_process::Options options) : thread(std::move(options)) {}
  ccmorse::in_process::SimulationThread thread;
};

namespace {

// No exception leaves the library.
template <typename Result, typename Work>
Result Guarded(Result failed, CcmorseSimTell tell, void* context, const Work& work) noexcept {
  try {
    return work();
  } catch (const std::exception& error) {
    tell(context, error.what());
  } catch (...) {
    tell(context, "the simulator failed");
  }
  return failed;
}

}  // namespace

int ccmorse_sim_abi() noexcept { return CCMORSE_SIM_ABI; }

CcmorseSim* ccmorse_sim_open(const char* text, CcmorseSimTell tell, void* context) noexcept {
  return Guarded<CcmorseSim*>(nullptr, tell, context, [&] {
    return std::make_unique<CcmorseSim>(ccmorse::in_process::ParseOptions(text)).release();
  });
}

int ccmorse_sim_connect(CcmorseSim* simulation, const char* protocol, const char* robot,
                        CcmorseSimTell tell, void* context) noexcept {
  return Guarded(-1, tell, context, [&] {
    return std::string_view(protocol) == "player" ? simulation->thread.ConnectPlayer(robot)
                                                  : simulation->thread.ConnectMorse();
  });
}

void ccmorse_sim_close(CcmorseSim* simulation, int at_once) noexcept {
  const std::unique_ptr<CcmorseSim> ended(simulation);
  const auto ignore = [](void*, const char*) {};
  Guarded(0, ignore, nullptr, [&] {
    if (at_once == 0) ended->thread.Finish();
    return 0;
  });
}
