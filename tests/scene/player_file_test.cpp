// The language that Player's .cfg and Stage's .world files share (specs: player.md C.1).

#include "scene/player/player_file.h"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/trig.h"

namespace ccmorse::scene {
namespace {

PlayerFile ParseFile(const std::string& text, PlayerDialect dialect = PlayerDialect::kWorld,
                     const std::map<std::string, std::string>& files = {}) {
  return ParsePlayerFile(text, "dir/test.world", dialect, [files](const std::string& path) {
    const auto found = files.find(path);
    if (found == files.end()) throw Error("cannot read " + path);
    return found->second;
  });
}

std::string FileError(const std::string& text, PlayerDialect dialect = PlayerDialect::kWorld,
                      const std::map<std::string, std::string>& files = {}) {
  try {
    ParseFile(text, dialect, files);
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(PlayerFileC1, CommentsEndWithTheLine) {
  const PlayerFile file = ParseFile("# a 1\na 2 # a 3\n#\n");
  ASSERT_EQ(file.global.properties.size(), 1U);
  EXPECT_EQ(file.global.properties[0].value.number, 2.0);
  EXPECT_EQ(file.global.properties[0].value.at.line, 2);
}

TEST(PlayerFileC1, NumbersAreRunsOfSignsPointsAndDigits) {
  const PlayerFile file = ParseFile("a -1.5 b +2 c .25 d 3.");
  EXPECT_EQ(file.global.properties[0].value.number, -1.5);
  EXPECT_EQ(file.global.properties[1].value.number, 2.0);
  EXPECT_EQ(file.global.properties[2].value.number, 0.25);
  EXPECT_EQ(file.global.properties[3].value.number, 3.0);
  EXPECT_EQ(FileError("a\n 1-2"), "dir/test.world:2: '1-2' is no number");
  EXPECT_EQ(FileError("a +-1"), "dir/test.world:1: '+-1' is no number");
  EXPECT_NE(FileError("a 1e3").find("no exponent"), std::string::npos);
}

TEST(PlayerFileC1, StringsLieOnOneLineAndHaveNoEscapes) {
  EXPECT_EQ(ParseFile(R"(a "x \n # y")").global.properties[0].value.text, R"(x \n # y)");
  EXPECT_NE(FileError("a \"x\ny\"").find("test.world:1: a string begins here"), std::string::npos);
  EXPECT_EQ(ParseFile("a \"" + std::string(255, 'x') + "\"").global.properties.size(), 1U);
  EXPECT_NE(FileError("a \"" + std::string(256, 'x') + "\"").find("at most 255"),
            std::string::npos);
}

TEST(PlayerFileC1, WordsHaveColonsInACfgOnly) {
  EXPECT_EQ(ParseFile("a:b 1", PlayerDialect::kConfig).global.properties[0].name, "a:b");
  EXPECT_NE(FileError("a:b 1").find("':' has no meaning"), std::string::npos);
  EXPECT_EQ(ParseFile("a.b-c_d9 1").global.properties[0].name, "a.b-c_d9");
}

TEST(PlayerFileC1, IndexedNamesAreOneWord) {
  const PlayerFile file = ParseFile("point[3] [1 2] point[4][5 6] size[7 8]");
  ASSERT_EQ(file.global.properties.size(), 3U);
  EXPECT_EQ(file.global.properties[0].name, "point[3]");
  EXPECT_EQ(file.global.properties[1].name, "point[4]");
  EXPECT_EQ(file.global.properties[1].value.items[1].number, 6.0);
  EXPECT_EQ(file.global.properties[2].name, "size");
}

TEST(PlayerFileC1, TuplesHoldNumbersAndStrings) {
  const PlayerFile file = ParseFile("a [ 1 \"x\"\n 2 ] b []");
  ASSERT_EQ(file.global.properties[0].value.items.size(), 3U);
  EXPECT_EQ(file.global.properties[0].value.items[1].text, "x");
  EXPECT_EQ(file.global.properties[0].value.items[2].at.line, 2);
  EXPECT_TRUE(file.global.properties[1].value.items.empty());
  EXPECT_NE(FileError("a [ 1 ( ]").find("'(' in the tuple of 'a'"), std::string::npos);
  EXPECT_NE(FileError("a [ 1\n2").find(":1: the tuple of 'a' does not end"), std::string::npos);
}

TEST(PlayerFileC1, EntitiesNest) {
  const PlayerFile file = ParseFile("model ( a 1 block ( b 2 ) )\nposition ( )");
  ASSERT_EQ(file.global.children.size(), 2U);
  EXPECT_EQ(file.global.children[0].type, "model");
  EXPECT_EQ(file.global.children[0].children[0].type, "block");
  EXPECT_EQ(file.global.children[1].at.line, 2);
  EXPECT_NE(FileError("model (\n a 1").find(":2: the file ends within the 'model' of line 1"),
            std::string::npos);
  EXPECT_NE(FileError(")").find("')' where a name should stand"), std::string::npos);
  std::string deep;
  for (int i = 0; i < 100; ++i) deep += "a (";
  EXPECT_NE(FileError(deep).find("nested deeper than 64"), std::string::npos);
}

TEST(PlayerFileC1, WhatStandsOutsideBelongsToTheGlobalEntity) {
  const PlayerFile file = ParseFile("name \"w\" model ( name \"m\" )");
  EXPECT_EQ(file.global.properties[0].value.text, "w");
  EXPECT_EQ(file.global.children[0].properties[0].value.text, "m");
}

TEST(PlayerFileC1, LaterValuesOverride) {
  const PlayerFile file = ParseFile("a 1 a 2");
  PropertyReader reader(file.global, file);
  EXPECT_EQ(reader.Number("a", 0.0), 2.0);
}

TEST(PlayerFileC1, MacrosComeFirstAndTheInstanceOverrides) {
  const PlayerFile file = ParseFile(
      "define box model ( size 1 color \"red\" block ( ) )\n"
      "box ( color \"blue\" block ( ) )");
  const PlayerEntity& box = file.global.children[0];
  EXPECT_EQ(box.type, "model");
  EXPECT_EQ(box.written, "box");
  EXPECT_EQ(box.at.line, 2);
  EXPECT_EQ(box.children.size(), 2U);
  PropertyReader reader(box, file);
  EXPECT_EQ(reader.Number("size", 0.0), 1.0);
  EXPECT_EQ(reader.Text("color", ""), "blue");
}

TEST(PlayerFileC1, MacrosBuildOnMacros) {
  const PlayerFile file =
      ParseFile("define a model ( x 1 y 1 ) define b a ( y 2 ) define c b ( a ( ) )\nc ( )");
  const PlayerEntity& c = file.global.children[0];
  EXPECT_EQ(c.type, "model");
  EXPECT_EQ(c.properties.size(), 3U);
  EXPECT_EQ(c.children[0].type, "model");
  EXPECT_EQ(c.children[0].properties.size(), 2U);
  EXPECT_NE(FileError("define a a ( )").find("defined by itself"), std::string::npos);
}

TEST(PlayerFileC1, MacrosThatGrowWithoutEndAreRefused) {
  std::string text = "define m0 model ( a 1 )\n";
  for (int i = 1; i < 40; ++i) {
    const std::string last = "m" + std::to_string(i - 1);
    text += "define m" + std::to_string(i) + " model ( " + last + " ( ) " + last + " ( ) )\n";
  }
  EXPECT_NE(FileError(text).find("more than 200000"), std::string::npos);
}

TEST(PlayerFileC1, IncludesAreNestedAndStartFromTheFirstFile) {
  const std::map<std::string, std::string> files = {{"dir/sub/a.inc", "include \"sub/b.inc\"\na 1"},
                                                    {"dir/sub/b.inc", "\nb 2"}};
  const PlayerFile file = ParseFile("include \"sub/a.inc\" c 3", PlayerDialect::kWorld, files);
  ASSERT_EQ(file.global.properties.size(), 3U);
  EXPECT_EQ(file.global.properties[0].value.at.Text(), "dir/sub/b.inc:2");
  EXPECT_EQ(file.global.properties[2].name, "c");
  EXPECT_EQ(FileError("\ninclude \"none.inc\"").substr(0, 45),
            "dir/test.world:2: cannot read dir/none.inc; n");
}

TEST(PlayerFileC1, AnAbsoluteIncludeIsTakenAsItIs) {
  const PlayerFile file =
      ParseFile("include \"/lib/a.inc\"", PlayerDialect::kWorld, {{"/lib/a.inc", "a 1"}});
  EXPECT_EQ(file.global.properties.size(), 1U);
}

TEST(PlayerFileC1, ACycleOfIncludesIsRefused) {
  const std::map<std::string, std::string> files = {{"dir/a.inc", "include \"b.inc\""},
                                                    {"dir/b.inc", "\ninclude \"a.inc\""}};
  EXPECT_NE(FileError("include \"a.inc\"", PlayerDialect::kWorld, files)
                .find("dir/b.inc:2: 'dir/a.inc' includes itself"),
            std::string::npos);
  EXPECT_NE(FileError("include \"../dir/test.world\"", PlayerDialect::kWorld,
                      {{"dir/test.world", "include \"test.world\""}})
                .find("includes itself"),
            std::string::npos);
}

TEST(PlayerFileC1, LengthsAndAnglesAreConvertedByTheirUnits) {
  const PlayerFile plain = ParseFile("l 2 a 180 t [ 1 90 3 ]");
  PropertyReader metres(plain.global, plain);
  EXPECT_DOUBLE_EQ(metres.Length("l", 0.0), 2.0);
  EXPECT_DOUBLE_EQ(metres.Angle("a", 0.0), kPi);
  EXPECT_DOUBLE_EQ(metres.Tuple("t", "laf", 3)[1], kPi / 2.0);
  const PlayerFile other =
      ParseFile("unit_length \"cm\" unit_angle \"radians\" l 2 a 1 t [ 1 1 1 ]");
  PropertyReader centimetres(other.global, other);
  EXPECT_DOUBLE_EQ(centimetres.Length("l", 0.0), 0.02);
  EXPECT_DOUBLE_EQ(centimetres.Angle("a", 0.0), 1.0);
  EXPECT_DOUBLE_EQ(centimetres.Tuple("t", "laf", 3)[0], 0.01);
  EXPECT_DOUBLE_EQ(centimetres.Tuple("t", "laf", 3)[2], 1.0);
  EXPECT_DOUBLE_EQ(ParseFile("unit_length \"mm\"").length_unit, 0.001);
  EXPECT_NE(FileError("unit_length \"ft\"").find("\"cm\", \"m\" and \"mm\""), std::string::npos);
}

TEST(PlayerFileC1, BooleansAreSixWords) {
  const PlayerFile file = ParseFile("a 1 b 0 c \"yes\" d no e true f \"false\" g \"maybe\"");
  PropertyReader reader(file.global, file);
  EXPECT_TRUE(reader.Bool("a", false));
  EXPECT_FALSE(reader.Bool("b", true));
  EXPECT_TRUE(reader.Bool("c", false));
  EXPECT_FALSE(reader.Bool("d", true));
  EXPECT_TRUE(reader.Bool("e", false));
  EXPECT_FALSE(reader.Bool("f", true));
  EXPECT_TRUE(reader.Bool("none", true));
  EXPECT_THROW(reader.Bool("g", true), Error);
}

TEST(PlayerFileC1, AValueOfAnotherTypeIsNamedWithItsLine) {
  const PlayerFile file = ParseFile("a \"x\"\nb 1\nc [ 1 ]\nd 1.5");
  PropertyReader reader(file.global, file);
  const auto message = [](auto&& call) {
    try {
      call();
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  EXPECT_EQ(message([&] { reader.Number("a", 0.0); }),
            "dir/test.world:1: a must be a number, not a string");
  EXPECT_EQ(message([&] { reader.Text("b", ""); }),
            "dir/test.world:2: b must be a \"string\", not a number");
  EXPECT_EQ(message([&] { reader.Tuple("c", "ll", 2); }),
            "dir/test.world:3: c has 1 numbers, must have 2");
  EXPECT_EQ(message([&] { reader.Integer("d", 0); }),
            "dir/test.world:4: d must be a whole number, not 1.5");
}

TEST(PlayerFileC1, UnusedPropertiesAreKnown) {
  const PlayerFile file = ParseFile("a 1 b 2 b 3 c 4");
  PropertyReader reader(file.global, file);
  reader.Number("a", 0.0);
  const std::vector<const PlayerProperty*> unused = reader.Unused();
  ASSERT_EQ(unused.size(), 2U);
  EXPECT_EQ(unused[0]->name, "b");
  EXPECT_EQ(unused[1]->name, "c");
}

TEST(PlayerFileC1, WhatIsNoWordNumberOrMarkIsRefused) {
  EXPECT_NE(FileError("a 1;").find("';' has no meaning here"), std::string::npos);
  EXPECT_NE(FileError("a \xC3\xA9").find("not ASCII"), std::string::npos);
  EXPECT_NE(FileError("a b").find("'a' is followed by 'b'"), std::string::npos);
  EXPECT_NE(FileError("a").find("'a' has no value"), std::string::npos);
  EXPECT_NE(FileError("define a b c").find("'c' where ( should stand"), std::string::npos);
  EXPECT_NE(FileError("model ( define a b ( ) )").find("outside of all entities"),
            std::string::npos);
}

}  // namespace
}  // namespace ccmorse::scene
