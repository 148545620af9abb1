// What the structs of a .blend mean. Their names and members are those of Blender's files, which
// describe themselves; the meaning of flags is documented with Blender's Python API (bpy.types
// GameObjectSettings, Object, Mesh, Material; https://docs.blender.org/api/2.79/).

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "assets/blend_file.h"
#include "assets/picture.h"
#include "assets/readers.h"
#include "assets/shape_builder.h"
#include "assets/triangulate.h"
#include "base/error.h"
#include "base/trig.h"

namespace ccmorse::assets {
namespace {

constexpr int kOldest = 260;      // 2.60
constexpr int kNewest = 279;      // 2.79
constexpr int kDeepestGroup = 8;  // groups within groups

// Bits of Object.gameflag.
constexpr std::int64_t kDynamic = 1;
constexpr std::int64_t kChild = 1 << 1;
constexpr std::int64_t kActor = 1 << 2;
constexpr std::int64_t kLockMove = 1 << 3;  // x, and two more for y and z
constexpr std::int64_t kGhost = 1 << 9;
constexpr std::int64_t kRigidBody = 1 << 10;
constexpr std::int64_t kBounds = 1 << 11;
constexpr std::int64_t kCollision = 1 << 16;
constexpr std::int64_t kSoftBody = 1 << 17;
constexpr std::int64_t kOccluder = 1 << 18;
constexpr std::int64_t kSensor = 1 << 19;
constexpr std::int64_t kNavmesh = 1 << 20;
constexpr std::int64_t kCharacter = 1 << 22;
// Bits of Object.gameflag2.
constexpr std::int64_t kLockRotate = 1 << 1;  // x, and two more

constexpr std::int64_t kRestrictRender = 1 << 2;  // of Object.restrictflag
constexpr std::int64_t kDupliGroup = 1 << 8;      // of Object.transflag
constexpr std::int64_t kMeshType = 1;             // of Object.type
constexpr std::int64_t kImageTexture = 8;         // of Tex.type

std::string ObjectType(std::int64_t type) {
  switch (type) {
    case 0:
      return "EMPTY";
    case kMeshType:
      return "MESH";
    case 2:
      return "CURVE";
    case 3:
      return "SURFACE";
    case 4:
      return "FONT";
    case 5:
      return "META";
    case 10:
      return "LAMP";
    case 11:
      return "CAMERA";
    case 12:
      return "SPEAKER";
    case 22:
      return "LATTICE";
    case 25:
      return "ARMATURE";
    default:
      return fmt::format("TYPE_{}", type);
  }
}

std::string ModifierName(std::int64_t type) {
  switch (type) {
    case 1:
      return "Subsurf";
    case 5:
      return "Mirror";
    case 6:
      return "Decimate";
    case 11:
      return "Boolean";
    case 12:
      return "Array";
    case 14:
      return "Displace";
    default:
      return fmt::format("type {}", type);
  }
}

// Modifiers that leave the shape as it is, or deform it for an armature.
bool LeavesShape(std::int64_t type) {
  constexpr std::int64_t kArmature = 8;
  constexpr std::int64_t kEdgeSplit = 13;
  return type == kArmature || type == kEdgeSplit;
}

bool IsFinite(const Vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// A rotation about axis 0, 1 or 2.
Affine About(int axis, double angle) {
  const double s = std::sin(angle);
  const double c = std::cos(angle);
  Affine m;
  if (axis == 0) {
    m.y = {0.0, c, s};
    m.z = {0.0, -s, c};
  } else if (axis == 1) {
    m.x = {c, 0.0, -s};
    m.z = {s, 0.0, c};
  } else {
    m.x = {c, s, 0.0};
    m.y = {-s, c, 0.0};
  }
  return m;
}

// Blender's Object.rotmode 1..6 names the order of the axes: XYZ turns about x first.
Affine FromEulerOrder(std::int64_t order, const Vec3& angles) {
  constexpr std::array<std::array<int, 3>, 6> kOrders = {
      {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
  const std::array<double, 3> by = {angles.x, angles.y, angles.z};
  const auto& axes = kOrders[static_cast<std::size_t>(order >= 1 && order <= 6 ? order - 1 : 0)];
  Affine m;
  for (const int axis : axes) m = About(axis, by[static_cast<std::size_t>(axis)]) * m;
  return m;
}

Affine FromAxisAngle(const Vec3& axis, double angle) {
  const double length = std::sqrt(Dot(axis, axis));
  if (!(length > 0.0)) return {};
  return FromQuaternion(std::cos(angle / 2.0), (std::sin(angle / 2.0) / length) * axis);
}

double FiniteOr(double value, double fallback) { return std::isfinite(value) ? value : fallback; }

Vec3 VectorOf(const BlendRecord& record, const std::string& name, double fallback = 0.0) {
  return {record.Number(name, fallback, 0), record.Number(name, fallback, 1),
          record.Number(name, fallback, 2)};
}

// float[4][4], of which the first index is the column.
Affine MatrixOf(const BlendRecord& record, const std::string& name) {
  if (!record.Has(name)) return {};
  const auto column = [&](std::size_t i) {
    return Vec3{record.Number(name, 0.0, 4 * i), record.Number(name, 0.0, 4 * i + 1),
                record.Number(name, 0.0, 4 * i + 2)};
  };
  return {column(0), column(1), column(2), column(3)};
}

// Where the object is in its parent's frame, before the parent's inverse.
Affine LocalMatrix(const BlendRecord& object) {
  Affine rotation;
  const std::int64_t mode = object.Int("rotmode", 1);
  if (mode == 0) {
    const auto quaternion = [&](const char* name) {
      return FromQuaternion(
          object.Number(name, 1.0, 0),
          {object.Number(name, 0.0, 1), object.Number(name, 0.0, 2), object.Number(name, 0.0, 3)});
    };
    rotation = quaternion("dquat") * quaternion("quat");
  } else if (mode < 0) {
    rotation = FromAxisAngle(VectorOf(object, "drotAxis"), object.Number("drotAngle")) *
               FromAxisAngle(VectorOf(object, "rotAxis"), object.Number("rotAngle"));
  } else {
    rotation = FromEulerOrder(mode, VectorOf(object, "drot")) *
               FromEulerOrder(mode, VectorOf(object, "rot"));
  }
  Vec3 scale = VectorOf(object, "size", 1.0);
  if (object.Has("dscale")) {
    const Vec3 delta = VectorOf(object, "dscale", 1.0);
    scale = {scale.x * delta.x, scale.y * delta.y, scale.z * delta.z};
  } else {
    scale = scale + VectorOf(object, "dsize");  // until 2.61 what is added
  }
  return {scale.x * rotation.x, scale.y * rotation.y, scale.z * rotation.z,
          VectorOf(object, "loc") + VectorOf(object, "dloc")};
}

// A mesh in its own frame, as the objects that have it share it.
struct LocalMesh {
  std::vector<Vec3> vertices;
  std::vector<std::array<int, 3>> triangles;
  std::vector<int> slot_of;  // of materials, by triangle
  /// Texture coordinates of the corners, by triangle; empty where the mesh has none.
  std::vector<std::array<Vec2, 3>> uv_of;
  std::vector<int> face_of;  // counted through, by triangle
  int faces = 0;
};

// How a material's picture lies on it.
struct Coating {
  std::optional<Picture> picture;
  bool by_coordinates = false;  // else one does not know which part of it is where
  bool multiplies = false;      // the colour beneath; else takes its place
  double share = 1.0;           // of the picture in the mixture
  Vec2 repeats{1.0, 1.0};
};

Color Coated(const Coating& coating, Color under, Color over) {
  const auto mix = [&coating](std::uint8_t below, std::uint8_t above) {
    const double top = coating.multiplies ? below * above / 255.0 : above;
    return static_cast<std::uint8_t>(std::lround(below + coating.share * (top - below)));
  };
  return {mix(under.r, over.r), mix(under.g, over.g), mix(under.b, over.b)};
}

// The mean of the picture over a triangle, from 16 points.
Color MeanOf(const Coating& coating, const std::array<Vec2, 3>& uv) {
  std::array<int, 3> sum{};
  constexpr int kSplit = 4;
  int count = 0;
  for (int i = 0; i < kSplit; ++i) {
    for (int k = 0; k < 2 * (kSplit - i) - 1; ++k, ++count) {
      // The middle of a small triangle, every second of which stands on its head.
      const double third = k % 2 == 0 ? 1.0 / 3.0 : 2.0 / 3.0;
      const double a = (i + third) / kSplit;
      const int column = k / 2;
      const double b = (column + third) / kSplit;
      const Vec2 at = (1.0 - a - b) * uv[0] + a * uv[1] + b * uv[2];
      const Color color = coating.picture->At(at.x * coating.repeats.x, at.y * coating.repeats.y);
      sum[0] += color.r;
      sum[1] += color.g;
      sum[2] += color.b;
    }
  }
  return {static_cast<std::uint8_t>(sum[0] / count), static_cast<std::uint8_t>(sum[1] / count),
          static_cast<std::uint8_t>(sum[2] / count)};
}

class BlendReader {
 public:
  BlendReader(const BlendFile& file, const AssetLimits& limits, const FindFile& find)
      : file_(file), limits_(limits), find_(find) {
    for (std::size_t i = 0; i < file_.blocks().size(); ++i) {
      const BlendBlock& block = file_.blocks()[i];
      if (block.code != "DATA") id_at_.emplace(block.address, i);
    }
  }

  AssetScene Read() {
    scene_.format = fmt::format("Blender {}.{:02}", file_.version() / 100, file_.version() % 100);
    if (file_.version() < kOldest || file_.version() > kNewest) {
      scene_.notes.push_back(
          fmt::format("is of {}; 2.60 to 2.79 are what this reader knows", scene_.format));
    }
    ReadImages();
    ReadMaterials();
    ReadObjects();
    ReadScene();
    ExpandGroups();
    NoteModifiers();
    return std::move(scene_);
  }

 private:
  using DataMap = std::unordered_map<std::uint64_t, std::size_t>;

  // An ID's name without the two letters of its kind.
  static std::string NameOf(const BlendRecord& record) {
    const BlendRecord id = record.Part("id");
    const std::string name = id ? id.Text("name") : "";
    return name.size() > 2 ? name.substr(2) : name;
  }

  // Calls use(index of block, record) for each ID of a kind, in the file's order.
  template <typename Use>
  void EachId(const std::string& code, const std::string& type, const Use& use) {
    for (std::size_t i = 0; i < file_.blocks().size(); ++i) {
      const BlendBlock& block = file_.blocks()[i];
      if (block.code != code || file_.StructOf(block).name != type) continue;
      use(i, file_.At(block, file_.StructOf(block)));
    }
  }

  // The ID at an address, when it is of the struct; a false record and -1 otherwise.
  std::pair<std::size_t, BlendRecord> IdAt(std::uint64_t address, const std::string& type) const {
    const auto found = id_at_.find(address);
    if (address == 0 || found == id_at_.end()) return {0, {}};
    const BlendBlock& block = file_.blocks()[found->second];
    if (file_.StructOf(block).name != type) return {0, {}};
    return {found->second, file_.At(block, file_.StructOf(block))};
  }

  // The block of data at an address that belongs to an ID: addresses are unique only within one.
  const BlendBlock* DataAt(std::size_t id, std::uint64_t address) {
    if (address == 0) return nullptr;
    const auto [found, is_new] = data_of_.try_emplace(id);
    DataMap& map = found->second;
    if (is_new) {
      for (std::size_t i = id + 1; i < file_.blocks().size(); ++i) {
        if (file_.blocks()[i].code != "DATA") break;
        map.emplace(file_.blocks()[i].address, i);
      }
    }
    const auto data = map.find(address);
    return data != map.end() ? &file_.blocks()[data->second] : nullptr;
  }

  // The same as a struct; its type is what the block says, when that is `type`.
  BlendRecord DataAt(std::size_t id, std::uint64_t address, const std::string& type) {
    const BlendBlock* const block = DataAt(id, address);
    if (block == nullptr || file_.StructOf(*block).name != type) return {};
    return file_.At(*block, file_.StructOf(*block));
  }

  // The pointers that an ID's data at an address consist of.
  std::vector<std::uint64_t> Pointers(std::size_t id, std::uint64_t address) {
    std::vector<std::uint64_t> pointers;
    const BlendBlock* const block = DataAt(id, address);
    if (block == nullptr) return pointers;
    const std::size_t size = file_.pointer_size();
    for (std::size_t i = 0; i + size <= block->size; i += size) {
      pointers.push_back(file_.Unsigned(block->offset + i, size));
    }
    return pointers;
  }

  // Calls use(record) for each struct of a list in an ID's data.
  template <typename Use>
  void EachOfList(std::size_t id, const BlendRecord& owner, const std::string& list,
                  const std::string& type, const Use& use) {
    const BlendRecord ends = owner.Part(list);
    if (!ends) return;
    std::uint64_t at = ends.Pointer("first");
    // No list is longer than the file has blocks, unless it runs in a circle.
    for (std::size_t i = 0; at != 0 && i <= file_.blocks().size(); ++i) {
      const BlendBlock* const block = DataAt(id, at);
      if (block == nullptr) return;
      // Modifiers and others begin with the struct that is asked for.
      const BlendStruct& own = file_.StructOf(*block);
      BlendRecord item = file_.At(*block, own);
      at = item.Pointer("next");
      if (own.name != type) {
        const BlendRecord head = item.Part(ToLowerHead(type));
        if (!head) continue;
        at = head.Pointer("next");
        item = head;
      }
      use(item);
    }
    if (at != 0) file_.Fail(owner.offset(), fmt::format("the list '{}' runs in a circle", list));
  }

  // "ModifierData" is the member "modifier" of what begins with it.
  static std::string ToLowerHead(const std::string& type) {
    return type == "ModifierData" ? "modifier" : type;
  }

  void ReadImages() {
    EachId("IM", "Image", [&](std::size_t id, const BlendRecord& record) {
      AssetImage image;
      image.name = NameOf(record);
      image.path = record.Text("name");
      const BlendRecord packed = DataAt(id, record.Pointer("packedfile"), "PackedFile");
      if (packed) {
        image.packed_size = static_cast<std::size_t>(std::max<std::int64_t>(0, packed.Int("size")));
      }
      image_ids_.push_back(id);
      image_at_.emplace(file_.blocks()[id].address, static_cast<int>(scene_.images.size()));
      scene_.images.push_back(std::move(image));
    });
  }

  // The picture of an image, from within the file or from beside it.
  std::optional<Picture> PictureOf(int index) {
    const auto [known, is_new] = pictures_.try_emplace(index);
    if (!is_new) return known->second;
    const std::size_t id = image_ids_[static_cast<std::size_t>(index)];
    const BlendRecord record = file_.At(file_.blocks()[id], file_.StructOf(file_.blocks()[id]));
    const BlendRecord packed = DataAt(id, record.Pointer("packedfile"), "PackedFile");
    if (packed) {
      const BlendBlock* const data = DataAt(id, packed.Pointer("data"));
      const std::int64_t size = packed.Int("size");
      if (data != nullptr && size > 0 && static_cast<std::uint64_t>(size) <= data->size) {
        known->second =
            ReadPicture(file_.bytes().subspan(data->offset, static_cast<std::size_t>(size)));
      }
    } else if (find_) {
      std::string path = record.Text("name");
      if (path.starts_with("//")) path.erase(0, 2);
      try {
        if (!path.empty()) known->second = ReadPicture(find_(path));
      } catch (const Error&) {
        // It stayed on the machine of who made the file: the material's own colour it is.
      }
    }
    return known->second;
  }

  Coating CoatingOf(const BlendRecord& slot, int image) {
    constexpr std::int64_t kByCoordinates = 16;  // of MTex.texco
    constexpr std::int64_t kMultiply = 1;        // of MTex.blendtype
    Coating coating;
    coating.picture = PictureOf(image);
    coating.by_coordinates = slot.Int("texco", kByCoordinates) == kByCoordinates;
    coating.multiplies = slot.Int("blendtype") == kMultiply;
    coating.share = std::clamp(FiniteOr(slot.Number("colfac", 1.0), 1.0), 0.0, 1.0);
    coating.repeats = {FiniteOr(slot.Number("size", 1.0, 0), 1.0),
                       FiniteOr(slot.Number("size", 1.0, 1), 1.0)};
    return coating;
  }

  void ReadMaterials() {
    EachId("MA", "Material", [&](std::size_t id, const BlendRecord& record) {
      AssetMaterial material;
      material.name = NameOf(record);
      material.color = {FromShare(record.Number("r", 0.8)), FromShare(record.Number("g", 0.8)),
                        FromShare(record.Number("b", 0.8))};
      material.specular = std::clamp(FiniteOr(record.Number("spec", 0.5), 0.5), 0.0, 1.0);
      material.alpha = std::clamp(FiniteOr(record.Number("alpha", 1.0), 1.0), 0.0, 1.0);
      material.friction = std::max(0.0, FiniteOr(record.Number("friction", 0.5), 0.5));
      material.restitution = std::clamp(FiniteOr(record.Number("reflect", 0.0), 0.0), 0.0, 1.0);
      constexpr std::int64_t kColor = 1;  // of MTex.mapto
      for (std::size_t i = 0; i < 18 && material.image < 0; ++i) {
        const BlendRecord slot = DataAt(id, record.Pointer("mtex", i), "MTex");
        if (!slot || (slot.Int("mapto", kColor) & kColor) == 0) continue;
        const auto [texture_id, texture] = IdAt(slot.Pointer("tex"), "Tex");
        if (!texture || texture.Int("type") != kImageTexture) continue;
        const auto image = image_at_.find(texture.Pointer("ima"));
        if (image == image_at_.end()) continue;
        material.image = image->second;
        Coating coating = CoatingOf(slot, material.image);
        if (!coating.picture) continue;
        material.pictured = Coated(coating, material.color, coating.picture->mean);
        coatings_.emplace(static_cast<int>(scene_.materials.size()), std::move(coating));
      }
      material_at_.emplace(file_.blocks()[id].address, static_cast<int>(scene_.materials.size()));
      scene_.materials.push_back(std::move(material));
    });
  }

  void ReadObjects() {
    EachId("OB", "Object", [&](std::size_t id, const BlendRecord& record) {
      if (ids_.size() >= limits_.objects) {
        file_.Fail(record.offset(), fmt::format("more than {} objects", limits_.objects));
      }
      object_at_.emplace(file_.blocks()[id].address, static_cast<int>(ids_.size()));
      ids_.push_back(id);
      records_.push_back(record);
      AssetObject object;
      object.name = NameOf(record);
      object.type = ObjectType(record.Int("type"));
      object.layers = static_cast<std::uint32_t>(record.Int("lay", 1));
      object.hidden = (record.Int("restrictflag") & kRestrictRender) != 0;
      object.physics = PhysicsOf(record);
      ReadProperties(id, record, object);
      ReadLamp(record, object);
      ReadCamera(record, object);
      scene_.objects.push_back(std::move(object));
    });
    for (std::size_t i = 0; i < ids_.size(); ++i) {
      const auto parent = object_at_.find(records_[i].Pointer("parent"));
      if (parent != object_at_.end()) scene_.objects[i].parent = parent->second;
    }
    PlaceObjects();
    for (std::size_t i = 0; i < ids_.size(); ++i) {
      if (records_[i].Int("type") == kMeshType) AddMesh(i);
    }
  }

  AssetPhysics PhysicsOf(const BlendRecord& record) const {
    AssetPhysics physics;
    const std::int64_t flags = record.Int("gameflag", kCollision);
    const auto has = [flags](std::int64_t bits) { return (flags & bits) != 0; };
    if (!has(kCollision)) {
      physics.type = has(kOccluder) ? "OCCLUDER" : "NO_COLLISION";
    } else if (has(kCharacter)) {
      physics.type = "CHARACTER";
    } else if (has(kSensor)) {
      physics.type = "SENSOR";
    } else if (has(kNavmesh)) {
      physics.type = "NAVMESH";
    } else if (!has(kDynamic)) {
      physics.type = "STATIC";
    } else if (has(kSoftBody)) {
      physics.type = "SOFT_BODY";
    } else {
      physics.type = has(kRigidBody) ? "RIGID_BODY" : "DYNAMIC";
    }
    physics.actor = has(kActor);
    physics.ghost = has(kGhost);
    physics.compound = has(kBounds) && has(kChild);
    physics.mass = FiniteOr(record.Number("mass", 1.0), 1.0);
    physics.radius = FiniteOr(record.Number("inertia", 1.0), 1.0);
    physics.linear_damping = FiniteOr(record.Number("damping", 0.04), 0.04);
    physics.angular_damping = FiniteOr(record.Number("rdamping", 0.1), 0.1);
    physics.margin = FiniteOr(record.Number("margin", 0.04), 0.04);
    physics.form_factor = FiniteOr(record.Number("formfactor", 0.4), 0.4);
    const std::int64_t more = record.Int("gameflag2");
    for (std::size_t axis = 0; axis < 3; ++axis) {
      physics.lock_move[axis] = has(kLockMove << axis);
      physics.lock_rotate[axis] = (more & (kLockRotate << axis)) != 0;
    }
    if (has(kBounds)) {
      static const std::array<std::string, 8> kShapes = {
          "BOX", "SPHERE", "CYLINDER", "CONE", "TRIANGLE_MESH", "CONVEX_HULL", "", "CAPSULE"};
      const std::int64_t shape =
          record.Int(record.Has("collision_boundtype") ? "collision_boundtype" : "boundtype");
      if (shape >= 0 && shape < 8) physics.bounds = kShapes[static_cast<std::size_t>(shape)];
    }
    return physics;
  }

  void ReadProperties(std::size_t id, const BlendRecord& record, AssetObject& object) {
    EachOfList(id, record, "prop", "bProperty", [&](const BlendRecord& property) {
      AssetProperty read;
      read.name = property.Text("name");
      const std::int64_t value = property.Int("data");
      switch (property.Int("type")) {
        case 0:
          read.value = Json(value != 0);
          break;
        case 1:
          read.value = Json(value);
          break;
        case 2:
        case 5: {  // a float in the bits of an int; 5 is a timer
          const auto at = property.type().fields.find("data");
          const double number = at == property.type().fields.end() || at->second.size != 4
                                    ? 0.0
                                    : file_.Float(property.offset() + at->second.offset);
          read.value = Json(FiniteOr(number, 0.0));
          break;
        }
        default: {
          std::string text;
          const BlendBlock* const block = DataAt(id, property.Pointer("poin"));
          for (std::size_t i = 0; block != nullptr && i < block->size; ++i) {
            const std::uint8_t byte = file_.bytes()[block->offset + i];
            if (byte == 0) break;
            text.push_back(static_cast<char>(byte));
          }
          read.value = Json(text);
        }
      }
      object.properties.push_back(std::move(read));
    });
  }

  void ReadLamp(const BlendRecord& record, AssetObject& object) {
    const auto [id, lamp] = IdAt(record.Pointer("data"), "Lamp");
    if (!lamp) return;
    static const std::array<std::string, 5> kKinds = {"POINT", "SUN", "SPOT", "HEMI", "AREA"};
    AssetLight light;
    const std::int64_t kind = lamp.Int("type");
    light.kind = kKinds[static_cast<std::size_t>(kind >= 0 && kind < 5 ? kind : 0)];
    light.color = {FromShare(lamp.Number("r", 1.0)), FromShare(lamp.Number("g", 1.0)),
                   FromShare(lamp.Number("b", 1.0))};
    light.energy = std::max(0.0, FiniteOr(lamp.Number("energy", 1.0), 1.0));
    light.distance = std::max(0.0, FiniteOr(lamp.Number("dist", 0.0), 0.0));
    if (light.kind == "SPOT") {
      const double size = std::max(0.0, FiniteOr(lamp.Number("spotsize", kPi / 4.0), kPi / 4.0));
      // Degrees until 2.69, radians from then on; no cone is wider than half a turn.
      light.spot_angle = std::min(kPi, size > kPi + 1e-3 ? size * kPi / 180.0 : size);
    }
    object.light = light;
  }

  void ReadCamera(const BlendRecord& record, AssetObject& object) {
    const auto [id, from] = IdAt(record.Pointer("data"), "Camera");
    if (!from) return;
    AssetCamera camera;
    const double lens = from.Number("lens", 35.0);
    const double sensor = from.Number("sensor_x", 32.0);
    if (from.Int("type") == 0 && lens > 0.0 && sensor > 0.0) {
      camera.fov = 2.0 * std::atan(sensor / (2.0 * lens));
    }
    camera.near = FiniteOr(from.Number("clipsta", 0.1), 0.1);
    camera.far = FiniteOr(from.Number("clipend", 100.0), 100.0);
    object.camera = camera;
  }

  // Where objects are in the world: each after its parent.
  void PlaceObjects() {
    enum class State : std::uint8_t { kNew, kOpen, kDone };
    std::vector<State> states(ids_.size(), State::kNew);
    std::vector<std::size_t> chain;
    for (std::size_t start = 0; start < ids_.size(); ++start) {
      // Up to the first ancestor that is placed, then down again.
      for (std::size_t i = start; states[i] != State::kDone;) {
        if (states[i] == State::kOpen) {
          file_.Fail(records_[i].offset(),
                     fmt::format("object '{}' is its own ancestor", scene_.objects[i].name));
        }
        states[i] = State::kOpen;
        chain.push_back(i);
        if (scene_.objects[i].parent < 0) break;
        i = static_cast<std::size_t>(scene_.objects[i].parent);
      }
      for (; !chain.empty(); chain.pop_back()) {
        Place(chain.back());
        states[chain.back()] = State::kDone;
      }
    }
  }

  void Place(std::size_t index) {
    const BlendRecord& record = records_[index];
    AssetObject& object = scene_.objects[index];
    const std::int64_t kind = record.Int("partype") & 15;
    constexpr std::int64_t kByArmature = 4;
    const BlendRecord constraints = record.Part("constraints");
    // Children of bones, vertices and curves, and what constraints move, stay where Blender last
    // had them; so do those of a parent in another file.
    const bool plain_parent = object.parent >= 0 && (kind == 0 || kind == kByArmature);
    const bool moved = constraints && constraints.Pointer("first") != 0;
    const bool as_saved =
        (record.Pointer("parent") != 0 && !plain_parent) || (moved && record.Has("obmat"));
    if (as_saved) {
      object.matrix = MatrixOf(record, "obmat");
    } else {
      object.matrix = LocalMatrix(record);
      if (plain_parent) {
        object.matrix = scene_.objects[static_cast<std::size_t>(object.parent)].matrix *
                        MatrixOf(record, "parentinv") * object.matrix;
      }
    }
    const Affine& m = object.matrix;
    if (!IsFinite(m.x) || !IsFinite(m.y) || !IsFinite(m.z) || !IsFinite(m.position)) {
      file_.Fail(record.offset(),
                 fmt::format("object '{}' is placed by numbers that are not finite", object.name));
    }
  }

  // A mesh's data of a kind: `count` structs; throws where it has fewer.
  struct Elements {
    const BlendStruct* type = nullptr;
    std::size_t offset = 0;
    std::size_t count = 0;
  };

  Elements ElementsOf(std::size_t id, const BlendRecord& mesh, const char* total,
                      const char* pointer, const char* type) {
    const std::int64_t count = mesh.Int(total);
    const BlendBlock* const block = DataAt(id, mesh.Pointer(pointer));
    const BlendStruct* const found = file_.FindStruct(type);
    if (count <= 0 || found == nullptr || found->size == 0) return {};
    if (block == nullptr || BlendFile::Room(*block, *found) < static_cast<std::uint64_t>(count)) {
      file_.Fail(mesh.offset(), fmt::format("mesh '{}' is to have {} of {}, and the file has not",
                                            NameOf(mesh), count, type));
    }
    return {found, block->offset, static_cast<std::size_t>(count)};
  }

  // Where a member of such structs is, from the struct's start; throws where it is not of `size`.
  std::size_t MemberOf(const Elements& elements, const char* name, std::size_t size) const {
    const auto found = elements.type->fields.find(name);
    if (found == elements.type->fields.end() || found->second.size != size ||
        found->second.pointer) {
      file_.Fail(elements.offset, fmt::format("struct {} has no member '{}' of {} bytes",
                                              elements.type->name, name, size));
    }
    return found->second.offset;
  }

  const LocalMesh& MeshAt(std::size_t id, const BlendRecord& record) {
    const auto [found, is_new] = meshes_.try_emplace(id);
    LocalMesh& mesh = found->second;
    if (!is_new) return mesh;
    const Elements vertices = ElementsOf(id, record, "totvert", "mvert", "MVert");
    if (vertices.count == 0) return mesh;
    const std::size_t place = MemberOf(vertices, "co", 4);
    mesh.vertices.reserve(vertices.count);
    for (std::size_t i = 0; i < vertices.count; ++i) {
      const std::size_t at = vertices.offset + i * vertices.type->size + place;
      const Vec3 vertex{file_.Float(at), file_.Float(at + 4), file_.Float(at + 8)};
      if (!IsFinite(vertex)) {
        file_.Fail(at, fmt::format("vertex {} of mesh '{}' is nowhere", i, NameOf(record)));
      }
      mesh.vertices.push_back(vertex);
    }
    if (record.Int("totpoly") > 0) {
      ReadPolygons(id, record, mesh);
    } else {
      ReadFaces(id, record, mesh);
    }
    return mesh;
  }

  int Vertex(std::int64_t index, std::size_t at, const LocalMesh& mesh) const {
    if (index < 0 || static_cast<std::uint64_t>(index) >= mesh.vertices.size()) {
      file_.Fail(
          at, fmt::format("a face has vertex {}, and there are {}", index, mesh.vertices.size()));
    }
    return static_cast<int>(index);
  }

  // Cuts a face up.
  // `uv`: texture coordinates of its corners, as many or none.
  void AddFace(const std::vector<int>& face, int slot, const std::vector<Vec2>& uv,
               LocalMesh& mesh) const {
    std::vector<Vec3> corners;
    for (const int i : face) corners.push_back(mesh.vertices[static_cast<std::size_t>(i)]);
    for (const auto& [a, b, c] : Triangulate(corners)) {
      mesh.triangles.push_back({face[static_cast<std::size_t>(a)],
                                face[static_cast<std::size_t>(b)],
                                face[static_cast<std::size_t>(c)]});
      mesh.slot_of.push_back(slot);
      mesh.face_of.push_back(mesh.faces);
      if (uv.size() != face.size()) continue;
      mesh.uv_of.push_back({uv[static_cast<std::size_t>(a)], uv[static_cast<std::size_t>(b)],
                            uv[static_cast<std::size_t>(c)]});
    }
    ++mesh.faces;
    CheckTriangles(mesh.triangles.size());
  }

  // From 2.63 on a mesh is of polygons: runs of corners.
  void ReadPolygons(std::size_t id, const BlendRecord& record, LocalMesh& mesh) {
    const Elements polygons = ElementsOf(id, record, "totpoly", "mpoly", "MPoly");
    const Elements loops = ElementsOf(id, record, "totloop", "mloop", "MLoop");
    if (polygons.count == 0) return;
    const std::size_t first_at = MemberOf(polygons, "loopstart", 4);
    const std::size_t count_at = MemberOf(polygons, "totloop", 4);
    const std::size_t slot_at = MemberOf(polygons, "mat_nr", 2);
    const std::size_t vertex_at = loops.count > 0 ? MemberOf(loops, "v", 4) : 0;
    const bool has_uv = loops.count > 0 && record.Has("mloopuv") && !coatings_.empty() &&
                        DataAt(id, record.Pointer("mloopuv")) != nullptr;
    const Elements coordinates =
        has_uv ? ElementsOf(id, record, "totloop", "mloopuv", "MLoopUV") : Elements{};
    const std::size_t uv_at = coordinates.count > 0 ? MemberOf(coordinates, "uv", 4) : 0;
    std::vector<Vec2> uv;
    // Corners of polygons do not overlap, or a small file could have a great many.
    std::size_t used = 0;
    std::vector<int> face;
    for (std::size_t i = 0; i < polygons.count; ++i) {
      const std::size_t at = polygons.offset + i * polygons.type->size;
      const std::int64_t first = file_.Signed(at + first_at, 4);
      const std::int64_t count = file_.Signed(at + count_at, 4);
      used += static_cast<std::size_t>(std::max<std::int64_t>(0, count));
      if (first < 0 || count < 0 || static_cast<std::uint64_t>(first) > loops.count ||
          static_cast<std::uint64_t>(count) > loops.count - static_cast<std::uint64_t>(first) ||
          used > loops.count) {
        file_.Fail(at, fmt::format("a face has corners {} to {}, and there are {}", first,
                                   first + count, loops.count));
      }
      face.clear();
      uv.clear();
      for (std::int64_t k = first; k < first + count; ++k) {
        const std::size_t corner =
            loops.offset + static_cast<std::size_t>(k) * loops.type->size + vertex_at;
        face.push_back(Vertex(file_.Signed(corner, 4), corner, mesh));
        if (coordinates.count == 0) continue;
        const std::size_t place =
            coordinates.offset + static_cast<std::size_t>(k) * coordinates.type->size + uv_at;
        uv.push_back({file_.Float(place), file_.Float(place + 4)});
      }
      AddFace(face, static_cast<int>(file_.Signed(at + slot_at, 2)), uv, mesh);
    }
  }

  // Until 2.62 of triangles and quads.
  void ReadFaces(std::size_t id, const BlendRecord& record, LocalMesh& mesh) {
    const Elements faces = ElementsOf(id, record, "totface", "mface", "MFace");
    if (faces.count == 0) return;
    const std::array<std::size_t, 4> corner_at = {
        MemberOf(faces, "v1", 4), MemberOf(faces, "v2", 4), MemberOf(faces, "v3", 4),
        MemberOf(faces, "v4", 4)};
    // A short before 2.63's versions of the struct, too.
    const auto slot = faces.type->fields.find("mat_nr");
    const bool has_uv = record.Has("mtface") && !coatings_.empty() &&
                        DataAt(id, record.Pointer("mtface")) != nullptr;
    const Elements coordinates =
        has_uv ? ElementsOf(id, record, "totface", "mtface", "MTFace") : Elements{};
    const std::size_t uv_at = coordinates.count > 0 ? MemberOf(coordinates, "uv", 4) : 0;
    std::vector<Vec2> uv;
    std::vector<int> face;
    for (std::size_t i = 0; i < faces.count; ++i) {
      const std::size_t at = faces.offset + i * faces.type->size;
      face.clear();
      uv.clear();
      for (std::size_t k = 0; k < 4; ++k) {
        const std::int64_t vertex = file_.Signed(at + corner_at[k], 4);
        if (k == 3 && vertex == 0) break;  // a triangle
        face.push_back(Vertex(vertex, at + corner_at[k], mesh));
        if (coordinates.count == 0) continue;
        const std::size_t place = coordinates.offset + i * coordinates.type->size + uv_at + 8 * k;
        uv.push_back({file_.Float(place), file_.Float(place + 4)});
      }
      const bool has_slot = slot != faces.type->fields.end() && slot->second.size <= 4;
      AddFace(face,
              has_slot ? static_cast<int>(file_.Signed(at + slot->second.offset, slot->second.size))
                       : 0,
              uv, mesh);
    }
  }

  // The materials in an object's slots: its own, or its mesh's.
  std::vector<int> SlotsOf(std::size_t index, std::size_t mesh_id, const BlendRecord& mesh) {
    const BlendRecord& object = records_[index];
    const std::vector<std::uint64_t> shared = Pointers(mesh_id, mesh.Pointer("mat"));
    const std::vector<std::uint64_t> own = Pointers(ids_[index], object.Pointer("mat"));
    const BlendBlock* const bits = DataAt(ids_[index], object.Pointer("matbits"));
    std::vector<int> slots;
    for (std::size_t i = 0; i < std::max(shared.size(), own.size()); ++i) {
      const bool is_own = bits != nullptr && i < bits->size && file_.bytes()[bits->offset + i] != 0;
      const std::vector<std::uint64_t>& from = is_own ? own : shared;
      const auto found = i < from.size() ? material_at_.find(from[i]) : material_at_.end();
      slots.push_back(found != material_at_.end() ? found->second : -1);
    }
    return slots;
  }

  void AddMesh(std::size_t index) {
    AssetObject& object = scene_.objects[index];
    const auto [id, record] = IdAt(records_[index].Pointer("data"), "Mesh");
    if (!record) {
      scene_.notes.push_back(fmt::format("object '{}' has a mesh of another file", object.name));
      return;
    }
    const LocalMesh& mesh = MeshAt(id, record);
    const std::vector<int> slots = SlotsOf(index, id, record);
    Take(mesh.vertices, mesh.triangles, object.matrix, object);
    object.faces = mesh.faces;
    object.material_of.clear();
    for (const int slot : kept_) {
      const int wanted = mesh.slot_of[static_cast<std::size_t>(slot)];
      object.material_of.push_back(wanted >= 0 && static_cast<std::size_t>(wanted) < slots.size()
                                       ? slots[static_cast<std::size_t>(wanted)]
                                       : -1);
    }
    if (mesh.uv_of.size() == mesh.triangles.size()) AddColors(mesh, object);
  }

  // What pictures show of each triangle that they are laid on.
  void AddColors(const LocalMesh& mesh, AssetObject& object) const {
    const auto coating_of = [this](int material) {
      const auto found = coatings_.find(material);
      return found != coatings_.end() && found->second.by_coordinates ? &found->second : nullptr;
    };
    const bool any = std::any_of(object.material_of.begin(), object.material_of.end(),
                                 [&](int material) { return coating_of(material) != nullptr; });
    if (!any) return;
    // The triangles of a face have one colour, or one would see how it was cut up.
    std::unordered_map<int, std::array<double, 4>> sum_of;
    const auto triangle_of = [this](std::size_t i) { return static_cast<std::size_t>(kept_[i]); };
    for (std::size_t i = 0; i < kept_.size(); ++i) {
      const Coating* const coating = coating_of(object.material_of[i]);
      if (coating == nullptr) continue;
      const auto& [a, b, c] = object.triangles[i];
      const Vec3& first = object.vertices[static_cast<std::size_t>(a)];
      const Vec3 normal = Cross(object.vertices[static_cast<std::size_t>(b)] - first,
                                object.vertices[static_cast<std::size_t>(c)] - first);
      const double area = std::sqrt(Dot(normal, normal));
      const Color mean = MeanOf(*coating, mesh.uv_of[triangle_of(i)]);
      std::array<double, 4>& sum = sum_of[mesh.face_of[triangle_of(i)]];
      sum[0] += area * mean.r;
      sum[1] += area * mean.g;
      sum[2] += area * mean.b;
      sum[3] += area;
    }
    for (std::size_t i = 0; i < kept_.size(); ++i) {
      const int index = object.material_of[i];
      Color color{204, 204, 204};
      if (index >= 0) {
        const AssetMaterial& material = scene_.materials[static_cast<std::size_t>(index)];
        color = material.pictured.value_or(material.color);
        if (const Coating* const coating = coating_of(index)) {
          const std::array<double, 4>& sum = sum_of[mesh.face_of[triangle_of(i)]];
          const auto share = [&sum](std::size_t k) {
            return static_cast<std::uint8_t>(std::lround(sum[k] / sum[3]));
          };
          color = Coated(*coating, material.color, {share(0), share(1), share(2)});
        }
      }
      object.color_of.push_back(color);
    }
  }

  // Puts the mesh into the world as the object's; kept_ says which triangles have an area there.
  void Take(const std::vector<Vec3>& vertices, const std::vector<std::array<int, 3>>& triangles,
            const Affine& matrix, AssetObject& object) {
    total_triangles_ += triangles.size();
    total_vertices_ += vertices.size();
    CheckTriangles(std::max(total_triangles_, total_vertices_ / 3));
    object.vertices.reserve(vertices.size());
    for (const Vec3& vertex : vertices) {
      object.vertices.push_back(matrix(vertex));
      if (!IsFinite(object.vertices.back())) {
        throw Error(fmt::format("{}: object '{}' reaches beyond all numbers", file_.name(),
                                OneLine(object.name)));
      }
    }
    const bool mirrored = matrix.Determinant() < 0.0;
    kept_.clear();
    object.triangles.reserve(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      auto [a, b, c] = triangles[i];
      if (mirrored) std::swap(b, c);  // its outside stays outside
      const auto at = [&](int k) { return object.vertices[static_cast<std::size_t>(k)]; };
      if (!HasArea(at(a), at(b), at(c))) continue;
      object.triangles.push_back({a, b, c});
      kept_.push_back(static_cast<int>(i));
    }
  }

  void CheckTriangles(std::size_t count) const {
    if (count > limits_.triangles) {
      throw Error(fmt::format("{}: has more than {} triangles", file_.name(), limits_.triangles));
    }
  }

  // Which objects are seen, gravity and the camera: what the scene says that was open last.
  void ReadScene() {
    std::size_t id = 0;
    BlendRecord record;
    EachId("GLOB", "FileGlobal", [&](std::size_t, const BlendRecord& global) {
      std::tie(id, record) = IdAt(global.Pointer("curscene"), "Scene");
    });
    if (!record) {
      EachId("SC", "Scene", [&](std::size_t found, const BlendRecord& scene) {
        if (record) return;
        id = found;
        record = scene;
      });
    }
    if (!record) return;  // a library of objects: all are shown
    for (AssetObject& object : scene_.objects) object.shown = false;
    const std::int64_t layers = record.Int("lay", -1);
    EachOfList(id, record, "base", "Base", [&](const BlendRecord& base) {
      const auto object = object_at_.find(base.Pointer("object"));
      if (object == object_at_.end()) return;
      AssetObject& found = scene_.objects[static_cast<std::size_t>(object->second)];
      found.shown = (base.Int("lay", 1) & layers) != 0;
    });
    const auto camera = object_at_.find(record.Pointer("camera"));
    if (camera != object_at_.end()) scene_.camera = camera->second;
    const BlendRecord game = record.Part("gm");
    if (game && game.Has("gravity")) {
      scene_.gravity = {0.0, 0.0, -FiniteOr(game.Number("gravity"), 9.81)};
    }
  }

  // Objects that stand for groups: each gets copies of the group's objects.
  void ExpandGroups() {
    const std::size_t count = scene_.objects.size();
    for (std::size_t i = 0; i < count; ++i) {
      Expand(i, i, scene_.objects[i].matrix, scene_.objects[i].name, 1);
    }
  }

  void Expand(std::size_t index, std::size_t top, const Affine& matrix, const std::string& name,
              int depth) {
    const BlendRecord& record = records_[index];
    const std::uint64_t address = record.Pointer("dup_group");
    if (address == 0 || (record.Int("transflag") & kDupliGroup) == 0) return;
    const auto [id, group] = IdAt(address, "Group");
    if (!group) {
      scene_.notes.push_back(fmt::format("object '{}' stands for a group of another file",
                                         scene_.objects[index].name));
      return;
    }
    if (depth > kDeepestGroup) {
      scene_.notes.push_back(fmt::format("groups within groups of '{}' are too many", name));
      return;
    }
    Affine moved;
    moved.position = -1.0 * VectorOf(group, "dupli_ofs");
    const Affine to_world = matrix * moved;
    EachOfList(id, group, "gobject", "GroupObject", [&](const BlendRecord& member) {
      const auto found = object_at_.find(member.Pointer("ob"));
      if (found == object_at_.end() || static_cast<std::size_t>(found->second) == index) return;
      const auto from = static_cast<std::size_t>(found->second);
      const AssetObject& original = scene_.objects[from];
      if (scene_.objects.size() >= limits_.objects) {
        file_.Fail(record.offset(), fmt::format("more than {} objects", limits_.objects));
      }
      AssetObject copy;
      copy.name = name + "/" + original.name;
      copy.type = original.type;
      copy.parent = static_cast<int>(top);
      copy.matrix = to_world * original.matrix;
      copy.layers = scene_.objects[top].layers;
      copy.shown = scene_.objects[top].shown;
      copy.hidden = original.hidden;
      copy.instance = true;
      copy.physics = original.physics;
      copy.properties = original.properties;
      copy.light = original.light;
      copy.faces = original.faces;
      const Affine placed = copy.matrix;
      CopyMesh(from, to_world, copy);
      const std::string copied = copy.name;
      scene_.objects.push_back(std::move(copy));
      Expand(from, top, placed, copied, depth + 1);
    });
  }

  void CopyMesh(std::size_t from, const Affine& to_world, AssetObject& copy) {
    const AssetObject& original = scene_.objects[from];
    Take(original.vertices, original.triangles, to_world, copy);
    for (const int kept : kept_) {
      copy.material_of.push_back(original.material_of[static_cast<std::size_t>(kept)]);
      if (original.color_of.empty()) continue;
      copy.color_of.push_back(original.color_of[static_cast<std::size_t>(kept)]);
    }
  }

  void NoteModifiers() {
    for (std::size_t i = 0; i < ids_.size(); ++i) {
      if (records_[i].Int("type") != kMeshType) continue;
      std::string names;
      EachOfList(ids_[i], records_[i], "modifiers", "ModifierData",
                 [&](const BlendRecord& modifier) {
                   const std::int64_t type = modifier.Int("type");
                   if (LeavesShape(type)) return;
                   names += (names.empty() ? "" : ", ") + ModifierName(type);
                 });
      if (!names.empty()) {
        scene_.notes.push_back(fmt::format("object '{}' has modifiers that are not applied: {}",
                                           scene_.objects[i].name, names));
      }
    }
  }

  const BlendFile& file_;
  const AssetLimits& limits_;
  const FindFile& find_;
  AssetScene scene_;
  std::unordered_map<std::uint64_t, std::size_t> id_at_;  // address -> block
  std::unordered_map<std::size_t, DataMap> data_of_;
  std::unordered_map<std::uint64_t, int> image_at_;  // address -> index
  std::vector<std::size_t> image_ids_;               // blocks, by image
  std::unordered_map<int, std::optional<Picture>> pictures_;
  std::unordered_map<int, Coating> coatings_;  // by material
  std::unordered_map<std::uint64_t, int> material_at_;
  std::unordered_map<std::uint64_t, int> object_at_;
  std::vector<std::size_t> ids_;  // blocks, by object
  std::vector<BlendRecord> records_;
  std::unordered_map<std::size_t, LocalMesh> meshes_;  // by block
  std::vector<int> kept_;
  std::size_t total_triangles_ = 0;
  std::size_t total_vertices_ = 0;
};

}  // namespace

AssetScene ReadBlend(Bytes bytes, const std::string& name, const AssetLimits& limits,
                     const FindFile& find) {
  if (IsGzip(bytes)) bytes = Gunzip(bytes, name, limits.bytes);
  const BlendFile file(std::move(bytes), name);
  return BlendReader(file, limits, find).Read();
}

}  // namespace ccmorse::assets
