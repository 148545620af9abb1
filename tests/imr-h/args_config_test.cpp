#include "imr-h/args_config.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

namespace {

class ImrArguments : public testing::Test {
 protected:
  ImrArguments() {
    config_.add<std::string>("host", "server hostname", "localhost");
    config_.add<int>("port", "server port", 4000);
    config_.add<bool>("coords", "set the coords", false);
    config_.add<double>("x", "initial x position", 0.0);
    config_.add<std::string>("map", "a map's file");
  }

  bool Parse(const std::vector<std::string>& arguments) {
    std::vector<const char*> argv = {"/opt/bin/intro"};
    for (const std::string& argument : arguments) argv.push_back(argument.c_str());
    const imr::SProgram program = {"Drives around.", {"", "--host robot3"}};
    return imr::parseArguments(static_cast<int>(argv.size()), argv.data(), config_, program, out_);
  }

  std::string Error(const std::vector<std::string>& arguments) {
    try {
      Parse(arguments);
    } catch (const imr::bad_usage& e) {
      return e.what();
    }
    return "";
  }

  imr::CConfig config_;
  std::ostringstream out_;
};

}  // namespace

TEST_F(ImrArguments, NothingGivenKeepsTheDefaults) {
  EXPECT_TRUE(Parse({}));
  EXPECT_EQ(config_.get<int>("port"), 4000);
  EXPECT_EQ(out_.str(), "");
  const char* none[] = {nullptr};
  EXPECT_TRUE(imr::parseArguments(0, none, config_));
}

TEST_F(ImrArguments, BothWaysToWriteAValue) {
  EXPECT_TRUE(Parse({"--host", "robot3", "--port=38000", "--x", "-1.5", "--map=--odd=name"}));
  EXPECT_EQ(config_.get<std::string>("host"), "robot3");
  EXPECT_EQ(config_.get<int>("port"), 38000);
  EXPECT_EQ(config_.get<double>("x"), -1.5);
  EXPECT_EQ(config_.get<std::string>("map"), "--odd=name");
}

TEST_F(ImrArguments, FlagAloneIsTrue) {
  EXPECT_TRUE(Parse({"--coords", "--x", "1"}));
  EXPECT_TRUE(config_.get<bool>("coords"));
  EXPECT_EQ(config_.get<double>("x"), 1.0);
}

TEST_F(ImrArguments, FlagTakesAWordForTrueOrFalse) {
  EXPECT_TRUE(Parse({"--coords", "true"}));
  EXPECT_TRUE(config_.get<bool>("coords"));
  EXPECT_TRUE(Parse({"--coords", "0"}));
  EXPECT_FALSE(config_.get<bool>("coords"));
  EXPECT_TRUE(Parse({"--coords=yes"}));
  EXPECT_TRUE(config_.get<bool>("coords"));
}

TEST_F(ImrArguments, LastOfTwoValuesCounts) {
  EXPECT_TRUE(Parse({"--port", "1", "--port", "2"}));
  EXPECT_EQ(config_.get<int>("port"), 2);
}

TEST_F(ImrArguments, UnknownOptionIsOneLineWithTheNearestName) {
  EXPECT_EQ(Error({"--prot", "1"}),
            "unknown option --prot; did you mean --port? (--help lists all)");
  EXPECT_EQ(Error({"--velocity=1"}), "unknown option --velocity (--help lists all)");
  EXPECT_EQ(Error({"--hepl"}), "unknown option --hepl; did you mean --help? (--help lists all)");
}

TEST_F(ImrArguments, MissingOrWrongValueIsNamed) {
  EXPECT_EQ(Error({"--port"}), "option --port needs a value");
  EXPECT_EQ(Error({"--host", "--port", "1"}), "option --host needs a value");
  EXPECT_EQ(Error({"--port", "many"}), "option \"port\" needs a whole number, not \"many\"");
  EXPECT_EQ(Error({"--coords=perhaps"}), "option \"coords\" needs true or false, not \"perhaps\"");
}

TEST_F(ImrArguments, WhatIsNoOptionIsRefused) {
  for (const char* argument : {"robot3", "-x", "--", ""}) {
    EXPECT_EQ(Error({argument}), "unexpected argument \"" + std::string(argument) +
                                     "\"; an option is written --name value (--help lists all)");
  }
  EXPECT_NE(Error({"--=3"}), "");
}

TEST_F(ImrArguments, AnErrorSetsNothing) {
  EXPECT_NE(Error({"--host", "robot3", "--port", "many"}), "");
  EXPECT_EQ(config_.get<std::string>("host"), "localhost");
}

TEST_F(ImrArguments, HelpListsOptionsDefaultsAndExamples) {
  for (const char* help : {"--help", "-h"}) {
    out_.str("");
    EXPECT_FALSE(Parse({"--port", "7", help}));
    EXPECT_EQ(out_.str(),
              "Drives around.\n"
              "\n"
              "Usage: intro [options]\n"
              "\n"
              "Options:\n"
              "  --host TEXT  server hostname [localhost]\n"
              "  --port INT   server port [4000]\n"
              "  --coords     set the coords [false]\n"
              "  --x NUMBER   initial x position [0]\n"
              "  --map TEXT   a map's file\n"
              "  --help       show this text\n"
              "\n"
              "Examples:\n"
              "  intro\n"
              "  intro --host robot3\n");
  }
  EXPECT_EQ(config_.get<int>("port"), 4000);
}
