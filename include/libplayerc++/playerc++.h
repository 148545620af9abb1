#pragma once

// libplayerc++, Player's client library (specs: player.md A): a program includes this and nothing
// else. Programs rely on the standard headers that come with it.

#include <unistd.h>

#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <list>
#include <string>
#include <vector>

#include "libplayerc++/clientproxy.h"
#include "libplayerc++/graphics.h"
#include "libplayerc++/io.h"
#include "libplayerc++/motion.h"
#include "libplayerc++/navigation.h"
#include "libplayerc++/operators.h"
#include "libplayerc++/playerc++config.h"
#include "libplayerc++/playerclient.h"
#include "libplayerc++/playererror.h"
#include "libplayerc++/ranging.h"
#include "libplayerc++/utility.h"
#include "libplayerc++/vision.h"
#include "libplayerc/playerc.h"
#include "libplayerinterface/interface_util.h"
