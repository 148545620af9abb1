#include "libplayerc++/operators.h"

#include <string>

#include "libplayerc++/playererror.h"
#include "libplayerc++/utility.h"

namespace {

// "#Name (code:index)", the first line of a proxy.
std::ostream& Title(std::ostream& out, const char* name, const PlayerCc::ClientProxy& proxy) {
  return out << "#" << name << " (" << proxy.GetInterface() << ":" << proxy.GetIndex() << ")\n";
}

}  // namespace

namespace std {

// NOLINTBEGIN(cert-dcl58-cpp): Player's programs find its operators in std

ostream& operator<<(ostream& out, const PlayerCc::PlayerClient& client) {
  return out << client.GetHostname() << ": " << client.GetPort();
}

ostream& operator<<(ostream& out, const PlayerCc::PlayerError& error) {
  return out << error.GetErrorFun() << "(" << error.GetErrorCode() << ") : " << error.GetErrorStr();
}

ostream& operator<<(ostream& out, const PlayerCc::ClientProxy& proxy) {
  return out << proxy.GetDriverName() << ": " << proxy.GetInterfaceStr() << "(" << proxy.GetIndex()
             << ")";
}

ostream& operator<<(ostream& out, const player_point_2d_t& value) {
  return out << value.px << ", " << value.py;
}

ostream& operator<<(ostream& out, const player_pose2d_t& value) {
  return out << value.px << ", " << value.py << ", " << value.pa;
}

ostream& operator<<(ostream& out, const player_pose3d_t& value) {
  return out << value.px << ", " << value.py << ", " << value.pz << ", " << value.proll << ", "
             << value.ppitch << ", " << value.pyaw;
}

ostream& operator<<(ostream& out, const player_bbox2d_t& value) {
  return out << value.sw << ", " << value.sl;
}

ostream& operator<<(ostream& out, const player_bbox3d_t& value) {
  return out << value.sw << ", " << value.sl << ", " << value.sh;
}

ostream& operator<<(ostream& out, const player_segment_t& value) {
  return out << "(" << value.x0 << ", " << value.y0 << ")->(" << value.x1 << ", " << value.y1
             << ")";
}

ostream& operator<<(ostream& out, const player_extent2d_t& value) {
  return out << "(" << value.x0 << ", " << value.y0 << ")->(" << value.x1 << ", " << value.y1
             << ")";
}

ostream& operator<<(ostream& out, const playerc_device_info_t& value) {
  return out << value.addr.interf << "(" << interf_to_str(value.addr.interf) << ")"
             << ":" << value.addr.index << "(" << value.drivername << ")";
}

ostream& operator<<(ostream& out, const PlayerCc::ActArrayProxy& proxy) {
  Title(out, "ActArray", proxy) << "#joint\tposition\tspeed\tstate\n";
  for (std::uint32_t i = 0; i < proxy.GetCount(); ++i) {
    const player_actarray_actuator_t each = proxy.GetActuatorData(i);
    out << i << "\t" << each.position << "\t" << each.speed << "\t" << int{each.state} << "\n";
  }
  return out;
}

ostream& operator<<(ostream& out, const PlayerCc::AioProxy& proxy) {
  Title(out, "Aio", proxy);
  for (std::uint32_t i = 0; i < proxy.GetCount(); ++i) out << proxy.GetVoltage(i) << " ";
  return out << "\n";
}

ostream& operator<<(ostream& out, const PlayerCc::AudioProxy& proxy) {
  Title(out, "Audio", proxy) << "#state\tchannels\ttones\twav bytes\n";
  return out << proxy.GetState() << "\t" << proxy.GetChannelCount() << "\t" << proxy.GetSeqCount()
             << "\t" << proxy.GetWavDataLength() << "\n";
}

ostream& operator<<(ostream& out, const PlayerCc::BlobfinderProxy& proxy) {
  Title(out, "Blobfinder", proxy) << "#" << proxy.GetWidth() << "x" << proxy.GetHeight() << "\n"
                                  << "#id\tcolor\tarea\tx\ty\tleft\tright\ttop\tbottom\trange\n";
  for (std::uint32_t i = 0; i < proxy.GetCount(); ++i) {
    const playerc_blobfinder_blob_t blob = proxy.GetBlob(i);
    out << blob.id << "\t" << blob.color << "\t" << blob.area << "\t" << blob.x << "\t" << blob.y
        << "\t" << blob.left << "\t" << blob.right << "\t" << blob.top << "\t" << blob.bottom
        << "\t" << blob.range << "\n";
  }
  return out;
}

ostream& operator<<(ostream& out, const PlayerCc::BumperProxy& proxy) {
  Title(out, "Bumper", proxy);
  for (std::uint32_t i = 0; i < proxy.GetCount(); ++i) out << proxy.IsBumped(i) << " ";
  return out << "\n";
}

ostream& operator<<(ostream& out, const PlayerCc::CameraProxy& proxy) {
  Title(out, "Camera", proxy) << "#width\theight\tdepth\tformat\tcompression\tbytes\n";
  return out << proxy.GetWidth() << "\t" << proxy.GetHeight() << "\t" << proxy.GetDepth() << "\t"
             << proxy.GetFormat() << "\t" << proxy.GetCompression() << "\t" << proxy.GetImageSize()
             << "\n";
}

ostream& operator<<(ostream& out, const PlayerCc::CoopObjectProxy& proxy) {
  Title(out, "CoopObject", proxy) << "#type\torigin\tid\tparent\n";
  return out << proxy.MessageType() << "\t" << proxy.GetOrigin() << "\t" << proxy.GetID() << "\t"
             << proxy.GetParentID() << "\n";
}

ostream& operator<<(ostream& out, const PlayerCc::DioProxy& proxy) {
  Title(out, "Dio", proxy);
  for (std::uint32_t i = 0; i < proxy.GetCount(); ++i) out << proxy.GetInput(i) << " ";
  return out << "\n";
}

ostream& operator<<(ostream& out, const PlayerCc::FiducialProxy& proxy) {
  Title(out, "Fiducial", proxy) << "#id\tpose\n";
  for (std::uint32_t i = 0; i < proxy.GetCount(); ++i) {
    const player_fiducial_item_t item = proxy.GetFiducialItem(i);
    out << item.id << "\t" << item.pose << "\n";
  }
  return out;
}

ostream& operator<<(ostream& out, const PlayerCc::GpsProxy& proxy) {
  Title(out, "GPS", proxy)
      << "#time\tlatitude\tlongitude\taltitude\tsatellites\tquality\thdop\tvdop"
         "\terror\n";
  return out << proxy.GetTime() << "\t" << proxy.GetLatitude() << "\t" << proxy.GetLongitude()
             << "\t" << proxy.GetAltitude() << "\t" << proxy.GetSatellites() << "\t"
             << proxy.GetQuality() << "\t" << proxy.GetHdop() << "\t" << proxy.GetVdop() << "\t"
             << proxy.GetErrHorizontal() << "\n";
}

ostream& operator<<(ostream& out, const PlayerCc::GripperProxy& proxy) {
  Title(out, "Gripper", proxy) << "#state\tbeams\tstored\n";
  return out << proxy.GetState() << "\t" << proxy.GetBeams() << "\t" << proxy.GetStored() << "\n";
}

ostream& operator<<(ostream& out, const PlayerCc::ImuProxy& proxy) {
  const player_imu_data_calib_t raw = proxy.GetRawValues();
  Title(out, "Imu", proxy) << "#pose; acceleration; turn rates; magnetic field\n";
  return out << proxy.GetPose() << "; " << raw.accel_x << ", " << raw.accel_y << ", " << raw.accel_z
             << "; " << raw.gyro_x << ", " << raw.gyro_y << ", " << raw.gyro_z << "; " << raw.magn_x
             << ", " << raw.magn_y << ", " << raw.magn_z << "\n";
}

ostream& operator<<(ostream& out, const PlayerCc::IrProxy& proxy) {
  Title(out, "IR", proxy);
  for (std::uint32_t i = 0; i < proxy.GetCount(); ++i) {
    out << i << ": " << proxy.GetRange(i) << "\n";
  }
  return out;
}

ostream& operator<<(ostream& out, const PlayerCc::LaserProxy& proxy) {
  const std::uint32_t count = proxy.GetCount();
  Title(out, "Laser", proxy) << "#min\tmax\tres\tcount\trange_res\n"
                             << PlayerCc::rtod(proxy.GetMinAngle()) << "\t"
                             << PlayerCc::rtod(proxy.GetMaxAngle()) << "\t"
                             << PlayerCc::rtod(proxy.GetScanRes()) << "\t" << count << "\t"
                             << proxy.GetRangeRes() << "\n"
                             << "#range\tbearing\tintensity\n";
  try {
    for (std::uint32_t i = 0; i < count; ++i) {
      out << proxy.GetRange(i) << "\t" << PlayerCc::rtod(proxy.GetBearing(i)) << "\t"
          << proxy.GetIntensity(i) << "\t";
    }
  } catch (const PlayerCc::PlayerError&) {
    // A shorter scan came meanwhile: what was printed stands.
  }
  return out << "\n";
}

ostream& operator<<(ostream& out, const PlayerCc::LimbProxy& proxy) {
  const player_limb_data_t data = proxy.GetData();
  Title(out, "Limb", proxy) << "#position; approach; orientation; state\n";
  return out << data.position.px << ", " << data.position.py << ", " << data.position.pz << "; "
             << data.approach.px << ", " << data.approach.py << ", " << data.approach.pz << "; "
             << data.orientation.px << ", " << data.orientation.py << ", " << data.orientation.pz
             << "; " << int{data.state} << "\n";
}

ostream& operator<<(ostream& out, const PlayerCc::LinuxjoystickProxy& proxy) {
  Title(out, "Joystick", proxy) << "#buttons; axes\n" << proxy.GetButtons() << ";";
  for (std::uint32_t i = 0; i < proxy.GetAxesCount(); ++i) out << " " << proxy.GetAxes(i);
  return out << "\n";
}

ostream& operator<<(ostream& out, const PlayerCc::LocalizeProxy& proxy) {
  Title(out, "Localize", proxy) << "#hypothesis; weight\n";
  for (std::uint32_t i = 0; i < proxy.GetHypothCount(); ++i) {
    const player_localize_hypoth_t hypoth = proxy.GetHypoth(i);
    out << hypoth.mean << "; " << hypoth.alpha << "\n";
  }
  return out;
}

ostream& operator<<(ostream& out, const PlayerCc::LogProxy& proxy) {
  return Title(out, "Log", proxy) << "#type\tstate\n"
                                  << proxy.GetType() << "\t" << proxy.GetState() << "\n";
}

ostream& operator<<(ostream& out, const PlayerCc::MapProxy& proxy) {
  Title(out, "Map", proxy) << "#width\theight\tresolution\torigin\n";
  return out << proxy.GetWidth() << "\t" << proxy.GetHeight() << "\t" << proxy.GetResolution()
             << "\t" << proxy.GetOriginX() << ", " << proxy.GetOriginY() << "\n";
}

ostream& operator<<(ostream& out, const PlayerCc::OpaqueProxy& proxy) {
  return Title(out, "Opaque", proxy) << "#bytes\n" << proxy.GetCount() << "\n";
}

ostream& operator<<(ostream& out, const PlayerCc::PlannerProxy& proxy) {
  Title(out, "Planner", proxy) << "#valid\tdone\tpose; goal; waypoint; its number\n";
  return out << proxy.GetPathValid() << "\t" << proxy.GetPathDone() << "\t" << proxy.GetPose()
             << "; " << proxy.GetGoal() << "; " << proxy.GetCurrentWaypoint() << "; "
             << proxy.GetCurrentWaypointId() << "\n";
}

ostream& operator<<(ostream& out, const PlayerCc::Position1dProxy& proxy) {
  Title(out, "Position1D", proxy) << "#pos\tvel\tstall\tstatus\n";
  return out << proxy.GetPos() << " " << proxy.GetVel() << " " << proxy.GetStall() << " "
             << int{proxy.GetStatus()} << "\n";
}

ostream& operator<<(ostream& out, const PlayerCc::Position2dProxy& proxy) {
  Title(out, "Position2D", proxy) << "#xpos\typos\ttheta\tspeed\tsidespeed\tturn\tstall\n";
  return out << proxy.GetXPos() << " " << proxy.GetYPos() << " " << proxy.GetYaw() << " "
             << proxy.GetXSpeed() << " " << proxy.GetYSpeed() << " " << proxy.GetYawSpeed() << " "
             << proxy.GetStall() << "\n";
}

ostream& operator<<(ostream& out, const PlayerCc::Position3dProxy& proxy) {
  Title(out, "Position3D", proxy) << "#x\ty\tz\troll\tpitch\tyaw\tstall\n";
  return out << proxy.GetXPos() << " " << proxy.GetYPos() << " " << proxy.GetZPos() << " "
             << proxy.GetRoll() << " " << proxy.GetPitch() << " " << proxy.GetYaw() << " "
             << proxy.GetStall() << "\n";
}

ostream& operator<<(ostream& out, const PlayerCc::PowerProxy& proxy) {
  Title(out, "Power", proxy) << "#volts\tpercent\tjoules\twatts\tcharging\n";
  return out << proxy.GetCharge() << "\t" << proxy.GetPercent() << "\t" << proxy.GetJoules() << "\t"
             << proxy.GetWatts() << "\t" << proxy.GetCharging() << "\n";
}

ostream& operator<<(ostream& out, const PlayerCc::PtzProxy& proxy) {
  Title(out, "Ptz", proxy) << "#pan\ttilt\tzoom\n";
  return out << proxy.GetPan() << "\t" << proxy.GetTilt() << "\t" << proxy.GetZoom() << "\n";
}

ostream& operator<<(ostream& out, const PlayerCc::RangerProxy& proxy) {
  Title(out, "Ranger", proxy);
  out << "Device pose: (" << proxy.GetDevicePose() << "), size: (" << proxy.GetDeviceSize()
      << ")\n";
  for (std::uint32_t i = 0; i < proxy.GetElementCount(); ++i) {
    out << "  Element " << i << " pose: (" << proxy.GetElementPose(i) << "), size: ("
        << proxy.GetElementSize(i) << ")\n";
  }
  out << "Min/max angle: " << proxy.GetMinAngle() << "/" << proxy.GetMaxAngle()
      << ", resolution: " << proxy.GetAngularRes() << "\nMin/max range: " << proxy.GetMinRange()
      << "/" << proxy.GetMaxRange() << ", resolution: " << proxy.GetRangeRes()
      << ", frequency: " << proxy.GetFrequency() << "\n";
  const auto list = [&](const char* name, std::uint32_t count, const auto& value) {
    out << count << " " << name << ":\n  [";
    for (std::uint32_t i = 0; i < count; ++i) out << (i == 0 ? "" : ", ") << value(i);
    out << "]\n";
  };
  try {
    list("ranges", proxy.GetRangeCount(), [&](std::uint32_t i) { return proxy.GetRange(i); });
    if (proxy.GetIntensityCount() > 0) {
      list("intensities", proxy.GetIntensityCount(),
           [&](std::uint32_t i) { return proxy.GetIntensity(i); });
    }
  } catch (const PlayerCc::PlayerError&) {
    // Fewer readings came meanwhile: what was printed stands.
  }
  return out;
}

ostream& operator<<(ostream& out, const PlayerCc::SimulationProxy& proxy) {
  return Title(out, "Simulation", proxy);
}

ostream& operator<<(ostream& out, const PlayerCc::SonarProxy& proxy) {
  Title(out, "Sonar", proxy);
  for (std::uint32_t i = 0; i < proxy.GetCount(); ++i) {
    out << i << ": " << proxy.GetScan(i) << "\n";
  }
  return out;
}

ostream& operator<<(ostream& out, const PlayerCc::SpeechProxy& proxy) {
  return Title(out, "Speech", proxy);
}

ostream& operator<<(ostream& out, const PlayerCc::SpeechRecognitionProxy& proxy) {
  Title(out, "SpeechRecognition", proxy);
  for (std::uint32_t i = 0; i < proxy.GetCount(); ++i) out << proxy.GetWord(i) << " ";
  return out << "\n";
}

ostream& operator<<(ostream& out, const PlayerCc::StereoProxy& proxy) {
  Title(out, "Stereo", proxy) << "#left; right; disparity; points\n";
  return out << proxy.GetLeftWidth() << "x" << proxy.GetLeftHeight() << "; "
             << proxy.GetRightWidth() << "x" << proxy.GetRightHeight() << "; "
             << proxy.GetDisparityWidth() << "x" << proxy.GetDisparityHeight() << "; "
             << proxy.GetCount() << "\n";
}

ostream& operator<<(ostream& out, const PlayerCc::VectorMapProxy& proxy) {
  Title(out, "VectorMap", proxy) << "#layer\tfeatures\n";
  const std::vector<std::string> names = proxy.GetLayerNames();
  for (std::size_t i = 0; i < names.size(); ++i) {
    out << names[i] << "\t" << proxy.GetFeatureCount(static_cast<unsigned int>(i)) << "\n";
  }
  return out;
}

ostream& operator<<(ostream& out, const PlayerCc::WiFiProxy& proxy) {
  Title(out, "WiFi", proxy) << "#essid\tmac\tip\tquality\tlevel\tnoise\n";
  for (int i = 0; i < proxy.GetLinkCount(); ++i) {
    out << proxy.GetLinkESSID(i) << "\t" << proxy.GetLinkMAC(i) << "\t" << proxy.GetLinkIP(i)
        << "\t" << proxy.GetLinkQuality(i) << "\t" << proxy.GetLinkLevel(i) << "\t"
        << proxy.GetLinkNoise(i) << "\n";
  }
  return out;
}

ostream& operator<<(ostream& out, const PlayerCc::RFIDProxy& proxy) {
  Title(out, "RFID", proxy) << "#type\tbytes\n";
  for (std::uint32_t i = 0; i < proxy.GetTagsCount(); ++i) {
    const playerc_rfidtag_t tag = proxy.GetRFIDTag(i);
    out << tag.type << "\t" << tag.guid_count << "\n";
  }
  return out;
}

ostream& operator<<(ostream& out, const PlayerCc::WSNProxy& proxy) {
  const player_wsn_node_data_t data = proxy.GetNodeDataPacket();
  Title(out, "WSN", proxy) << "#type\tid\tparent\ttemperature\tbattery\n";
  return out << proxy.GetNodeType() << "\t" << proxy.GetNodeID() << "\t" << proxy.GetNodeParentID()
             << "\t" << data.temperature << "\t" << data.battery << "\n";
}

// NOLINTEND(cert-dcl58-cpp)

}  // namespace std
