#include "assets/blend_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <limits>

#include "assets/asset_scene.h"
#include "base/error.h"

namespace ccmorse::assets {
namespace {

constexpr std::size_t kHeader = 12;
constexpr std::size_t kMostElements = 1U
                                      << 20U;  // of a member; Blender's largest are some thousand

// "**mat" is "mat" and a pointer; "obmat[4][4]" is "obmat" with 16 elements; "(*sort)()" is a
// pointer to a function.
struct MemberName {
  std::string name;
  bool pointer = false;
  std::size_t count = 1;
};

// False for what is no name.
bool Parse(std::string_view text, MemberName& member) {
  if (text.starts_with("(*")) {
    const std::size_t end = text.find(')');
    if (end == std::string_view::npos) return false;
    member = {std::string(text.substr(2, end - 2)), true, 1};
    return true;
  }
  while (text.starts_with('*')) {
    member.pointer = true;
    text.remove_prefix(1);
  }
  const std::size_t bracket = text.find('[');
  member.name = std::string(text.substr(0, bracket));
  while (!text.empty()) {
    const std::size_t open = text.find('[');
    if (open == std::string_view::npos) break;
    const std::size_t close = text.find(']', open);
    if (close == std::string_view::npos) return false;
    std::size_t number = 0;
    for (const char c : text.substr(open + 1, close - open - 1)) {
      if (c < '0' || c > '9') return false;
      number = number * 10 + static_cast<std::size_t>(c - '0');
      if (number > kMostElements) return false;
    }
    member.count *= number;
    if (member.count > kMostElements) return false;
    text.remove_prefix(close + 1);
  }
  return !member.name.empty();
}

}  // namespace

BlendFile::BlendFile(std::vector<std::uint8_t> bytes, std::string name)
    : bytes_(std::move(bytes)), name_(std::move(name)) {
  const std::string_view head(reinterpret_cast<const char*>(bytes_.data()),
                              std::min(bytes_.size(), kHeader));
  if (!head.starts_with("BLENDER") || head.size() < kHeader) {
    Fail(0, "is no .blend file: it does not begin with BLENDER and a version");
  }
  if (head[7] != '_' && head[7] != '-') {
    Fail(7, "has pointers of neither 4 ('_') nor 8 ('-') bytes");
  }
  pointer_size_ = head[7] == '_' ? 4 : 8;
  if (head[8] != 'v' && head[8] != 'V') Fail(8, "is neither little-endian ('v') nor big ('V')");
  big_ = head[8] == 'V';
  for (std::size_t i = 9; i < kHeader; ++i) {
    if (head[i] < '0' || head[i] > '9') Fail(i, "has no version of three digits");
    version_ = 10 * version_ + (head[i] - '0');
  }
  ReadBlocks();
}

void BlendFile::ReadBlocks() {
  const std::size_t header = 16 + pointer_size_;
  std::size_t at = kHeader;
  std::size_t description = std::numeric_limits<std::size_t>::max();
  while (true) {
    if (bytes_.size() - at < header) {
      Fail(at, "is cut short: a block's header is missing, and there was no ENDB");
    }
    BlendBlock block;
    for (std::size_t i = 0; i < 4 && bytes_[at + i] != 0; ++i) {
      block.code.push_back(static_cast<char>(bytes_[at + i]));
    }
    if (block.code == "ENDB") break;
    const std::int64_t size = Signed(at + 4, 4);
    block.address = Unsigned(at + 8, pointer_size_);
    block.type = static_cast<int>(Signed(at + 8 + pointer_size_, 4));
    const std::int64_t count = Signed(at + 12 + pointer_size_, 4);
    block.offset = at + header;
    if (size < 0 || static_cast<std::uint64_t>(size) > bytes_.size() - block.offset) {
      Fail(at, fmt::format("is cut short: block '{}' is to have {} bytes, and {} are left",
                           block.code, size, bytes_.size() - block.offset));
    }
    if (count < 0) Fail(at, fmt::format("block '{}' has {} structs", block.code, count));
    block.size = static_cast<std::size_t>(size);
    block.count = static_cast<std::size_t>(count);
    if (block.code == "DNA1") description = blocks_.size();
    at = block.offset + block.size;
    blocks_.push_back(std::move(block));
  }
  if (description == std::numeric_limits<std::size_t>::max()) {
    Fail(at, "has no block DNA1, which describes all others");
  }
  ReadDescription(blocks_[description]);
  for (const BlendBlock& block : blocks_) {
    if (block.type < 0 || static_cast<std::size_t>(block.type) >= structs_.size()) {
      Fail(block.offset, fmt::format("block '{}' is of struct {}, and there are {}", block.code,
                                     block.type, structs_.size()));
    }
  }
}

void BlendFile::ReadDescription(const BlendBlock& block) {
  std::size_t at = block.offset;
  const std::size_t end = block.offset + block.size;
  const auto need = [&](std::size_t bytes) {
    if (end - at < bytes) Fail(at, "the description of structs is cut short");
  };
  const auto tag = [&](std::string_view text) {
    at = block.offset + ((at - block.offset + 3) & ~std::size_t{3});
    if (at > end) at = end;
    need(4);
    const std::string_view found(reinterpret_cast<const char*>(&bytes_[at]), 4);
    if (found != text) Fail(at, fmt::format("the description of structs lacks '{}' here", text));
    at += 4;
  };
  const auto number = [&](std::size_t bytes) {
    need(bytes);
    const std::uint64_t value = Unsigned(at, bytes);
    at += bytes;
    return value;
  };
  const auto texts = [&](std::vector<std::string>& list) {
    const std::uint64_t count = number(4);
    if (count > end - at) Fail(at, "the description of structs counts more names than it has");
    for (std::uint64_t i = 0; i < count; ++i) {
      const auto first = bytes_.begin() + static_cast<std::ptrdiff_t>(at);
      const auto last = bytes_.begin() + static_cast<std::ptrdiff_t>(end);
      const auto zero = std::find(first, last, std::uint8_t{0});
      if (zero == last) Fail(at, "the description of structs is cut short within a name");
      list.emplace_back(first, zero);
      at += list.back().size() + 1;
    }
  };
  tag("SDNA");
  tag("NAME");
  std::vector<std::string> names;
  texts(names);
  std::vector<MemberName> members;
  for (const std::string& name : names) {
    MemberName member;
    if (!Parse(name, member)) Fail(block.offset, "the description of structs has a broken name");
    members.push_back(std::move(member));
  }
  tag("TYPE");
  texts(types_);
  tag("TLEN");
  std::vector<std::size_t> sizes;
  for (std::size_t i = 0; i < types_.size(); ++i) {
    sizes.push_back(static_cast<std::size_t>(number(2)));
  }
  tag("STRC");
  const std::uint64_t structs = number(4);
  for (std::uint64_t i = 0; i < structs; ++i) {
    const std::uint64_t type = number(2);
    const std::uint64_t count = number(2);
    if (type >= types_.size()) Fail(at, "the description of structs names a type it has not");
    BlendStruct described;
    described.name = types_[static_cast<std::size_t>(type)];
    described.size = sizes[static_cast<std::size_t>(type)];
    std::size_t offset = 0;
    for (std::uint64_t k = 0; k < count; ++k) {
      const std::uint64_t of_type = number(2);
      const std::uint64_t name = number(2);
      if (of_type >= types_.size() || name >= members.size()) {
        Fail(at, "the description of structs names a member it has not");
      }
      const MemberName& member = members[static_cast<std::size_t>(name)];
      BlendField field;
      field.offset = offset;
      field.type = static_cast<int>(of_type);
      field.pointer = member.pointer;
      field.size = member.pointer ? pointer_size_ : sizes[static_cast<std::size_t>(of_type)];
      field.count = member.count;
      offset += field.size * field.count;
      if (offset > described.size) {
        Fail(at, fmt::format("struct {} is to have {} bytes, and its members have more",
                             described.name, described.size));
      }
      described.fields.emplace(member.name, field);
    }
    struct_of_.emplace(described.name, structs_.size());
    structs_.push_back(std::move(described));
  }
}

const BlendStruct* BlendFile::FindStruct(const std::string& name) const {
  const auto found = struct_of_.find(name);
  return found != struct_of_.end() ? &structs_[found->second] : nullptr;
}

const BlendStruct& BlendFile::StructOf(const BlendBlock& block) const {
  return structs_[static_cast<std::size_t>(block.type)];
}

BlendRecord BlendFile::At(const BlendBlock& block, const BlendStruct& type,
                          std::size_t index) const {
  if (index >= Room(block, type)) {
    Fail(block.offset, fmt::format("block '{}' of {} bytes is too short for {} structs {}",
                                   block.code, block.size, index + 1, type.name));
  }
  return {*this, type, block.offset + index * type.size};
}

std::uint64_t BlendFile::Unsigned(std::size_t offset, std::size_t size) const {
  if (offset > bytes_.size() || bytes_.size() - offset < size) Fail(offset, "is cut short");
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const std::uint64_t byte = bytes_[offset + (big_ ? i : size - 1 - i)];
    value = (value << 8U) | byte;
  }
  return value;
}

std::int64_t BlendFile::Signed(std::size_t offset, std::size_t size) const {
  const std::uint64_t value = Unsigned(offset, size);
  if (size >= 8) return static_cast<std::int64_t>(value);
  const std::uint64_t sign = std::uint64_t{1} << (8 * size - 1);
  return static_cast<std::int64_t>(value ^ sign) - static_cast<std::int64_t>(sign);
}

double BlendFile::Float(std::size_t offset) const {
  return std::bit_cast<float>(static_cast<std::uint32_t>(Unsigned(offset, 4)));
}

void BlendFile::Fail(std::size_t offset, const std::string& text) const {
  throw Error(fmt::format("{}: offset {}: {}", name_, offset, OneLine(text)));
}

std::span<const std::uint8_t> BlendRecord::Bytes(const std::string& name, std::size_t at,
                                                 const BlendField** field) const {
  const auto found = type_->fields.find(name);
  if (found == type_->fields.end() || at >= found->second.count) return {};
  *field = &found->second;
  return file_->bytes().subspan(offset_ + found->second.offset + at * found->second.size,
                                found->second.size);
}

std::int64_t BlendRecord::Int(const std::string& name, std::int64_t fallback,
                              std::size_t at) const {
  const BlendField* field = nullptr;
  const auto bytes = Bytes(name, at, &field);
  if (bytes.empty() || bytes.size() > 8) return fallback;
  return file_->Signed(static_cast<std::size_t>(bytes.data() - file_->bytes().data()),
                       bytes.size());
}

double BlendRecord::Number(const std::string& name, double fallback, std::size_t at) const {
  const BlendField* field = nullptr;
  const auto bytes = Bytes(name, at, &field);
  if (bytes.empty()) return fallback;
  const auto offset = static_cast<std::size_t>(bytes.data() - file_->bytes().data());
  const std::string& type = file_->TypeName(field->type);
  if (type == "float" && bytes.size() == 4) return file_->Float(offset);
  if (type == "double" && bytes.size() == 8) {
    return std::bit_cast<double>(file_->Unsigned(offset, 8));
  }
  if (bytes.size() > 8) return fallback;
  return static_cast<double>(file_->Signed(offset, bytes.size()));
}

std::string BlendRecord::Text(const std::string& name) const {
  const auto found = type_->fields.find(name);
  if (found == type_->fields.end() || found->second.size != 1) return "";
  const auto bytes = file_->bytes().subspan(offset_ + found->second.offset, found->second.count);
  return {bytes.begin(), std::find(bytes.begin(), bytes.end(), std::uint8_t{0})};
}

std::uint64_t BlendRecord::Pointer(const std::string& name, std::size_t at) const {
  const BlendField* field = nullptr;
  const auto bytes = Bytes(name, at, &field);
  if (bytes.empty() || !field->pointer) return 0;
  return file_->Unsigned(static_cast<std::size_t>(bytes.data() - file_->bytes().data()),
                         bytes.size());
}

BlendRecord BlendRecord::Part(const std::string& name) const {
  const BlendField* field = nullptr;
  const auto bytes = Bytes(name, 0, &field);
  if (bytes.empty() || field->pointer) return {};
  const BlendStruct* const type = file_->FindStruct(file_->TypeName(field->type));
  if (type == nullptr || type->size > field->size) return {};
  return {*file_, *type, static_cast<std::size_t>(bytes.data() - file_->bytes().data())};
}

}  // namespace ccmorse::assets
