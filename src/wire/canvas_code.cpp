#include "wire/canvas_code.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "wire/fast_link.h"

namespace ccmorse::wire {
namespace {

// A stretch of cells begins with a u16: two bits say what it is, 14 how many cells it has.
enum class Stretch : unsigned { kCells = 0, kRun = 1, kKeep = 2 };
constexpr unsigned kCountBits = 14;
constexpr std::size_t kLongest = (1U << kCountBits) - 1;
constexpr std::size_t kShortestRun = 3;   // below, a run costs as much as its cells
constexpr std::size_t kShortestKeep = 2;  // below, a stretch costs more than it saves

std::uint32_t Cell(const std::uint8_t* cells, std::size_t index) {
  const std::uint8_t* const cell = cells + index * kCellBytes;
  return cell[0] | static_cast<std::uint32_t>(cell[1]) << 8U |
         static_cast<std::uint32_t>(cell[2]) << 16U;
}

// Passes over cells that are neither as they were nor like the next one, as nearly all are in a
// picture full of detail; stops at the last cell of `count` at the latest. Reads four bytes at a
// time: the next cell is there.
std::size_t SkipLoose(const std::uint8_t* cells, const std::uint8_t* base, std::size_t at,
                      std::size_t count) {
  constexpr std::uint32_t kCell =
      std::endian::native == std::endian::little ? 0xFFFFFF : 0xFFFFFF00;
  const auto load = [](const std::uint8_t* from) {
    std::uint32_t word = 0;
    std::memcpy(&word, from, sizeof word);
    return word & kCell;
  };
  if (at + 1 >= count) return at;
  std::uint32_t cell = load(cells + at * kCellBytes);
  for (; at + 2 < count; ++at) {
    if (base != nullptr && load(base + at * kCellBytes) == cell) break;
    const std::uint32_t next = load(cells + (at + 1) * kCellBytes);
    if (next == cell) break;
    cell = next;
  }
  return at;
}

// Collects the cells of one rectangle, row by row, into stretches. A stretch may go on in the next
// row.
class StretchWriter {
 public:
  explicit StretchWriter(std::string& code) : code_(code) {}
  ~StretchWriter() { Finish(); }
  StretchWriter(const StretchWriter&) = delete;
  StretchWriter& operator=(const StretchWriter&) = delete;

  // `base` may be nullptr: then no cell is kept.
  void Row(const std::uint8_t* cells, const std::uint8_t* base, std::size_t count) {
    std::size_t written = 0;  // cells before it are in the code
    for (std::size_t at = 0; at < count;) {
      at = SkipLoose(cells, base, at, count);
      const std::uint32_t cell = Cell(cells, at);
      std::size_t same = 0;
      if (base != nullptr) {
        while (at + same < count && Cell(base, at + same) == Cell(cells, at + same)) ++same;
      }
      const std::size_t shortest_keep =
          at == written && Continues(Stretch::kKeep, 0) ? 1 : kShortestKeep;
      if (same >= shortest_keep) {
        Add(Stretch::kCells, cells + written * kCellBytes, at - written);
        Add(Stretch::kKeep, nullptr, same);
        written = at += same;
        continue;
      }
      std::size_t run = 1;
      while (at + run < count && Cell(cells, at + run) == cell) ++run;
      const std::size_t shortest_run =
          at == written && Continues(Stretch::kRun, cell) ? 1 : kShortestRun;
      if (run >= shortest_run) {
        Add(Stretch::kCells, cells + written * kCellBytes, at - written);
        Add(Stretch::kRun, cells + at * kCellBytes, run);
        written = at + run;
      }
      at += run;
    }
    Add(Stretch::kCells, cells + written * kCellBytes, count - written);
  }

 private:
  // Whether more cells of the kind, and of the colour for a run, belong to the stretch that grows.
  bool Continues(Stretch kind, std::uint32_t cell) const {
    return kind == kind_ && count_ > 0 && count_ < kLongest &&
           (kind != Stretch::kRun || cell == colour_);
  }

  void Add(Stretch kind, const std::uint8_t* cells, std::size_t count) {
    while (count > 0) {
      const std::uint32_t cell = kind == Stretch::kRun ? Cell(cells, 0) : 0;
      if (!Continues(kind, cell)) {
        Finish();
        kind_ = kind;
        colour_ = cell;
        head_ = code_.size();
        code_.append(2, '\0');
        if (kind == Stretch::kRun) {
          code_.append(reinterpret_cast<const char*>(cells), kCellBytes);
        }
      }
      const std::size_t taken = std::min(count, kLongest - count_);
      if (kind == Stretch::kCells) {
        code_.append(reinterpret_cast<const char*>(cells), taken * kCellBytes);
        cells += taken * kCellBytes;
      }
      count_ += taken;
      count -= taken;
    }
  }

  void Finish() {
    if (count_ == 0) return;
    const auto head = static_cast<unsigned>(kind_) << kCountBits | static_cast<unsigned>(count_);
    code_[head_] = static_cast<char>(head & 0xFFU);
    code_[head_ + 1] = static_cast<char>(head >> 8U);
    count_ = 0;
  }

  std::string& code_;
  Stretch kind_ = Stretch::kCells;
  std::uint32_t colour_ = 0;  // of a run
  std::size_t count_ = 0;
  std::size_t head_ = 0;  // where the stretch's head stands
};

void AppendCorners(std::string& out, std::int32_t x, std::int32_t y, int width, int height) {
  const auto append = [&out](std::uint32_t value, unsigned bytes) {
    for (unsigned i = 0; i < bytes; ++i) out += static_cast<char>(value >> (8U * i) & 0xFFU);
  };
  append(static_cast<std::uint32_t>(x), 4);
  append(static_cast<std::uint32_t>(y), 4);
  append(static_cast<std::uint32_t>(width), 2);
  append(static_cast<std::uint32_t>(height), 2);
}

struct Rectangle {
  std::int32_t x = 0;
  std::int32_t y = 0;
  std::size_t width = 0;
  std::size_t height = 0;
};

bool ReadRectangle(ByteReader& reader, Rectangle* rectangle) {
  rectangle->x = static_cast<std::int32_t>(reader.Long());
  rectangle->y = static_cast<std::int32_t>(reader.Long());
  rectangle->width = reader.Short();
  rectangle->height = reader.Short();
  return reader.ok() && rectangle->width > 0 && rectangle->height > 0;
}

// Hands the stretches that make up `cells` cells to take(kind, count, colours).
template <typename Take>
bool ReadStretches(ByteReader& reader, std::size_t cells, Take take) {
  while (cells > 0) {
    const std::uint16_t head = reader.Short();
    const std::size_t count = head & kLongest;
    const auto kind = static_cast<Stretch>(head >> kCountBits);
    if (!reader.ok() || count == 0 || count > cells || kind > Stretch::kKeep) return false;
    const std::size_t colours = kind == Stretch::kCells ? count : kind == Stretch::kRun ? 1 : 0;
    const std::string_view bytes = reader.Bytes(colours * kCellBytes);
    if (!reader.ok() || !take(kind, count, bytes)) return false;
    cells -= count;
  }
  return true;
}

}  // namespace

void AppendChanges(std::string& code, const std::uint8_t* base, const std::uint8_t* image,
                   int width, int height) {
  const std::size_t row = static_cast<std::size_t>(width) * kCellBytes;
  if (row == 0) return;
  const auto changed = [&](int y) {
    const std::size_t at = static_cast<std::size_t>(y) * row;
    return std::memcmp(base + at, image + at, row) != 0;
  };
  for (int y = 0; y < height;) {
    if (!changed(y)) {
      ++y;
      continue;
    }
    // Rows that follow each other make one rectangle, as wide as what has changed in any of them.
    int end = y;
    int first = width;
    int last = -1;
    for (; end < height && changed(end); ++end) {
      const std::uint8_t* const a = base + static_cast<std::size_t>(end) * row;
      const std::uint8_t* const b = image + static_cast<std::size_t>(end) * row;
      const auto same = [&](int x) {
        return Cell(a, static_cast<std::size_t>(x)) == Cell(b, static_cast<std::size_t>(x));
      };
      int from = 0;
      while (from < first && same(from)) ++from;
      first = from;
      int to = width - 1;
      while (to > last && same(to)) --to;
      last = to;
    }
    const int columns = last - first + 1;
    AppendCorners(code, first, y, columns, end - y);
    StretchWriter writer(code);
    for (int r = y; r < end; ++r) {
      const std::size_t at =
          static_cast<std::size_t>(r) * row + static_cast<std::size_t>(first) * kCellBytes;
      writer.Row(image + at, base + at, static_cast<std::size_t>(columns));
    }
    y = end;
  }
}

bool ApplyChanges(std::string_view code, std::vector<std::uint8_t>& image, int width, int height) {
  ByteReader reader(code);
  const auto across = static_cast<std::size_t>(width);
  while (!reader.rest().empty()) {
    Rectangle rectangle;
    if (!ReadRectangle(reader, &rectangle) || rectangle.x < 0 || rectangle.y < 0 ||
        rectangle.x + static_cast<std::int64_t>(rectangle.width) > width ||
        rectangle.y + static_cast<std::int64_t>(rectangle.height) > height) {
      return false;
    }
    std::size_t column = 0;
    std::size_t row =
        static_cast<std::size_t>(rectangle.y) * across + static_cast<std::size_t>(rectangle.x);
    const auto take = [&](Stretch kind, std::size_t count, std::string_view colours) {
      while (count > 0) {
        const std::size_t here = std::min(count, rectangle.width - column);
        std::uint8_t* const to = image.data() + (row + column) * kCellBytes;
        if (kind == Stretch::kCells) {
          std::memcpy(to, colours.data(), here * kCellBytes);
          colours.remove_prefix(here * kCellBytes);
        } else if (kind == Stretch::kRun) {
          for (std::size_t i = 0; i < here; ++i) {
            std::memcpy(to + i * kCellBytes, colours.data(), kCellBytes);
          }
        }
        count -= here;
        column += here;
        if (column == rectangle.width) {
          column = 0;
          row += across;
        }
      }
      return true;
    };
    if (!ReadStretches(reader, rectangle.width * rectangle.height, take)) return false;
  }
  return true;
}

void AppendRectangle(std::string& code, std::int32_t x, std::int32_t y, int width, int height,
                     const std::uint8_t* cells) {
  AppendCorners(code, x, y, width, height);
  StretchWriter writer(code);
  writer.Row(cells, nullptr, static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
}

bool ExpandRectangles(std::string_view code, std::string* plain) {
  ByteReader reader(code);
  std::size_t total = 0;
  while (!reader.rest().empty()) {
    Rectangle rectangle;
    if (!ReadRectangle(reader, &rectangle)) return false;
    const std::size_t cells = rectangle.width * rectangle.height;
    total += cells;
    if (total > kMostCells) return false;
    AppendCorners(*plain, rectangle.x, rectangle.y, static_cast<int>(rectangle.width),
                  static_cast<int>(rectangle.height));
    const auto take = [&](Stretch kind, std::size_t count, std::string_view colours) {
      if (kind == Stretch::kKeep) return false;  // there is nothing to keep
      if (kind == Stretch::kCells) {
        *plain += colours;
      } else {
        for (std::size_t i = 0; i < count; ++i) *plain += colours;
      }
      return true;
    };
    if (!ReadStretches(reader, cells, take)) return false;
  }
  return true;
}

}  // namespace ccmorse::wire
