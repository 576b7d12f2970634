#include "renderer/gaze/open_gaze/open_gaze_records.h"

#include "renderer/base/numbers/random.h"
#include "tests/matchers.h"

namespace foveola {
namespace {

using testing::Pair;

const char* const documented =
    "<REC CNT=\"237217\" BPOGX=\"0.43388\" BPOGY=\"1.08536\" BPOGV=\"1\" />";

OpenGazeRecord record_of(const std::string& line) {
  const std::optional<OpenGazeElement> element = parse_open_gaze(line);
  EXPECT_TRUE(element) << line;
  return element ? record_from(*element) : OpenGazeRecord{};
}

/// A record with these attributes.
OpenGazeRecord record_with(const std::string& attributes) {
  return record_of("<REC " + attributes + " />");
}

TEST(OpenGazeRequests, AskForEachEyeTheBestTheTimeAndAtLastForData) {
  const std::string requests = open_gaze_requests();
  for (const char* const id : {"COUNTER", "TIME", "POG_LEFT", "POG_RIGHT", "POG_BEST"}) {
    EXPECT_THAT(requests,
                HasSubstr(std::string("<SET ID=\"ENABLE_SEND_") + id + "\" STATE=\"1\" />\r\n"));
  }
  EXPECT_THAT(requests, EndsWith("<SET ID=\"ENABLE_SEND_DATA\" STATE=\"1\" />\r\n"));
}

TEST(OpenGazeRecords, ReadsTheDocumentedRecord) {
  const OpenGazeRecord record = record_of(documented);
  EXPECT_EQ(record.count, 237217);
  ASSERT_TRUE(record.best);
  EXPECT_TRUE(record.best->valid);
  EXPECT_EQ(record.best->fraction, DVec2(0.43388, 1.08536));
  EXPECT_FALSE(record.left || record.right || record.time_s);
}

TEST(OpenGazeRecords, ReadsTimeAndBothEyes) {
  const OpenGazeRecord record = record_with(
      "TIME=\"1234.56789\" TIME_TICK=\"-42\" LPOGX=\"0.25\" LPOGY=\"-0.5\" LPOGV=\"1\" "
      "RPOGX=\"0.75\" RPOGY=\"1e-1\" RPOGV=\"0\"");
  EXPECT_EQ(record.time_s, 1234.56789);
  EXPECT_TRUE(record.left->valid);
  EXPECT_EQ(record.left->fraction, DVec2(0.25, -0.5));
  EXPECT_FALSE(record.right->valid);
  EXPECT_FALSE(record.best);
}

TEST(OpenGazeRecords, KeepsTheAttributesOfOtherElements) {
  const auto element = parse_open_gaze("<ACK ID=\"ENABLE_SEND_DATA\"\tSTATE=\"1\"/>\r");
  ASSERT_TRUE(element);
  EXPECT_EQ(element->kind, OpenGazeKind::acknowledgement);
  EXPECT_THAT(element->attributes, ElementsAre(Pair("ID", "ENABLE_SEND_DATA"), Pair("STATE", "1")));
  EXPECT_EQ(parse_open_gaze("<NACK ID=\"X\" />")->kind, OpenGazeKind::refusal);
  EXPECT_EQ(parse_open_gaze("<CAL ID=\"CALIB_RESULT\" />")->kind, OpenGazeKind::other);
  EXPECT_EQ(parse_open_gaze("<REC />")->kind, OpenGazeKind::record);
}

TEST(OpenGazeRecords, NumbersThatAreNoneMakeAPointInvalid) {
  for (const char* const x : {"", "nan", "inf", "-inf", "abc", "0,5,5", "0.5 ", " 0.5", "1e999",
                              "0.5.5", "+0.5", "0x1p-1", "101", "1e300"}) {
    const OpenGazeRecord record =
        record_with(std::string("BPOGX=\"") + x + "\" BPOGY=\"0.5\" BPOGV=\"1\"");
    ASSERT_TRUE(record.best) << x;
    EXPECT_FALSE(record.best->valid) << x;
  }
  EXPECT_FALSE(record_with("BPOGX=\"0.5\" BPOGV=\"1\"").best->valid);
  for (const char* const validity : {"", "0", "2", "true", "1 "}) {
    EXPECT_FALSE(record_with(std::string("BPOGX=\"0.5\" BPOGY=\"0.5\" BPOGV=\"") + validity + "\"")
                     .best->valid);
  }
}

TEST(OpenGazeRecords, NumbersThatAreNoneAreNoTimeAndNoCount) {
  for (const char* const text : {"", "x", "nan", "1e10", "-1", "12s"}) {
    EXPECT_FALSE(record_with(std::string("TIME=\"") + text + "\"").time_s) << text;
  }
  for (const char* const text : {"", "1.5", "-1", "9223372036854775808"}) {
    EXPECT_FALSE(record_with(std::string("CNT=\"") + text + "\"").count) << text;
  }
}

TEST(OpenGazeRecords, GarbageIsNoElement) {
  using namespace std::string_view_literals;
  for (const std::string_view line : {"hello"sv,
                                      "<"sv,
                                      "<>"sv,
                                      "</>"sv,
                                      "< REC />"sv,
                                      "<REC"sv,
                                      "<REC>"sv,
                                      "<REC X=\"1\""sv,
                                      "<REC X=\"1\">"sv,
                                      "<REC X=\"1\" / >"sv,
                                      "<REC X=\"1\" />x"sv,
                                      "<REC X=\"1\" /><REC X=\"1\" />"sv,
                                      "<REC X=1 />"sv,
                                      "<REC X=\"1 />"sv,
                                      "<REC X=1\" />"sv,
                                      "<REC X=\"1 Y=\"2\" />"sv,
                                      "<REC X=\"1\"Y=\"2\" />"sv,
                                      "<REC X=\"1\" X=\"2\" />"sv,
                                      "<REC =\"1\" />"sv,
                                      "<REC X = \"1\" />"sv,
                                      "<REC X=\"<\" />"sv,
                                      "<REC X=\"\0\" />"sv,
                                      "<REC X=\"1\"\0/>"sv,
                                      "<REC X=\"\x01\" />"sv,
                                      "<REC X=\"1\"\r/>"sv,
                                      "\xff\xfe<REC />"sv}) {
    EXPECT_FALSE(parse_open_gaze(line)) << line;
  }
}

const char* const stream =
    "<ACK ID=\"ENABLE_SEND_DATA\" STATE=\"1\" />\r\n"
    "<REC CNT=\"1\" BPOGX=\"0.1\" BPOGY=\"0.2\" BPOGV=\"1\" />\r\n"
    "\r\n"
    "what?\r\n"
    "<REC CNT=\"2\" BPOGX=\"0.3\" BPOGY=\"0.4\" BPOGV=\"0\" />\n"
    "<REC CNT=\"3\"";

void expect_what_is_in_the_stream(const std::vector<OpenGazeElement>& elements,
                                  const OpenGazeStream& read) {
  ASSERT_EQ(elements.size(), 3U);
  EXPECT_EQ(elements[0].kind, OpenGazeKind::acknowledgement);
  EXPECT_EQ(record_from(elements[1]).count, 1);
  EXPECT_EQ(record_from(elements[1]).best->fraction, DVec2(0.1, 0.2));
  EXPECT_EQ(record_from(elements[2]).count, 2);
  EXPECT_EQ(read.garbage(), 1U);
}

TEST(OpenGazeStream, TakesBytesInTwoPortionsCutAnywhere) {
  const std::string_view bytes(stream);
  for (std::size_t cut = 0; cut <= bytes.size(); ++cut) {
    OpenGazeStream read;
    std::vector<OpenGazeElement> elements = read.take(bytes.substr(0, cut));
    for (OpenGazeElement& element : read.take(bytes.substr(cut))) {
      elements.push_back(std::move(element));
    }
    expect_what_is_in_the_stream(elements, read);
  }
}

TEST(OpenGazeStream, TakesBytesOneByOne) {
  OpenGazeStream read;
  std::vector<OpenGazeElement> elements;
  for (const char& byte : std::string_view(stream)) {
    for (OpenGazeElement& element : read.take({&byte, 1})) {
      elements.push_back(std::move(element));
    }
  }
  expect_what_is_in_the_stream(elements, read);
}

TEST(OpenGazeStream, AnEndlessLineIsOneLineOfGarbage) {
  OpenGazeStream read;
  const std::string piece(1000, 'x');
  for (int i = 0; i < 1000; ++i) {
    EXPECT_TRUE(read.take(piece).empty());
  }
  EXPECT_EQ(read.take("\n" + std::string(documented) + "\n").size(), 1U);
  EXPECT_EQ(read.garbage(), 1U);
}

TEST(OpenGazeStream, ALineMayBeAsLongAsItSays) {
  const auto line_of = [](std::size_t size) {
    const std::string frame = "<REC X=\"\" />";
    return "<REC X=\"" + std::string(size - frame.size(), 'x') + "\" />\n";
  };
  OpenGazeStream read;
  EXPECT_EQ(read.take(line_of(OpenGazeStream::longest_line_bytes)).size(), 1U);
  EXPECT_EQ(read.take(line_of(OpenGazeStream::longest_line_bytes + 1)).size(), 0U);
  EXPECT_EQ(read.garbage(), 1U);
}

// Every line ends up somewhere, whatever was done to it, and what is valid is a point.
TEST(OpenGazeStream, SurvivesDamage) {
  Pcg32 random(1);
  constexpr std::uint64_t lines = 20000;
  OpenGazeStream read;
  std::uint64_t elements = 0;
  for (std::uint64_t i = 0; i < lines; ++i) {
    std::string line = documented;
    for (std::uint32_t damage = random.below(4); damage > 0; --damage) {
      const std::uint32_t at = random.below(static_cast<std::uint32_t>(line.size()));
      line[at] = static_cast<char>(32 + random.below(224));
    }
    for (const OpenGazeElement& element : read.take(line + "\r\n")) {
      ++elements;
      const PointOfGaze gaze = combined_gaze(record_from(element));
      ASSERT_LE(glm::length(gaze.fraction), 150.0);
    }
  }
  EXPECT_EQ(elements + read.garbage(), lines);
  EXPECT_GT(elements, lines / 4);  // a quarter has no damage at all
  EXPECT_GT(read.garbage(), lines / 10);
}

TEST(CombinedGaze, IsByValidity) {
  const PointOfGaze left{.fraction = {0.2, 0.6}, .valid = true};
  const PointOfGaze right{.fraction = {0.4, 0.2}, .valid = true};
  const PointOfGaze best{.fraction = {0.9, 0.9}, .valid = true};
  const PointOfGaze none;

  const PointOfGaze both = combined_gaze({.best = best, .left = left, .right = right});
  EXPECT_TRUE(both.valid);
  EXPECT_NEAR(both.fraction.x, 0.3, 1e-15);
  EXPECT_NEAR(both.fraction.y, 0.4, 1e-15);

  EXPECT_EQ(combined_gaze({.left = left, .right = none}).fraction, left.fraction);
  EXPECT_EQ(combined_gaze({.left = none, .right = right}).fraction, right.fraction);
  EXPECT_EQ(combined_gaze({.right = right}).fraction, right.fraction);
  EXPECT_FALSE(combined_gaze({.best = best, .left = none, .right = none}).valid);
  EXPECT_EQ(combined_gaze({.best = best}).fraction, best.fraction);
  EXPECT_FALSE(combined_gaze({.best = none}).valid);
  EXPECT_FALSE(combined_gaze({}).valid);
}

}  // namespace
}  // namespace foveola
