#pragma once

// Cameras and what is found in their images: proxies of libplayerc++ (specs: player.md A.4,
// player-interfaces.txt). What they share, errors and threads too, is said at ClientProxy.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "libplayerc++/clientproxy.h"

namespace PlayerCc {

/// Patches of one colour in an image.
class BlobfinderProxy : public ClientProxy {
 public:
  /// Throws PlayerError when the device cannot be subscribed.
  explicit BlobfinderProxy(PlayerClient* client, std::uint32_t index = 0);
  ~BlobfinderProxy() override;

  std::uint32_t GetCount() const;  ///< number of elements in the last data message
  /// Id,color(0x00RRGGBB),area,x,y,left,right,top,bottom px, range m.
  playerc_blobfinder_blob_t GetBlob(std::uint32_t index) const;
  std::uint32_t GetWidth() const;   ///< px
  std::uint32_t GetHeight() const;  ///< px
  /// As the getter with an index.
  playerc_blobfinder_blob_t operator[](std::uint32_t index) const;
};

/// Images of a camera.
class CameraProxy : public ClientProxy {
 public:
  /// Throws PlayerError when the device cannot be subscribed.
  explicit CameraProxy(PlayerClient* client, std::uint32_t index = 0);
  ~CameraProxy() override;

  /// Writes PREFIXnnnn.ppm with a running number.
  void SaveFrame(const std::string prefix, std::uint32_t width = 4);
  void Decompress();                         ///< JPEG -> raw in place
  std::uint32_t GetDepth() const;            ///< bits per pixel
  std::uint32_t GetWidth() const;            ///< px
  std::uint32_t GetHeight() const;           ///< px
  std::uint32_t GetFormat() const;           ///< PLAYER_CAMERA_FORMAT_*
  std::uint32_t GetImageSize() const;        ///< bytes
  void GetImage(std::uint8_t* image) const;  ///< copies into the caller buffer
  std::uint32_t GetCompression() const;      ///< 0 raw, 1 JPEG
};

/// Markers that a sensor sees.
class FiducialProxy : public ClientProxy {
 public:
  /// Throws PlayerError when the device cannot be subscribed.
  explicit FiducialProxy(PlayerClient* client, std::uint32_t index = 0);
  ~FiducialProxy() override;

  std::uint32_t GetCount() const;  ///< number of elements in the last data message
  /// Id (-1 unknown), pose and uncertainty (pose3d, sensor frame).
  player_fiducial_item_t GetFiducialItem(std::uint32_t index) const;
  player_pose3d_t GetSensorPose() const;  ///< after RequestGeometry
  player_bbox3d_t GetSensorSize() const;
  player_bbox2d_t GetFiducialSize() const;
  void RequestGeometry();
  player_fiducial_item_t operator[](std::uint32_t index) const;  ///< as the getter with an index
};

/// A pair of cameras and the points that they see.
class StereoProxy : public ClientProxy {
 public:
  /// Throws PlayerError when the device cannot be subscribed.
  explicit StereoProxy(PlayerClient* client, std::uint32_t index = 0);
  ~StereoProxy() override;

  void SaveLeftFrame(const std::string prefix, std::uint32_t width = 4);
  void SaveRightFrame(const std::string prefix, std::uint32_t width = 4);
  void SaveDisparityFrame(const std::string prefix, std::uint32_t width = 4);
  void DecompressLeft();
  void DecompressRight();
  void DecompressDisparity();
  std::uint32_t GetLeftDepth() const;
  std::uint32_t GetRightDepth() const;
  std::uint32_t GetDisparityDepth() const;
  std::uint32_t GetLeftWidth() const;
  std::uint32_t GetRightWidth() const;
  std::uint32_t GetDisparityWidth() const;
  std::uint32_t GetLeftHeight() const;
  std::uint32_t GetRightHeight() const;
  std::uint32_t GetDisparityHeight() const;
  std::uint32_t GetLeftFormat() const;
  std::uint32_t GetRightFormat() const;
  std::uint32_t GetDisparityFormat() const;
  std::uint32_t GetLeftImageSize() const;
  std::uint32_t GetRightImageSize() const;
  std::uint32_t GetDisparityImageSize() const;
  void GetLeftImage(std::uint8_t* image) const;
  void GetRightImage(std::uint8_t* image) const;
  void GetDisparityImage(std::uint8_t* image) const;
  std::uint32_t GetLeftCompression() const;
  std::uint32_t GetRightCompression() const;
  std::uint32_t GetDisparityCompression() const;
  std::uint32_t GetCount() const;  ///< number of elements in the last data message
  player_pointcloud3d_stereo_element_t GetPoint(std::uint32_t index) const;
  /// As the getter with an index.
  player_pointcloud3d_stereo_element_t operator[](std::uint32_t index) const;
};

}  // namespace PlayerCc
