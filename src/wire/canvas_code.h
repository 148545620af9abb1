#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ccmorse::wire {

/// Cells of the canvas as the fast link sends them (docs/protocols/fast-link.md): rectangles, each
/// with its cells row by row from the bottom, run-length coded. A cell is 3 bytes, red, green,
/// blue. Its own code rather than zlib's, because on one machine compressing with zlib takes ten
/// times longer than sending what it saves.
inline constexpr std::size_t kCellBytes = 3;
/// Cells that one message may stand for, however few its bytes are.
inline constexpr std::size_t kMostCells = std::size_t{1} << 20;

/// Appends what has to be changed in `base` to become `image`; both have width x height cells.
void AppendChanges(std::string& code, const std::uint8_t* base, const std::uint8_t* image,
                   int width, int height);

/// Changes `image`, of width x height cells. False when the code is none, or leads out of the
/// image; part of it may have changed then.
bool ApplyChanges(std::string_view code, std::vector<std::uint8_t>& image, int width, int height);

/// Appends one rectangle with new colours, `cells` row by row; (x, y) is its bottom-left corner,
/// anywhere. Precondition: width and height from 1 to 65535.
void AppendRectangle(std::string& code, std::int32_t x, std::int32_t y, int width, int height,
                     const std::uint8_t* cells);

/// Appends the rectangles of a code to `plain` without compression: x, y (i32), width, height
/// (u16), and 3 bytes for each cell; this is what the service update_image_data takes. False when
/// the code is none or has more than kMostCells.
bool ExpandRectangles(std::string_view code, std::string* plain);

}  // namespace ccmorse::wire
