#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "libCCMorse/Types.h"
#include "wire/fast_link.h"

namespace CCMorse::core {

/// Writes the client's frames of a fast link (docs/protocols/fast-link.md), and remembers what the
/// server knows by then: numbers of services, and the canvas as it was sent last. Knows no socket.
/// One thread at a time.
class FastLinkWriter {
 public:
  /// The numbers of a read that a device subscribes to, or kNone to end it.
  struct Subscription {
    std::uint16_t id = 0;
    ccmorse::wire::DataForm form = ccmorse::wire::DataForm::kNone;
    const std::string* device = nullptr;  ///< full name
  };

  /// Each appends to `out`, in the order of the calls.
  void Lines(std::string& out, std::string_view lines);
  void Read(std::string& out, const std::vector<Subscription>& changes);
  /// The following give false, and append nothing, when it cannot be said in a frame: then it goes
  /// as a line.
  bool Command(std::string& out, const std::string& component, const std::string& service,
               const double* numbers, std::size_t count);
  bool Image(std::string& out, const std::string& component, const std::string& service, int width,
             int height, const std::vector<Color_t>& image);
  /// Cells are collected until another call, or Finish(), needs its place behind them.
  bool Pixels(std::string& out, const std::string& component, const std::string& service,
              const PixelUpdate_t* pixels, std::size_t count);
  /// Appends the pixels that wait.
  void Finish(std::string& out);
  /// Bytes of pixels that wait, about.
  std::size_t waiting() const { return code_.size() + cells_.size(); }

  /// Component and service of a number; nullptr when it was never given.
  const std::pair<std::string, std::string>* ServiceOf(std::uint16_t id) const {
    return id < services_.size() ? &services_[id] : nullptr;
  }

 private:
  // Declares the service if need be. False: there are too many.
  bool Number(std::string& out, const std::string& component, const std::string& service,
              std::uint16_t* id);
  void AddPixel(int x, int y, Color_t color);
  void FinishRectangle();

  std::map<std::string, std::map<std::string, std::uint16_t, std::less<>>, std::less<>> numbers_;
  std::vector<std::pair<std::string, std::string>> services_;  // by number
  // The canvas as it was sent last.
  std::vector<std::uint8_t> image_;
  int width_ = 0;
  int height_ = 0;
  // Pixels that wait: whole rectangles as code, and the one that grows.
  std::size_t pixels_ = 0;  // how many
  std::uint16_t pixels_service_ = 0;
  std::string code_;
  std::vector<std::uint8_t> cells_;
  int x_ = 0;
  int y_ = 0;
  int columns_ = 0;  // 0 while the first row grows
  int count_ = 0;
};

}  // namespace CCMorse::core
