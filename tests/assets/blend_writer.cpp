#include "tests/assets/blend_writer.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>

namespace ccmorse::test {

std::size_t BlendWriter::SizeOf(const std::string& type) const {
  static const std::map<std::string, std::size_t> plain = {
      {"char", 1}, {"short", 2}, {"int", 4}, {"float", 4}, {"void", 0}};
  const auto found = plain.find(type);
  if (found != plain.end()) return found->second;
  for (const Type& known : types_) {
    if (known.name == type) return known.size;
  }
  return 0;  // only ever pointed to
}

void BlendWriter::Struct(const std::string& name,
                         std::vector<std::pair<std::string, std::string>> members) {
  Type type;
  type.name = name;
  for (auto& [of_type, text] : members) {
    Member member{of_type, text, text, false, 1, type.size};
    while (member.plain.starts_with('*')) {
      member.pointer = true;
      member.plain.erase(0, 1);
    }
    for (std::size_t at = member.plain.find('['); at != std::string::npos;
         at = member.plain.find('[', at + 1)) {
      member.count *= static_cast<std::size_t>(std::atoi(&member.plain[at + 1]));
    }
    member.plain = member.plain.substr(0, member.plain.find('['));
    type.size += member.count * (member.pointer ? (wide_ ? 8 : 4) : SizeOf(of_type));
    type.members.push_back(std::move(member));
  }
  types_.push_back(std::move(type));
}

std::uint64_t BlendWriter::Add(const std::string& code, const std::string& type,
                               std::size_t count) {
  for (std::size_t i = 0; i < types_.size(); ++i) {
    if (types_[i].name != type) continue;
    Block block;
    block.code = code;
    block.type = i;
    block.count = count;
    block.address = 0x1000 * (blocks_.size() + 1);
    block.bytes.resize(count * types_[i].size);
    blocks_.push_back(std::move(block));
    return blocks_.back().address;
  }
  std::abort();
}

std::uint64_t BlendWriter::AddBytes(const std::string& type, std::vector<std::uint8_t> bytes) {
  const std::uint64_t address = Add("DATA", type);
  blocks_.back().bytes = std::move(bytes);
  return address;
}

std::uint64_t BlendWriter::AddPointers(const std::vector<std::uint64_t>& pointers) {
  std::vector<std::uint8_t> bytes;
  for (const std::uint64_t pointer : pointers) Put(bytes, pointer, wide_ ? 8 : 4);
  return AddBytes(types_[0].name, std::move(bytes));
}

void BlendWriter::ReplacePointers(std::uint64_t address,
                                  const std::vector<std::uint64_t>& pointers) {
  At(address).bytes.clear();
  for (const std::uint64_t pointer : pointers) Put(At(address).bytes, pointer, wide_ ? 8 : 4);
}

void BlendWriter::Put(std::vector<std::uint8_t>& out, std::uint64_t value, std::size_t size) const {
  for (std::size_t i = 0; i < size; ++i) {
    out.push_back(static_cast<std::uint8_t>(value >> (8 * (big_ ? size - 1 - i : i))));
  }
}

BlendWriter::Block& BlendWriter::At(std::uint64_t address) {
  return blocks_[static_cast<std::size_t>(address / 0x1000 - 1)];
}

std::pair<std::size_t, std::string> BlendWriter::Find(const Block& block, const std::string& path,
                                                      std::size_t element,
                                                      std::size_t index) const {
  const Type* type = &types_[block.type];
  std::size_t offset = index * type->size;
  for (std::size_t from = 0;;) {
    const std::size_t dot = path.find('.', from);
    const std::string name = path.substr(from, dot - from);
    const auto member = std::find_if(type->members.begin(), type->members.end(),
                                     [&name](const Member& m) { return m.plain == name; });
    if (member == type->members.end()) std::abort();
    offset += member->offset;
    if (dot == std::string::npos) {
      const std::size_t size = member->pointer ? (wide_ ? 8 : 4) : SizeOf(member->type);
      return {offset + element * size, member->pointer ? "" : member->type};
    }
    type = &*std::find_if(types_.begin(), types_.end(),
                          [&](const Type& t) { return t.name == member->type; });
    from = dot + 1;
  }
}

void BlendWriter::Set(std::uint64_t address, const std::string& path, double value,
                      std::size_t element, std::size_t index) {
  Block& block = At(address);
  const auto [offset, type] = Find(block, path, element, index);
  std::vector<std::uint8_t> bytes;
  if (type == "float") {
    Put(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(value)), 4);
  } else {
    Put(bytes, static_cast<std::uint64_t>(static_cast<std::int64_t>(value)), SizeOf(type));
  }
  std::copy(bytes.begin(), bytes.end(), block.bytes.begin() + static_cast<std::ptrdiff_t>(offset));
}

void BlendWriter::SetPointer(std::uint64_t address, const std::string& path, std::uint64_t to,
                             std::size_t element) {
  Block& block = At(address);
  std::vector<std::uint8_t> bytes;
  Put(bytes, to, wide_ ? 8 : 4);
  std::copy(bytes.begin(), bytes.end(),
            block.bytes.begin() + static_cast<std::ptrdiff_t>(Find(block, path, element, 0).first));
}

void BlendWriter::SetText(std::uint64_t address, const std::string& path, const std::string& text) {
  Block& block = At(address);
  std::copy(text.begin(), text.end(),
            block.bytes.begin() + static_cast<std::ptrdiff_t>(Find(block, path, 0, 0).first));
}

std::vector<std::uint8_t> BlendWriter::Write() const {
  std::vector<std::uint8_t> out;
  const std::string head =
      std::string("BLENDER") + (wide_ ? '-' : '_') + (big_ ? 'V' : 'v') + std::to_string(version_);
  out.assign(head.begin(), head.end());
  const auto block = [&](const std::string& code, const std::vector<std::uint8_t>& bytes,
                         std::uint64_t address, std::size_t type, std::size_t count) {
    for (std::size_t i = 0; i < 4; ++i) {
      out.push_back(i < code.size() ? static_cast<std::uint8_t>(code[i]) : 0);
    }
    Put(out, bytes.size(), 4);
    Put(out, address, wide_ ? 8 : 4);
    Put(out, type, 4);
    Put(out, count, 4);
    out.insert(out.end(), bytes.begin(), bytes.end());
  };
  for (const Block& each : blocks_) {
    block(each.code, each.bytes, each.address, each.type, each.count);
  }
  // The description: names, types, sizes, structs.
  std::vector<std::string> names;
  std::vector<std::string> type_names = {"char", "short", "int", "float", "void"};
  const auto index_in = [](std::vector<std::string>& list, const std::string& text) {
    const auto found = std::find(list.begin(), list.end(), text);
    if (found != list.end()) return static_cast<std::size_t>(found - list.begin());
    list.push_back(text);
    return list.size() - 1;
  };
  std::vector<std::uint8_t> structs;
  Put(structs, types_.size(), 4);
  for (const Type& type : types_) {
    Put(structs, index_in(type_names, type.name), 2);
    Put(structs, type.members.size(), 2);
    for (const Member& member : type.members) {
      Put(structs, index_in(type_names, member.type), 2);
      Put(structs, index_in(names, member.name), 2);
    }
  }
  std::vector<std::uint8_t> dna;
  const auto text = [&dna](const std::string& letters) {
    dna.insert(dna.end(), letters.begin(), letters.end());
  };
  const auto align = [&dna] { dna.resize((dna.size() + 3) & ~std::size_t{3}); };
  const auto list = [&](const std::string& tag, const std::vector<std::string>& texts) {
    align();
    text(tag);
    Put(dna, texts.size(), 4);
    for (const std::string& each : texts) {
      text(each);
      dna.push_back(0);
    }
  };
  text("SDNA");
  list("NAME", names);
  list("TYPE", type_names);
  align();
  text("TLEN");
  for (const std::string& type : type_names) Put(dna, SizeOf(type), 2);
  align();
  text("STRC");
  dna.insert(dna.end(), structs.begin(), structs.end());
  block("DNA1", dna, 0, 0, 1);
  block("ENDB", {}, 0, 0, 0);
  return out;
}

std::vector<std::uint8_t> Gzip(const std::vector<std::uint8_t>& bytes) {
  z_stream stream{};
  deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, 16 + MAX_WBITS, 8, Z_DEFAULT_STRATEGY);
  std::vector<std::uint8_t> out(bytes.size() + 1000);
  stream.next_in = const_cast<Bytef*>(bytes.data());
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = out.data();
  stream.avail_out = static_cast<uInt>(out.size());
  deflate(&stream, Z_FINISH);
  out.resize(out.size() - stream.avail_out);
  deflateEnd(&stream);
  return out;
}

namespace {

void Describe(BlendWriter& w) {
  w.Struct("ID", {{"void", "*next"}, {"char", "name[24]"}});
  w.Struct("ListBase", {{"void", "*first"}, {"void", "*last"}});
  w.Struct("Object", {{"ID", "id"},
                      {"short", "type"},
                      {"short", "partype"},
                      {"Object", "*parent"},
                      {"void", "*data"},
                      {"Material", "**mat"},
                      {"char", "*matbits"},
                      {"int", "totcol"},
                      {"float", "loc[3]"},
                      {"float", "dloc[3]"},
                      {"float", "size[3]"},
                      {"float", "dscale[3]"},
                      {"float", "rot[3]"},
                      {"float", "drot[3]"},
                      {"float", "quat[4]"},
                      {"float", "dquat[4]"},
                      {"short", "rotmode"},
                      {"short", "pad"},
                      {"float", "parentinv[4][4]"},
                      {"int", "lay"},
                      {"int", "gameflag"},
                      {"int", "gameflag2"},
                      {"float", "mass"},
                      {"float", "damping"},
                      {"float", "inertia"},
                      {"float", "formfactor"},
                      {"float", "rdamping"},
                      {"float", "margin"},
                      {"char", "boundtype"},
                      {"char", "collision_boundtype"},
                      {"short", "pad2"},
                      {"ListBase", "prop"},
                      {"Group", "*dup_group"},
                      {"short", "transflag"},
                      {"char", "restrictflag"},
                      {"char", "pad3"}});
  w.Struct("Mesh", {{"ID", "id"},
                    {"Material", "**mat"},
                    {"MPoly", "*mpoly"},
                    {"MLoop", "*mloop"},
                    {"MFace", "*mface"},
                    {"MVert", "*mvert"},
                    {"int", "totvert"},
                    {"int", "totface"},
                    {"int", "totpoly"},
                    {"int", "totloop"}});
  w.Struct("MVert",
           {{"float", "co[3]"}, {"short", "no[3]"}, {"char", "flag"}, {"char", "bweight"}});
  w.Struct("MPoly", {{"int", "loopstart"},
                     {"int", "totloop"},
                     {"short", "mat_nr"},
                     {"char", "flag"},
                     {"char", "pad"}});
  w.Struct("MLoop", {{"int", "v"}, {"int", "e"}});
  w.Struct("MFace", {{"int", "v1"},
                     {"int", "v2"},
                     {"int", "v3"},
                     {"int", "v4"},
                     {"short", "mat_nr"},
                     {"char", "edcode"},
                     {"char", "flag"}});
  w.Struct("Material", {{"ID", "id"},
                        {"float", "r"},
                        {"float", "g"},
                        {"float", "b"},
                        {"float", "spec"},
                        {"float", "alpha"},
                        {"float", "friction"},
                        {"float", "reflect"}});
  w.Struct("bProperty", {{"bProperty", "*next"},
                         {"bProperty", "*prev"},
                         {"char", "name[16]"},
                         {"short", "type"},
                         {"short", "flag"},
                         {"int", "data"},
                         {"void", "*poin"}});
  w.Struct("Lamp", {{"ID", "id"}, {"short", "type"}, {"short", "pad"}, {"float", "energy"}});
  w.Struct("Camera", {{"ID", "id"}, {"float", "lens"}, {"float", "clipsta"}, {"float", "clipend"}});
  w.Struct("Base", {{"Base", "*next"},
                    {"Base", "*prev"},
                    {"int", "lay"},
                    {"int", "flag"},
                    {"Object", "*object"}});
  w.Struct("GameData", {{"float", "gravity"}, {"int", "pad"}});
  w.Struct("Scene", {{"ID", "id"},
                     {"Object", "*camera"},
                     {"ListBase", "base"},
                     {"int", "lay"},
                     {"int", "pad"},
                     {"GameData", "gm"}});
}

constexpr double kQuarter = 1.5707963267948966;
constexpr int kCollision = 1 << 16;

std::uint64_t AddObject(BlendWriter& w, const std::string& name, int type) {
  const std::uint64_t object = w.Add("OB", "Object");
  w.SetText(object, "id.name", "OB" + name);
  w.Set(object, "type", type);
  w.Set(object, "rotmode", 1);
  w.Set(object, "lay", 1);
  w.Set(object, "gameflag", kCollision);
  for (std::size_t i = 0; i < 3; ++i) {
    w.Set(object, "size", 1.0, i);
    w.Set(object, "dscale", 1.0, i);
  }
  for (std::size_t i = 0; i < 4; ++i) w.Set(object, "parentinv", 1.0, 5 * i);
  return object;
}

}  // namespace

std::vector<std::uint8_t> SampleBlend(const SampleOptions& options) {
  BlendWriter w(options.wide, options.big, options.version);
  Describe(w);
  const std::uint64_t base = AddObject(w, "Base", 0);
  w.Set(base, "loc", 1.0, 0);
  w.Set(base, "loc", 2.0, 1);
  w.Set(base, "loc", 3.0, 2);
  w.Set(base, "rot", kQuarter, 2);
  w.Set(base, "gameflag", 0);
  const std::uint64_t crate = AddObject(w, "Crate", 1);
  constexpr int kDynamic = 1;
  constexpr int kActor = 1 << 2;
  constexpr int kRigid = 1 << 10;
  constexpr int kBounds = 1 << 11;
  w.Set(crate, "gameflag", kCollision | kDynamic | kActor | kRigid | kBounds);
  w.Set(crate, "collision_boundtype", 5);
  w.Set(crate, "mass", 5.0);
  w.Set(crate, "damping", 0.25);
  w.Set(crate, "rdamping", 0.5);
  w.Set(crate, "inertia", 1.5);
  w.Set(crate, "margin", 0.0625);
  w.Set(crate, "loc", 0.25, 2);
  w.Set(crate, "dloc", 0.25, 2);
  w.Set(crate, "dscale", 2.0, 0);
  w.SetPointer(crate, "parent", base);
  if (options.cycle) w.SetPointer(base, "parent", crate);
  // The list of properties, each with its struct, in the object's own data.
  std::vector<std::uint64_t> properties;
  const auto property = [&](const std::string& name, int type, int data) {
    properties.push_back(w.Add("DATA", "bProperty"));
    w.SetText(properties.back(), "name", name);
    w.Set(properties.back(), "type", type);
    w.Set(properties.back(), "data", data);
  };
  property("Object", 0, 1);
  property("Label", 3, 0);
  property("Count", 1, 7);
  property("Weight", 2, std::bit_cast<std::int32_t>(2.5F));
  w.SetPointer(properties[1], "poin", w.AddBytes("ID", {'b', 'o', 'x', 0}));
  w.SetPointer(crate, "prop.first", properties[0]);
  for (std::size_t i = 0; i + 1 < properties.size(); ++i) {
    w.SetPointer(properties[i], "next", properties[i + 1]);
  }
  const std::uint64_t far = AddObject(w, "Far", 1);
  w.Set(far, "loc", 500.0, 0);
  w.Set(far, "lay", 2);
  const std::uint64_t sun = AddObject(w, "Sun", 10);
  const std::uint64_t eye = AddObject(w, "Eye", 11);
  w.Set(eye, "rotmode", 0);  // a quaternion: a quarter about x
  w.Set(eye, "quat", 1.0, 0);
  w.Set(eye, "quat", 1.0, 1);
  w.Set(eye, "dquat", 1.0, 0);

  const std::uint64_t mesh = w.Add("ME", "Mesh");
  w.SetText(mesh, "id.name", "MECube");
  w.Set(mesh, "totvert", 8);
  const std::uint64_t vertices = w.Add("DATA", "MVert", 8);
  w.SetPointer(mesh, "mvert", vertices);
  for (std::size_t i = 0; i < 8; ++i) {
    w.Set(vertices, "co", (i & 1U) != 0 ? 0.5 : -0.5, 0, i);
    w.Set(vertices, "co", (i & 2U) != 0 ? 0.5 : -0.5, 1, i);
    w.Set(vertices, "co", (i & 4U) != 0 ? 0.5 : -0.5, 2, i);
  }
  // Sides counter-clockwise from outside, none with vertex 0 last: MFace calls that a triangle.
  const std::array<std::array<int, 4>, 6> sides = {
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  if (options.faces) {
    w.Set(mesh, "totface", 6);
    const std::uint64_t faces = w.Add("DATA", "MFace", 6);
    w.SetPointer(mesh, "mface", faces);
    for (std::size_t i = 0; i < 6; ++i) {
      for (std::size_t k = 0; k < 4; ++k) {
        w.Set(faces, "v" + std::to_string(k + 1), sides[i][k], 0, i);
      }
    }
    if (options.bad_vertex) w.Set(faces, "v2", 8, 0, 3);
  } else {
    w.Set(mesh, "totpoly", 6);
    w.Set(mesh, "totloop", 24);
    const std::uint64_t polygons = w.Add("DATA", "MPoly", 6);
    const std::uint64_t loops = w.Add("DATA", "MLoop", 24);
    w.SetPointer(mesh, "mpoly", polygons);
    w.SetPointer(mesh, "mloop", loops);
    for (std::size_t i = 0; i < 6; ++i) {
      w.Set(polygons, "loopstart", static_cast<double>(4 * i), 0, i);
      w.Set(polygons, "totloop", 4, 0, i);
      for (std::size_t k = 0; k < 4; ++k) w.Set(loops, "v", sides[i][k], 0, 4 * i + k);
    }
    if (options.bad_vertex) w.Set(loops, "v", 8, 0, 13);
  }
  const std::uint64_t slots = w.AddPointers({0});
  w.SetPointer(mesh, "mat", slots);
  w.SetPointer(crate, "data", mesh);
  w.SetPointer(far, "data", mesh);

  const std::uint64_t red = w.Add("MA", "Material");
  w.SetText(red, "id.name", "MARed");
  w.Set(red, "r", 1.0);
  w.Set(red, "g", 0.2);
  w.Set(red, "alpha", 1.0);
  w.Set(red, "spec", 0.5);
  w.Set(red, "friction", 0.75);
  w.ReplacePointers(slots, {red});

  const std::uint64_t lamp = w.Add("LA", "Lamp");
  w.SetText(lamp, "id.name", "LASun");
  w.Set(lamp, "type", 1);
  w.Set(lamp, "energy", 0.75);
  w.SetPointer(sun, "data", lamp);
  const std::uint64_t camera = w.Add("CA", "Camera");
  w.SetText(camera, "id.name", "CAEye");
  w.Set(camera, "lens", 16.0);
  w.Set(camera, "clipend", 100.0);
  w.SetPointer(eye, "data", camera);

  const std::uint64_t scene = w.Add("SC", "Scene");
  w.SetText(scene, "id.name", "SCScene");
  w.Set(scene, "lay", 1);
  w.Set(scene, "gm.gravity", 9.5);
  w.SetPointer(scene, "camera", eye);
  std::uint64_t before = 0;
  for (const std::uint64_t object : {base, crate, far, sun, eye}) {
    const std::uint64_t entry = w.Add("DATA", "Base");
    w.SetPointer(entry, "object", object);
    w.Set(entry, "lay", object == far ? 2 : 1);
    if (before == 0) {
      w.SetPointer(scene, "base.first", entry);
    } else {
      w.SetPointer(before, "next", entry);
    }
    before = entry;
  }
  std::vector<std::uint8_t> bytes = w.Write();
  return options.packed ? Gzip(bytes) : bytes;
}

}  // namespace ccmorse::test
