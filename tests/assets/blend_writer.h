#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace ccmorse::test {

/// Writes .blend files as small as can be: only the structs and members that a test needs,
/// described by a DNA1 block as Blender describes its own. Wrong use aborts: it is the test that is
/// wrong.
class BlendWriter {
 public:
  /// `wide`: pointers of 8 bytes, else 4; `big`: big-endian.
  BlendWriter(bool wide, bool big, int version) : wide_(wide), big_(big), version_(version) {}

  /// Members as in C: {"float", "loc[3]"}, {"Object", "*parent"}, {"ID", "id"}.
  void Struct(const std::string& name, std::vector<std::pair<std::string, std::string>> members);

  /// A block of `count` zeroed structs; the address is what pointers to it say.
  std::uint64_t Add(const std::string& code, const std::string& type, std::size_t count = 1);
  /// A block of bytes as they are; `type` is what the block claims.
  std::uint64_t AddBytes(const std::string& type, std::vector<std::uint8_t> bytes);
  /// A block of pointers.
  std::uint64_t AddPointers(const std::vector<std::uint64_t>& pointers);

  void ReplacePointers(std::uint64_t address, const std::vector<std::uint64_t>& pointers);

  /// Sets a member, "loc" or "id.name", of the `index`th struct in a block.
  void Set(std::uint64_t address, const std::string& path, double value, std::size_t element = 0,
           std::size_t index = 0);
  void SetPointer(std::uint64_t address, const std::string& path, std::uint64_t to,
                  std::size_t element = 0);
  void SetText(std::uint64_t address, const std::string& path, const std::string& text);

  std::vector<std::uint8_t> Write() const;

 private:
  struct Member {
    std::string type;
    std::string name;  ///< as in C
    std::string plain;
    bool pointer = false;
    std::size_t count = 1;
    std::size_t offset = 0;
  };
  struct Type {
    std::string name;
    std::vector<Member> members;
    std::size_t size = 0;
  };
  struct Block {
    std::string code;
    std::size_t type = 0;
    std::size_t count = 0;
    std::uint64_t address = 0;
    std::vector<std::uint8_t> bytes;
  };

  std::size_t SizeOf(const std::string& type) const;
  void Put(std::vector<std::uint8_t>& out, std::uint64_t value, std::size_t size) const;
  // Where a member's element is, with its type; "" for a pointer.
  std::pair<std::size_t, std::string> Find(const Block& block, const std::string& path,
                                           std::size_t element, std::size_t index) const;
  Block& At(std::uint64_t address);

  bool wide_;
  bool big_;
  int version_;
  std::vector<Type> types_;
  std::vector<Block> blocks_;
};

/// What SampleBlend writes.
struct SampleOptions {
  bool wide = true;
  bool big = false;
  bool faces = false;   ///< MFace, as until 2.62, instead of polygons
  bool packed = false;  ///< gzip
  int version = 274;
  bool cycle = false;       ///< the two objects are each other's parents
  bool bad_vertex = false;  ///< a face has a vertex that is not there
};

/// An Empty "Base" at (1, 2, 3), turned by 90 degrees about z, and on it the mesh "Crate": a box of
/// 2 x 1 x 1 m around its origin, 0.5 m above the Base (so that its corners are at x 0.5 .. 1.5,
/// y 1 .. 3, z 3 .. 4), a rigid body of 5 kg with a convex hull, game properties Object (true),
/// Label ("box"), Count (7) and Weight (2.5), and a red material with friction 0.8. A sun lamp, a
/// camera, and "Far", the same mesh on a layer that the scene does not show.
std::vector<std::uint8_t> SampleBlend(const SampleOptions& options = {});

/// Packs by gzip.
std::vector<std::uint8_t> Gzip(const std::vector<std::uint8_t>& bytes);

}  // namespace ccmorse::test
