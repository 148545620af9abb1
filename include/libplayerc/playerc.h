#pragma once

// The names of Player's C client library that programs in C++ reach (specs: player.md A.1). The C
// functions themselves are no part of CCMorse.

#include <cstdint>

#include "libplayercommon/error.h"
#include "libplayercore/playercommon.h"
#include "libplayerinterface/interface_util.h"
#include "libplayerinterface/player.h"

// NOLINTBEGIN(modernize-use-using,cppcoreguidelines-macro-usage,modernize-macro-to-enum)

#define PLAYERC_OPEN_MODE PLAYER_OPEN_MODE
#define PLAYERC_CLOSE_MODE PLAYER_CLOSE_MODE
#define PLAYERC_ERROR_MODE PLAYER_ERROR_MODE

#define PLAYERC_DATAMODE_PUSH PLAYER_DATAMODE_PUSH
#define PLAYERC_DATAMODE_PULL PLAYER_DATAMODE_PULL

#define PLAYERC_TRANSPORT_TCP 1
#define PLAYERC_TRANSPORT_UDP 2

/// An entry of PlayerClient::GetDeviceList().
typedef struct playerc_device_info {
  player_devaddr_t addr;  ///< how a proxy names the device
  char drivername[PLAYER_MAX_DRIVER_STRING_LEN];
} playerc_device_info_t;

typedef player_blobfinder_blob_t playerc_blobfinder_blob_t;

/// A tag that an RFID reader sees; `guid` belongs to the proxy and holds until its next data.
typedef struct playerc_rfidtag {
  std::uint32_t type;
  std::uint32_t guid_count;
  std::uint8_t* guid;
} playerc_rfidtag_t;

/// A wireless link; texts end with a NUL.
typedef struct playerc_wifi_link {
  char mac[32];
  char ip[32];
  char essid[32];
  int mode;
  int encrypt;
  double freq;  ///< MHz
  int qual;
  int level;
  int noise;
} playerc_wifi_link_t;

/// What BlackBoardProxy hands to its event handler; it names the device only.
typedef struct playerc_blackboard {
  player_devaddr_t addr;
} playerc_blackboard_t;

// NOLINTEND(modernize-use-using,cppcoreguidelines-macro-usage,modernize-macro-to-enum)
