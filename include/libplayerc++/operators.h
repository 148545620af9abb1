#pragma once

// How Player's values and proxies print themselves (specs: player.md A.1). Any thread.

#include <ostream>

#include "libplayerc++/graphics.h"
#include "libplayerc++/io.h"
#include "libplayerc++/motion.h"
#include "libplayerc++/navigation.h"
#include "libplayerc++/ranging.h"
#include "libplayerc++/vision.h"

namespace std {

// Values: the fields in their order, "px, py".
ostream& operator<<(ostream& out, const player_point_2d_t& value);
ostream& operator<<(ostream& out, const player_pose2d_t& value);
ostream& operator<<(ostream& out, const player_pose3d_t& value);
ostream& operator<<(ostream& out, const player_bbox2d_t& value);
ostream& operator<<(ostream& out, const player_bbox3d_t& value);
ostream& operator<<(ostream& out, const player_segment_t& value);
ostream& operator<<(ostream& out, const player_extent2d_t& value);
ostream& operator<<(ostream& out, const playerc_device_info_t& value);

// Proxies: "#Name (code:index)", a line that names the columns, the values.
ostream& operator<<(ostream& out, const PlayerCc::ActArrayProxy& proxy);
ostream& operator<<(ostream& out, const PlayerCc::AioProxy& proxy);
ostream& operator<<(ostream& out, const PlayerCc::AudioProxy& proxy);
ostream& operator<<(ostream& out, const PlayerCc::BlobfinderProxy& proxy);
ostream& operator<<(ostream& out, const PlayerCc::BumperProxy& proxy);
ostream& operator<<(ostream& out, const PlayerCc::CameraProxy& proxy);
ostream& operator<<(ostream& out, const PlayerCc::CoopObjectProxy& proxy);
ostream& operator<<(ostream& out, const PlayerCc::DioProxy& proxy);
ostream& operator<<(ostream& out, const PlayerCc::FiducialProxy& proxy);
ostream& operator<<(ostream& out, const PlayerCc::GpsProxy& proxy);
ostream& operator<<(ostream& out, const PlayerCc::GripperProxy& proxy);
ostream& operator<<(ostream& out, const PlayerCc::ImuProxy& proxy);
ostream& operator<<(ostream& out, const PlayerCc::IrProxy& proxy);
ostream& operator<<(ostream& out, const PlayerCc::LaserProxy& proxy);
ostream& operator<<(ostream& out, const PlayerCc::LimbProxy& proxy);
ostream& operator<<(ostream& out, const PlayerCc::LinuxjoystickProxy& proxy);
ostream& operator<<(ostream& out, const PlayerCc::LocalizeProxy& proxy);
ostream& operator<<(ostream& out, const PlayerCc::LogProxy& proxy);
ostream& operator<<(ostream& out, const PlayerCc::MapProxy& proxy);
ostream& operator<<(ostream& out, const PlayerCc::OpaqueProxy& proxy);
ostream& operator<<(ostream& out, const PlayerCc::PlannerProxy& proxy);
ostream& operator<<(ostream& out, const PlayerCc::Position1dProxy& proxy);
ostream& operator<<(ostream& out, const PlayerCc::Position2dProxy& proxy);
ostream& operator<<(ostream& out, const PlayerCc::Position3dProxy& proxy);
ostream& operator<<(ostream& out, const PlayerCc::PowerProxy& proxy);
ostream& operator<<(ostream& out, const PlayerCc::PtzProxy& proxy);
ostream& operator<<(ostream& out, const PlayerCc::RangerProxy& proxy);
ostream& operator<<(ostream& out, const PlayerCc::SimulationProxy& proxy);
ostream& operator<<(ostream& out, const PlayerCc::SonarProxy& proxy);
ostream& operator<<(ostream& out, const PlayerCc::SpeechProxy& proxy);
ostream& operator<<(ostream& out, const PlayerCc::SpeechRecognitionProxy& proxy);
ostream& operator<<(ostream& out, const PlayerCc::StereoProxy& proxy);
ostream& operator<<(ostream& out, const PlayerCc::VectorMapProxy& proxy);
ostream& operator<<(ostream& out, const PlayerCc::WiFiProxy& proxy);
ostream& operator<<(ostream& out, const PlayerCc::RFIDProxy& proxy);
ostream& operator<<(ostream& out, const PlayerCc::WSNProxy& proxy);

}  // namespace std
