#include "imr-h/imr_config.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

namespace {

// The message of the bad_usage that `action` throws; empty if it throws none.
template <typename Action>
std::string UsageError(Action action) {
  try {
    action();
  } catch (const imr::bad_usage& e) {
    return e.what();
  }
  return "";
}

imr::CConfig OneOfEach() {
  imr::CConfig config;
  config.add<std::string>("host", "server hostname", "localhost");
  config.add<int>("port", "server port", 4000);
  config.add<bool>("coords", "set coords", false);
  config.add<double>("x", "position", 0.25);
  config.add<float>("gain", "a gain", 1.5f);
  return config;
}

}  // namespace

TEST(X06, AddKeepsTypeDescriptionAndDefault) {
  imr::CConfig config = OneOfEach();
  EXPECT_EQ(config.getType("host"), imr::CConfig::STRING);
  EXPECT_EQ(config.getType("port"), imr::CConfig::INT);
  EXPECT_EQ(config.getType("coords"), imr::CConfig::BOOL);
  EXPECT_EQ(config.getType("x"), imr::CConfig::DOUBLE);
  EXPECT_EQ(config.getType("gain"), imr::CConfig::FLOAT);
  EXPECT_EQ(config.getDescription<int>("port"), "server port");
  EXPECT_EQ(config.getDescriptionText("x"), "position");
  EXPECT_TRUE(config.hasDefaultValue<std::string>("host"));
  EXPECT_EQ(config.getDefaultValue<std::string>("host"), "localhost");
  EXPECT_EQ(config.getDefaultValue<int>("port"), 4000);
  EXPECT_EQ(config.getDefaultValue<bool>("coords"), false);
  EXPECT_EQ(config.getDefaultValue<double>("x"), 0.25);
  EXPECT_EQ(config.getDefaultValue<float>("gain"), 1.5f);
}

TEST(X06, DefaultStaysWhenTheValueChanges) {
  imr::CConfig config = OneOfEach();
  config.set<int>("port", 38000);
  EXPECT_EQ(config.get<int>("port"), 38000);
  EXPECT_EQ(config.getDefaultValue<int>("port"), 4000);
}

TEST(X06, OptionWithoutDefaultIsEmptyUntilItIsSet) {
  imr::CConfig config;
  config.add<std::string>("map");
  config.add<int>("count", "how many");
  EXPECT_EQ(config.getDescription<std::string>("map"), "");
  EXPECT_FALSE(config.hasDefaultValue<std::string>("map"));
  EXPECT_EQ(config.get<std::string>("map"), "");
  EXPECT_EQ(config.get<int>("count"), 0);
  EXPECT_EQ(UsageError([&] { config.getDefaultValue<int>("count"); }),
            "option \"count\" has no default value");
}

TEST(X07, GetReturnsAReferenceThatSets) {
  imr::CConfig config = OneOfEach();
  EXPECT_EQ(config.get<std::string>("host"), "localhost");
  config.get<std::string>("host") = "robot3";
  *config.getPtr<double>("x") = 1.5;
  EXPECT_EQ(config.get<std::string>("host"), "robot3");
  EXPECT_EQ(config.get<double>("x"), 1.5);
  const imr::CConfig& constant = config;
  EXPECT_EQ(constant.get<double>("x"), 1.5);
}

TEST(X07, ReferencesSurviveFurtherOptions) {
  imr::CConfig config;
  config.add<std::string>("first", "", "value");
  const std::string* first = config.getPtr<std::string>("first");
  for (int i = 0; i < 1000; ++i) config.add<int>("option" + std::to_string(i), "", i);
  EXPECT_EQ(first, config.getPtr<std::string>("first"));
  EXPECT_EQ(*first, "value");
}

TEST(X07, UnknownNameNamesTheNearestAndAllKnownOnes) {
  imr::CConfig config = OneOfEach();
  EXPECT_EQ(UsageError([&] { config.get<int>("prot"); }),
            "unknown option \"prot\"; did you mean 'port'? (known: host, port, coords, x, gain)");
  EXPECT_EQ(UsageError([&] { config.set<int>("velocity", 1); }),
            "unknown option \"velocity\" (known: host, port, coords, x, gain)");
  imr::CConfig empty;
  EXPECT_EQ(UsageError([&] { empty.getPtr<int>("port"); }),
            "unknown option \"port\" (known: none)");
}

TEST(X07, WrongTypeIsRefusedByName) {
  imr::CConfig config = OneOfEach();
  EXPECT_EQ(UsageError([&] { config.get<double>("port"); }),
            "option \"port\" is of type int, not double");
  EXPECT_EQ(UsageError([&] { config.set<int>("host", 1); }),
            "option \"host\" is of type string, not int");
  EXPECT_EQ(UsageError([&] { config.getDescription<bool>("x"); }),
            "option \"x\" is of type double, not bool");
}

TEST(X06, NameCanBeAddedOnce) {
  imr::CConfig config = OneOfEach();
  EXPECT_EQ(UsageError([&] { config.add<int>("port", "again", 1); }),
            "option \"port\" is added twice");
  EXPECT_EQ(UsageError([&] { config.add<double>("port", "another type"); }),
            "option \"port\" is added twice");
  EXPECT_EQ(UsageError([&] { config.add<double>("", "no name"); }), "an option must have a name");
  EXPECT_EQ(config.get<int>("port"), 4000);
}

TEST(ImrConfig, IteratesAndListsInTheOrderOfInsertion) {
  imr::CConfig config = OneOfEach();
  config.add<int>("another", "", 1);
  std::vector<std::string> names;
  for (auto it = config.items_begin(); it != config.items_end(); ++it) names.push_back(it->name);
  EXPECT_EQ(names, (std::vector<std::string>{"host", "port", "coords", "x", "gain", "another"}));
  imr::CConfig::NameList ints;
  config.getNames<int>(ints);
  EXPECT_EQ(ints, (imr::CConfig::NameList{"port", "another"}));
}

TEST(ImrConfig, PrintsNameAndValueALine) {
  imr::CConfig config = OneOfEach();
  config.set<double>("x", 0.1);
  std::ostringstream out;
  config.print(out);
  EXPECT_EQ(out.str(), "host=localhost\nport=4000\ncoords=false\nx=0.1\ngain=1.5\n");
}

TEST(ImrConfig, CopyIsIndependent) {
  imr::CConfig config = OneOfEach();
  imr::CConfig copy = config;
  copy.set<int>("port", 1);
  EXPECT_EQ(config.get<int>("port"), 4000);
  EXPECT_EQ(copy.begin()->name, "host");
}

TEST(ImrConfig, TextSetsEveryType) {
  imr::CConfig config = OneOfEach();
  config.setText("host", "");
  config.setText("port", "-7");
  config.setText("coords", "yes");
  config.setText("x", "+1e-3");
  config.setText("gain", "0.5");
  EXPECT_EQ(config.get<std::string>("host"), "");
  EXPECT_EQ(config.get<int>("port"), -7);
  EXPECT_TRUE(config.get<bool>("coords"));
  EXPECT_EQ(config.get<double>("x"), 0.001);
  EXPECT_EQ(config.get<float>("gain"), 0.5f);
  config.setText("coords", "off");
  EXPECT_FALSE(config.get<bool>("coords"));
}

TEST(ImrConfig, TextThatDoesNotFitIsRefusedAndChangesNothing) {
  imr::CConfig config = OneOfEach();
  for (const char* text : {"", "4000x", "4e3", "1.5", "99999999999", "0x10", " 1", "+-1", "+"}) {
    EXPECT_EQ(UsageError([&] { config.setText("port", text); }),
              "option \"port\" needs a whole number, not \"" + std::string(text) + "\"");
  }
  for (const char* text : {"", "nan", "inf", "1e999", "1,5", "1.5 m"}) {
    EXPECT_EQ(UsageError([&] { config.setText("x", text); }),
              "option \"x\" needs a number, not \"" + std::string(text) + "\"");
    EXPECT_NE(UsageError([&] { config.setText("gain", text); }), "");
  }
  EXPECT_EQ(UsageError([&] { config.setText("coords", "maybe"); }),
            "option \"coords\" needs true or false, not \"maybe\"");
  EXPECT_NE(UsageError([&] { config.setText("missing", "1"); }), "");
  EXPECT_EQ(config.get<int>("port"), 4000);
  EXPECT_EQ(config.get<double>("x"), 0.25);
}
