// The text of ~/.morse/config: what MORSE's users have in theirs must survive us.

#include "tools/site_config.h"

#include <gtest/gtest.h>

#include <string>

namespace ccmorse::tools {
namespace {

const std::string kOfAUser =
    "# my own notes\n"
    "[general]\n"
    "colour = yes\n"
    "sites = 3\n"
    "\n"
    "[sites]\n"
    "; below ~\n"
    "par_intro = /home/u/School/PAR_INTRO\n"
    "other:/home/u/100%%\n"
    "  more of it\n"
    "what is this line\n"
    "\n"
    "[later]\n"
    "par_intro = /not/this\n";

TEST(SiteConfig, ReadsWhatConfigparserReads) {
  const SiteConfig config(kOfAUser);
  ASSERT_EQ(config.Sites().size(), 2U);
  EXPECT_EQ(config.Sites()[0].path, "/home/u/School/PAR_INTRO");
  EXPECT_EQ(config.Sites()[1].name, "other");
  EXPECT_EQ(config.Sites()[1].path, "/home/u/100%");
  EXPECT_EQ(config.Find("PAR_Intro")->path, "/home/u/School/PAR_INTRO");
  EXPECT_FALSE(config.Find("colour"));
  EXPECT_FALSE(config.Find(""));
}

TEST(SiteConfig, AddsALineAndKeepsEveryOtherByte) {
  SiteConfig config(kOfAUser);
  config.Set("New", "/a b/50%");
  std::string expected = kOfAUser;
  expected.insert(expected.find("\n[later]"), "New = /a b/50%%\n");
  EXPECT_EQ(config.text(), expected);
  EXPECT_EQ(config.Find("new")->path, "/a b/50%");
  EXPECT_TRUE(config.Remove("NEW"));
  EXPECT_EQ(config.text(), kOfAUser);
}

TEST(SiteConfig, ChangesAndRemovesWithTheLinesThatGoOn) {
  SiteConfig config(kOfAUser);
  config.Set("OTHER", "/x");
  EXPECT_NE(config.text().find("\nOTHER = /x\nwhat is this line\n"), std::string::npos)
      << config.text();
  EXPECT_FALSE(config.Remove("unknown"));
  EXPECT_TRUE(config.Remove("par_intro"));
  EXPECT_NE(config.text().find("[sites]\n; below ~\nOTHER"), std::string::npos) << config.text();
  EXPECT_NE(config.text().find("par_intro = /not/this"), std::string::npos);
}

TEST(SiteConfig, WritesASectionWhereThereIsNone) {
  SiteConfig empty("");
  empty.Set("a", "/a");
  EXPECT_EQ(empty.text(), "[sites]\na = /a\n");
  SiteConfig other("[x]\ny = 1");
  other.Set("a", "/a");
  EXPECT_EQ(other.text(), "[x]\ny = 1\n\n[sites]\na = /a\n");
  SiteConfig windows("[sites]\r\nb = /b\r\n");
  windows.Set("a", "/a");
  EXPECT_EQ(windows.text(), "[sites]\r\nb = /b\r\na = /a\r\n");
  EXPECT_EQ(windows.Find("b")->path, "/b");
}

TEST(SiteConfig, TakesAnyBytes) {
  for (const std::string text :
       {"[", "[sites", "=\n=", "[sites]\n= x\n", "\n\n", "[sites]\n a\n b"}) {
    SiteConfig config(text);
    config.Set("name", "/p");
    EXPECT_EQ(config.Find("name")->path, "/p") << text;
    EXPECT_TRUE(config.Remove("name"));
    EXPECT_FALSE(config.Find("name"));
  }
}

TEST(SiteConfig, NamesThatTheFileCannotHoldAreNamed) {
  EXPECT_EQ(SiteConfig::ProblemOfName("PAR_INTRO"), "");
  EXPECT_EQ(SiteConfig::ProblemOfName("my env"), "");
  for (const char* name :
       {"", " ", "a ", "a=b", "a:b", "a/b", "[a]", "#a", "a\nb", "-f", "..", "."}) {
    EXPECT_NE(SiteConfig::ProblemOfName(name), "") << name;
  }
}

}  // namespace
}  // namespace ccmorse::tools
