#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace ccmorse::assets {

/// A member of a struct as the file describes it.
struct BlendField {
  std::size_t offset = 0;  ///< bytes from the struct's start
  std::size_t size = 0;    ///< bytes of one element
  std::size_t count = 1;   ///< elements: 16 of float[4][4]
  int type = 0;            ///< index of the file's types
  bool pointer = false;
};

/// A struct as the file describes it (its block DNA1).
struct BlendStruct {
  std::string name;
  std::size_t size = 0;  ///< bytes
  std::unordered_map<std::string, BlendField> fields;
};

/// A piece of memory as Blender wrote it.
struct BlendBlock {
  std::string code;           ///< "OB", "ME", "DATA", ...
  std::uint64_t address = 0;  ///< where it lay, which is what pointers say
  int type = -1;              ///< index of structs
  std::size_t count = 0;      ///< structs in it, as it says; data may be shorter
  std::size_t offset = 0;     ///< of the data in the file, bytes
  std::size_t size = 0;       ///< of the data, bytes
};

class BlendFile;

/// One struct within a block. Members are asked for by name; one that the file's version of the
/// struct has not reads as the fallback. Refers to the BlendFile, which must outlive it.
class BlendRecord {
 public:
  BlendRecord() = default;
  BlendRecord(const BlendFile& file, const BlendStruct& type, std::size_t offset)
      : file_(&file), type_(&type), offset_(offset) {}

  explicit operator bool() const { return file_ != nullptr; }
  bool Has(const std::string& name) const { return type_->fields.contains(name); }
  /// A whole number of 1 to 8 bytes, signed but for what is larger than an int64.
  std::int64_t Int(const std::string& name, std::int64_t fallback = 0, std::size_t at = 0) const;
  /// A float or double, or a whole number; may be anything but finite.
  double Number(const std::string& name, double fallback = 0.0, std::size_t at = 0) const;
  /// A text that ends with a zero byte or the member.
  std::string Text(const std::string& name) const;
  /// An address; 0 for none.
  std::uint64_t Pointer(const std::string& name, std::size_t at = 0) const;
  /// A struct within this one; false where there is none.
  BlendRecord Part(const std::string& name) const;
  /// Where its bytes are in the file.
  std::size_t offset() const { return offset_; }
  const BlendStruct& type() const { return *type_; }

 private:
  // The field's bytes; empty when there is none.
  std::span<const std::uint8_t> Bytes(const std::string& name, std::size_t at,
                                      const BlendField** field) const;
  const BlendFile* file_ = nullptr;
  const BlendStruct* type_ = nullptr;
  std::size_t offset_ = 0;
};

/// A .blend file as blocks and structs: Blender writes its memory as it is, with a description of
/// all structs, so that this reads what any version with its own fields, width of pointers and
/// order of bytes wrote. Knows nothing of what the structs mean.
class BlendFile {
 public:
  /// Takes the whole file, unpacked. Throws Error "FILE: offset N: ..." when it is no .blend, is
  /// cut short, or its description is of no use.
  BlendFile(std::vector<std::uint8_t> bytes, std::string name);
  BlendFile(const BlendFile&) = delete;
  BlendFile& operator=(const BlendFile&) = delete;

  int version() const { return version_; }  ///< 274 for 2.74
  const std::string& name() const { return name_; }
  std::size_t pointer_size() const { return pointer_size_; }
  const std::vector<BlendBlock>& blocks() const { return blocks_; }
  std::span<const std::uint8_t> bytes() const { return bytes_; }
  const std::string& TypeName(int type) const { return types_[static_cast<std::size_t>(type)]; }

  /// The struct of this name; nullptr where the file has none.
  const BlendStruct* FindStruct(const std::string& name) const;
  const BlendStruct& StructOf(const BlendBlock& block) const;

  /// The `index`th struct of type `type` in the block. Throws Error when the block is too short.
  BlendRecord At(const BlendBlock& block, const BlendStruct& type, std::size_t index = 0) const;
  /// How many structs of the type the block has room for.
  static std::size_t Room(const BlendBlock& block, const BlendStruct& type) {
    return type.size == 0 ? 0 : block.size / type.size;
  }

  // Numbers at an offset; throw Error beyond the file's end.
  std::uint64_t Unsigned(std::size_t offset, std::size_t size) const;
  std::int64_t Signed(std::size_t offset, std::size_t size) const;
  double Float(std::size_t offset) const;

  /// Throws Error "FILE: offset N: text".
  [[noreturn]] void Fail(std::size_t offset, const std::string& text) const;

 private:
  void ReadBlocks();
  void ReadDescription(const BlendBlock& block);

  std::vector<std::uint8_t> bytes_;
  std::string name_;
  std::size_t pointer_size_ = 8;
  bool big_ = false;
  int version_ = 0;
  std::vector<BlendBlock> blocks_;
  std::vector<std::string> types_;
  std::vector<BlendStruct> structs_;
  std::unordered_map<std::string, std::size_t> struct_of_;
};

}  // namespace ccmorse::assets
