#include <algorithm>
#include <array>

#include "base/error.h"
#include "base/nearest_name.h"
#include "servers/player/drivers/amcl_driver.h"
#include "servers/player/drivers/driver.h"
#include "servers/player/drivers/localization.h"
#include "servers/player/drivers/log_drivers.h"
#include "servers/player/drivers/nd_driver.h"
#include "servers/player/drivers/range_converters.h"
#include "servers/player/drivers/snd_driver.h"
#include "servers/player/drivers/vfh_driver.h"
#include "servers/player/drivers/wavefront_driver.h"

namespace ccmorse::servers::player {
namespace {

struct DriverMaker {
  const char* name;
  std::unique_ptr<Driver> (*make)(const DriverDef&, const DeviceContext&, const DeviceList&);
};

template <typename Kind>
std::unique_ptr<Driver> Make(const DriverDef& def, const DeviceContext& context,
                             const DeviceList& devices) {
  return std::make_unique<Kind>(def, context, devices);
}

constexpr std::array kDriverMakers = {
    DriverMaker{"amcl", &Make<AmclDriver>},
    DriverMaker{"fakelocalize", &Make<FakeLocalize>},
    DriverMaker{"lasertoranger", &Make<LaserToRanger>},
    DriverMaker{"mapfile", &Make<MapFile>},
    DriverMaker{"nd", &Make<NdDriver>},
    DriverMaker{"rangertolaser", &Make<RangerToLaser>},
    DriverMaker{"readlog", &Make<ReadLog>},
    DriverMaker{"snd", &Make<SndDriver>},
    DriverMaker{"vfh", &Make<VfhDriver>},
    DriverMaker{"wavefront", &Make<WavefrontDriver>},
    DriverMaker{"writelog", &Make<WriteLog>},
};

}  // namespace

bool IsDriver(std::string_view name) {
  return std::any_of(kDriverMakers.begin(), kDriverMakers.end(),
                     [&](const DriverMaker& maker) { return name == maker.name; });
}

std::unique_ptr<Driver> MakeDriver(const DriverDef& def, const DeviceContext& context,
                                   const DeviceList& devices) {
  std::vector<std::string> known;
  std::string list;
  for (const DriverMaker& maker : kDriverMakers) {
    if (def.name == maker.name) return maker.make(def, context, devices);
    known.emplace_back(maker.name);
    list += (list.empty() ? "" : ", ") + known.back();
  }
  throw Error("unknown driver '" + def.name + "', known: " + list + DidYouMean(def.name, known));
}

}  // namespace ccmorse::servers::player
