#include "libplayerc++/vision.h"

#include <algorithm>
#include <cstdio>
#include <cstring>

#include "client/player/proxy_state.h"

namespace PlayerCc {

namespace {

using BlobfinderState = SimpleState<wire::BlobfinderData, PLAYER_BLOBFINDER_DATA_BLOBS>;

class CameraState : public SimpleState<wire::CameraData, PLAYER_CAMERA_DATA_STATE> {
 public:
  int frame = 0;  // number of the next file
};

class FiducialState : public SimpleState<wire::FiducialData, PLAYER_FIDUCIAL_DATA_SCAN> {
 public:
  wire::FiducialGeom geom;
};

class StereoState : public SimpleState<wire::StereoData, PLAYER_STEREO_DATA_STATE> {
 public:
  int frame = 0;
};

std::uint32_t Size(const wire::CameraData& image) {
  return static_cast<std::uint32_t>(image.image.size());
}

void Copy(const wire::CameraData& image, std::uint8_t* to) {
  if (!image.image.empty()) std::memcpy(to, image.image.data(), image.image.size());
}

// A pixel of a raw image as red, green, blue.
void AppendPixel(const wire::CameraData& image, std::size_t pixel, std::vector<std::uint8_t>& out) {
  const std::vector<std::uint8_t>& bytes = image.image;
  const auto word = [&] {  // two bytes, the lower first
    return static_cast<unsigned>(bytes[2 * pixel] | bytes[2 * pixel + 1] << 8);
  };
  switch (image.format) {
    case PLAYER_CAMERA_FORMAT_MONO8:
      out.insert(out.end(), 3, bytes[pixel]);
      break;
    case PLAYER_CAMERA_FORMAT_MONO16:
      out.insert(out.end(), 3, static_cast<std::uint8_t>(word() >> 8U));
      break;
    case PLAYER_CAMERA_FORMAT_RGB565:
      out.push_back(static_cast<std::uint8_t>((word() >> 11U & 31U) * 255U / 31U));
      out.push_back(static_cast<std::uint8_t>((word() >> 5U & 63U) * 255U / 63U));
      out.push_back(static_cast<std::uint8_t>((word() & 31U) * 255U / 31U));
      break;
    default:
      for (std::size_t channel = 0; channel < 3; ++channel) {
        out.push_back(bytes[3 * pixel + channel]);
      }
  }
}

std::size_t BytesOfPixel(std::uint32_t format) {
  switch (format) {
    case PLAYER_CAMERA_FORMAT_MONO8:
      return 1;
    case PLAYER_CAMERA_FORMAT_MONO16:
    case PLAYER_CAMERA_FORMAT_RGB565:
      return 2;
    case PLAYER_CAMERA_FORMAT_RGB888:
      return 3;
    default:
      return 0;
  }
}

// PREFIXnnnn.ppm, or .jpg with the bytes as they came.
void Save(const wire::CameraData& image, const std::string& prefix, std::uint32_t width, int number,
          const char* function) {
  std::string digits = std::to_string(number);
  if (digits.size() < width)
    digits.insert(0, std::min<std::size_t>(width, 20) - digits.size(), '0');
  const bool jpeg = image.compression == PLAYER_CAMERA_COMPRESS_JPEG;
  const std::string name = prefix + digits + (jpeg ? ".jpg" : ".ppm");
  std::vector<std::uint8_t> bytes;
  if (jpeg) {
    bytes = image.image;
  } else {
    const std::size_t each = BytesOfPixel(image.format);
    const std::size_t pixels = std::size_t{image.width} * image.height;
    if (each == 0 || pixels > image.image.size() / each) {
      throw MorseError("there is no image, or one in a format that is not known", function);
    }
    const std::string header =
        "P6\n" + std::to_string(image.width) + " " + std::to_string(image.height) + "\n255\n";
    bytes.assign(header.begin(), header.end());
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) AppendPixel(image, pixel, bytes);
  }
  std::FILE* const file = std::fopen(name.c_str(), "wb");
  const bool written =
      file != nullptr && std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
  const bool closed = file != nullptr && std::fclose(file) == 0;
  if (!written || !closed) throw MorseError("cannot write " + name, function);
}

// JPEG needs a decoder, which the library does without: raw images only.
void RequireRaw(const wire::CameraData& image, const char* function) {
  if (image.compression != PLAYER_CAMERA_COMPRESS_RAW) {
    throw MorseError("this library has no decoder for JPEG", function);
  }
}

}  // namespace

// --- BlobfinderProxy

BlobfinderProxy::BlobfinderProxy(PlayerClient* client, std::uint32_t index)
    : ClientProxy(client, index, "BlobfinderProxy", "blobfinder",
                  std::make_shared<BlobfinderState>()) {}
BlobfinderProxy::~BlobfinderProxy() = default;

std::uint32_t BlobfinderProxy::GetCount() const { return Count(In<BlobfinderState>()->data.blobs); }
playerc_blobfinder_blob_t BlobfinderProxy::GetBlob(std::uint32_t index) const {
  const auto state = In<BlobfinderState>();
  const wire::BlobfinderBlob& blob = At(state->data.blobs, index, "BlobfinderProxy::GetBlob()");
  return {blob.id,   blob.color, blob.area, blob.x,      blob.y,
          blob.left, blob.right, blob.top,  blob.bottom, static_cast<float>(blob.range)};
}
std::uint32_t BlobfinderProxy::GetWidth() const { return In<BlobfinderState>()->data.width; }
std::uint32_t BlobfinderProxy::GetHeight() const { return In<BlobfinderState>()->data.height; }
playerc_blobfinder_blob_t BlobfinderProxy::operator[](std::uint32_t index) const {
  return GetBlob(index);
}

// --- CameraProxy

CameraProxy::CameraProxy(PlayerClient* client, std::uint32_t index)
    : ClientProxy(client, index, "CameraProxy", "camera", std::make_shared<CameraState>()) {}
CameraProxy::~CameraProxy() = default;

// NOLINTNEXTLINE(performance-unnecessary-value-param): Player's own type
void CameraProxy::SaveFrame(const std::string prefix, std::uint32_t width) {
  const auto state = In<CameraState>();
  Save(state->data, prefix, width, state->frame, "CameraProxy::SaveFrame()");
  ++state->frame;
}
void CameraProxy::Decompress() { RequireRaw(In<CameraState>()->data, "CameraProxy::Decompress()"); }
std::uint32_t CameraProxy::GetDepth() const { return In<CameraState>()->data.bpp; }
std::uint32_t CameraProxy::GetWidth() const { return In<CameraState>()->data.width; }
std::uint32_t CameraProxy::GetHeight() const { return In<CameraState>()->data.height; }
std::uint32_t CameraProxy::GetFormat() const { return In<CameraState>()->data.format; }
std::uint32_t CameraProxy::GetImageSize() const { return Size(In<CameraState>()->data); }
void CameraProxy::GetImage(std::uint8_t* image) const { Copy(In<CameraState>()->data, image); }
std::uint32_t CameraProxy::GetCompression() const { return In<CameraState>()->data.compression; }

// --- FiducialProxy

FiducialProxy::FiducialProxy(PlayerClient* client, std::uint32_t index)
    : ClientProxy(client, index, "FiducialProxy", "fiducial", std::make_shared<FiducialState>()) {}
FiducialProxy::~FiducialProxy() = default;

std::uint32_t FiducialProxy::GetCount() const { return Count(In<FiducialState>()->data.fiducials); }
player_fiducial_item_t FiducialProxy::GetFiducialItem(std::uint32_t index) const {
  const auto state = In<FiducialState>();
  const wire::FiducialItem& item =
      At(state->data.fiducials, index, "FiducialProxy::GetFiducialItem()");
  return {item.id, ToC(item.pose), ToC(item.upose)};
}
player_pose3d_t FiducialProxy::GetSensorPose() const { return ToC(In<FiducialState>()->geom.pose); }
player_bbox3d_t FiducialProxy::GetSensorSize() const { return ToC(In<FiducialState>()->geom.size); }
player_bbox2d_t FiducialProxy::GetFiducialSize() const {
  return ToC(In<FiducialState>()->geom.fiducial_size);
}
void FiducialProxy::RequestGeometry() {
  wire::FiducialGeom geom;
  Require(AskFor(*state_, PLAYER_FIDUCIAL_REQ_GET_GEOM, geom), "FiducialProxy::RequestGeometry()");
  In<FiducialState>()->geom = geom;
}
player_fiducial_item_t FiducialProxy::operator[](std::uint32_t index) const {
  return GetFiducialItem(index);
}

// --- StereoProxy

StereoProxy::StereoProxy(PlayerClient* client, std::uint32_t index)
    : ClientProxy(client, index, "StereoProxy", "stereo", std::make_shared<StereoState>()) {}
StereoProxy::~StereoProxy() = default;

// NOLINTNEXTLINE(performance-unnecessary-value-param): Player's own type
void StereoProxy::SaveLeftFrame(const std::string prefix, std::uint32_t width) {
  const auto state = In<StereoState>();
  Save(state->data.left_channel, prefix, width, state->frame, "StereoProxy::SaveLeftFrame()");
  ++state->frame;
}
void StereoProxy::DecompressLeft() {
  RequireRaw(In<StereoState>()->data.left_channel, "StereoProxy::DecompressLeft()");
}
std::uint32_t StereoProxy::GetLeftDepth() const { return In<StereoState>()->data.left_channel.bpp; }
std::uint32_t StereoProxy::GetLeftWidth() const {
  return In<StereoState>()->data.left_channel.width;
}
std::uint32_t StereoProxy::GetLeftHeight() const {
  return In<StereoState>()->data.left_channel.height;
}
std::uint32_t StereoProxy::GetLeftFormat() const {
  return In<StereoState>()->data.left_channel.format;
}
std::uint32_t StereoProxy::GetLeftImageSize() const {
  return Size(In<StereoState>()->data.left_channel);
}
void StereoProxy::GetLeftImage(std::uint8_t* image) const {
  Copy(In<StereoState>()->data.left_channel, image);
}
std::uint32_t StereoProxy::GetLeftCompression() const {
  return In<StereoState>()->data.left_channel.compression;
}
// NOLINTNEXTLINE(performance-unnecessary-value-param): Player's own type
void StereoProxy::SaveRightFrame(const std::string prefix, std::uint32_t width) {
  const auto state = In<StereoState>();
  Save(state->data.right_channel, prefix, width, state->frame, "StereoProxy::SaveRightFrame()");
  ++state->frame;
}
void StereoProxy::DecompressRight() {
  RequireRaw(In<StereoState>()->data.right_channel, "StereoProxy::DecompressRight()");
}
std::uint32_t StereoProxy::GetRightDepth() const {
  return In<StereoState>()->data.right_channel.bpp;
}
std::uint32_t StereoProxy::GetRightWidth() const {
  return In<StereoState>()->data.right_channel.width;
}
std::uint32_t StereoProxy::GetRightHeight() const {
  return In<StereoState>()->data.right_channel.height;
}
std::uint32_t StereoProxy::GetRightFormat() const {
  return In<StereoState>()->data.right_channel.format;
}
std::uint32_t StereoProxy::GetRightImageSize() const {
  return Size(In<StereoState>()->data.right_channel);
}
void StereoProxy::GetRightImage(std::uint8_t* image) const {
  Copy(In<StereoState>()->data.right_channel, image);
}
std::uint32_t StereoProxy::GetRightCompression() const {
  return In<StereoState>()->data.right_channel.compression;
}
// NOLINTNEXTLINE(performance-unnecessary-value-param): Player's own type
void StereoProxy::SaveDisparityFrame(const std::string prefix, std::uint32_t width) {
  const auto state = In<StereoState>();
  Save(state->data.disparity, prefix, width, state->frame, "StereoProxy::SaveDisparityFrame()");
  ++state->frame;
}
void StereoProxy::DecompressDisparity() {
  RequireRaw(In<StereoState>()->data.disparity, "StereoProxy::DecompressDisparity()");
}
std::uint32_t StereoProxy::GetDisparityDepth() const {
  return In<StereoState>()->data.disparity.bpp;
}
std::uint32_t StereoProxy::GetDisparityWidth() const {
  return In<StereoState>()->data.disparity.width;
}
std::uint32_t StereoProxy::GetDisparityHeight() const {
  return In<StereoState>()->data.disparity.height;
}
std::uint32_t StereoProxy::GetDisparityFormat() const {
  return In<StereoState>()->data.disparity.format;
}
std::uint32_t StereoProxy::GetDisparityImageSize() const {
  return Size(In<StereoState>()->data.disparity);
}
void StereoProxy::GetDisparityImage(std::uint8_t* image) const {
  Copy(In<StereoState>()->data.disparity, image);
}
std::uint32_t StereoProxy::GetDisparityCompression() const {
  return In<StereoState>()->data.disparity.compression;
}
std::uint32_t StereoProxy::GetCount() const { return Count(In<StereoState>()->data.points); }
player_pointcloud3d_stereo_element_t StereoProxy::GetPoint(std::uint32_t index) const {
  const auto state = In<StereoState>();
  const wire::Pointcloud3dStereoElement& point =
      At(state->data.points, index, "StereoProxy::GetPoint()");
  return {static_cast<float>(point.px),
          static_cast<float>(point.py),
          static_cast<float>(point.pz),
          point.red,
          point.green,
          point.blue};
}
player_pointcloud3d_stereo_element_t StereoProxy::operator[](std::uint32_t index) const {
  return GetPoint(index);
}

}  // namespace PlayerCc
