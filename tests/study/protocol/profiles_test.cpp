// What a protocol makes of the profiles of displays and trackers that it names.

#include "tests/matchers.h"
#include "tests/study/protocol/protocol_folder.h"

namespace foveola::study {
namespace {

const char* const goggles = R"(title = "Goggles"
kind = "headset"
width_px = 200
height_px = 100
refresh_rate_hz = 90
horizontal_fov_deg = 80
vertical_fov_deg = 70
lens = { axis = [0.75, 0.4], k1 = 0.25, k2 = 0.125 }
scan_out = { duration_ms = 3, provenance = "measured" }
)";

using ProtocolWithProfiles = ProtocolTables;

TEST_F(ProtocolWithProfiles, ADisplaysProfileGivesItsFieldsOfView) {
  const auto display = [&](const std::string& keys) {
    return load("[display]\nprofile = \"fove0\"\nview_height = 56\n" + keys).display;
  };
  const DisplaySettings fove = display("");
  EXPECT_EQ(fove.profile->name, "fove0");
  EXPECT_EQ(fove.view_width, DisplaySettings{}.view_width) << "is the simulation's choice";
  EXPECT_EQ(fove.horizontal_fov_deg, 100.0);
  EXPECT_EQ(fove.vertical_fov_deg, 100.0) << "whatever the pixels' shape";
  EXPECT_EQ(display("fov_deg = [60, 40]\n").vertical_fov_deg, 40.0);
}

TEST_F(ProtocolWithProfiles, ATrackersProfileGivesWhatTheProtocolDoesNot) {
  const TrackerSettings as_it_is = load("[tracker]\nprofile = \"simulated\"\n").tracker;
  EXPECT_EQ(as_it_is.profile->name, "simulated");
  EXPECT_EQ(as_it_is.simulated.bias_right_deg, 0.5);
  EXPECT_EQ(as_it_is.simulated.bias_up_deg, -0.4);
  EXPECT_EQ(as_it_is.simulated.data_loss, 0.02);
  EXPECT_EQ(as_it_is.simulated.precision_deg, 0.1);
  const TrackerSettings noisier =
      load("[tracker]\nprofile = \"simulated\"\nprecision_deg = 0.4\n").tracker;
  EXPECT_EQ(noisier.simulated.precision_deg, 0.4);
  EXPECT_EQ(noisier.simulated.bias_right_deg, 0.5);
  EXPECT_EQ(load("[tracker]\nprofile = \"hid\"\n").tracker.simulated.rate_hz, 60.0);
}

TEST_F(ProtocolWithProfiles, AnEmptyValidationHasItsDefaults) {
  const auto validation = load("[tracker.validation]\n").tracker.validation;
  ASSERT_TRUE(validation);
  EXPECT_EQ(validation->points, 9);
  EXPECT_FALSE(validation->correct);
}

TEST_F(ProtocolWithProfiles, AnEmptyOneEuroFilterHasItsDefaults) {
  EXPECT_EQ(load("[tracker.filter]\none_euro = {}\n").tracker.filter,
            GazeFilterSettings{.one_euro = OneEuroSettings{}});
}

TEST_F(ProtocolWithProfiles, PathsAreFoundFromItsOwnFolder) {
  folder_.write("mine/goggles.toml", goggles);
  const Protocol protocol = load("[display]\nprofile = \"mine/goggles.toml\"\n");
  EXPECT_EQ(protocol.display.horizontal_fov_deg, 80.0);
  EXPECT_EQ(protocol.display.vertical_fov_deg, 70.0);
  const std::vector<NamedProfile> named = named_profiles(protocol);
  ASSERT_THAT(named, SizeIs(1));
  EXPECT_EQ(named[0].device, "display");
  EXPECT_EQ(named[0].name, "goggles");
  EXPECT_EQ(named[0].toml, goggles);
}

// Both call a lens by the same keys, and mean the same by them.
TEST_F(ProtocolWithProfiles, AProfilesLensIsThatOfTheProtocolsWords) {
  folder_.write("goggles.toml", goggles);
  const std::string profile = "[display]\nprofile = \"goggles.toml\"\n";
  const auto lens = [&](const std::string& tables) { return load(tables).display.lens; };
  const std::string words = "axis = [0.75, 0.4]\nk1 = 0.25\nk2 = 0.125\n";
  EXPECT_EQ(lens(profile), lens("[display.lens]\n" + words));
  EXPECT_EQ(lens(profile + "[display.lens]\neye = \"right\"\n"),
            lens("[display.lens]\neye = \"right\"\n" + words));
  EXPECT_EQ(lens(profile + "[display.lens]\nk1 = 0.5\n"),
            (RadialLens{.axis = {0.75F, 0.4F}, .k1 = 0.5F, .k2 = 0.125F}));
}

TEST_F(ProtocolWithProfiles, ThatAreBadAreRefusedWithTheirPlace) {
  folder_.write("torn.toml", "title = \n");
  const test::TemporaryFolder elsewhere;
  elsewhere.write("goggles.toml", goggles);
  const auto refused = [&](const std::string& profile, const std::string& says) {
    EXPECT_THAT([&] { load("[display]\nprofile = \"" + profile + "\"\n"); },
                ThrowsMessage<Error>(AllOf(HasSubstr(path_.string() + ":6:11: "), HasSubstr(says),
                                           Not(HasSubstr("\n")))))
        << profile;
  };
  refused("no-such", "'no-such'");
  refused("no/such.toml", "a file that does not exist");
  refused("../goggles.toml", "leads out of the folder");
  refused((elsewhere / "goggles.toml").string(), "an absolute path");
  refused("torn.toml", "torn.toml:1:");
  refused("", "is not one of the displays");
}

}  // namespace
}  // namespace foveola::study
