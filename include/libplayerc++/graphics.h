#pragma once

// The simulation and drawing in it: proxies of libplayerc++ (specs: player.md A.4,
// player-interfaces.txt). What they share, errors and threads too, is said at ClientProxy.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "libplayerc++/clientproxy.h"

namespace PlayerCc {

/// Drawing in the simulation, in the plane. Nothing is read.
class Graphics2dProxy : public ClientProxy {
 public:
  /// Throws PlayerError when the device cannot be subscribed.
  explicit Graphics2dProxy(PlayerClient* client, std::uint32_t index = 0);
  ~Graphics2dProxy() override;

  void Color(player_color_t col);  ///< sets the local pen (RGBA bytes); sent with each primitive
  /// Sets the local pen (RGBA bytes); sent with each primitive.
  void Color(std::uint8_t red, std::uint8_t green, std::uint8_t blue, std::uint8_t alpha);
  void Clear();  ///< erase everything this client drew
  /// Points in m, in the frame of the attached model (world if attached to the simulation).
  void DrawPoints(player_point_2d_t pts[], int count);
  /// Filled flag + fill colour.
  void DrawPolygon(player_point_2d_t pts[], int count, bool filled, player_color_t fill_color);
  void DrawPolyline(player_point_2d_t pts[], int count);
  /// Independent segments from point pairs.
  void DrawMultiline(player_point_2d_t pts[], int count);
};

/// Drawing in the simulation, in space. Nothing is read.
class Graphics3dProxy : public ClientProxy {
 public:
  /// Throws PlayerError when the device cannot be subscribed.
  explicit Graphics3dProxy(PlayerClient* client, std::uint32_t index = 0);
  ~Graphics3dProxy() override;

  void Color(player_color_t col);  ///< local pen
  /// Local pen.
  void Color(std::uint8_t red, std::uint8_t green, std::uint8_t blue, std::uint8_t alpha);
  void Clear();
  /// Mode = points, lines, line strip, line loop, triangles, strip, fan, quads, quad strip,
  /// polygon.
  void Draw(player_graphics3d_draw_mode_t mode, player_point_3d_t pts[], int count);
};

/// The simulation itself. Refused requests are printed to standard error and throw nothing, as in
/// Player.
class SimulationProxy : public ClientProxy {
 public:
  /// Throws PlayerError when the device cannot be subscribed.
  explicit SimulationProxy(PlayerClient* client, std::uint32_t index = 0);
  ~SimulationProxy() override;

  /// Model name (char*), m, m, rad; errors only printed.
  void SetPose2d(char* identifier, double x, double y, double a);
  void SetPose2d(const char* identifier, double x, double y, double a);
  /// Fills the references; on NACK they keep their value and only a message is printed.
  void GetPose2d(char* identifier, double& x, double& y, double& a);
  void GetPose2d(const char* identifier, double& x, double& y, double& a);
  /// M and rad.
  void SetPose3d(char* identifier, double x, double y, double z, double roll, double pitch,
                 double yaw);
  void SetPose3d(const char* identifier, double x, double y, double z, double roll, double pitch,
                 double yaw);
  /// Plus simulation time s.
  void GetPose3d(char* identifier, double& x, double& y, double& z, double& roll, double& pitch,
                 double& yaw, double& time);
  void GetPose3d(const char* identifier, double& x, double& y, double& z, double& roll,
                 double& pitch, double& yaw, double& time);
  /// Raw bytes of a named property; length must match.
  void GetProperty(char* identifier, char* name, void* value, std::size_t value_len);
  void GetProperty(const char* identifier, const char* name, void* value, std::size_t value_len);
  /// Raw bytes.
  void SetProperty(char* identifier, char* name, void* value, std::size_t value_len);
  void SetProperty(const char* identifier, const char* name, void* value, std::size_t value_len);
};

}  // namespace PlayerCc
