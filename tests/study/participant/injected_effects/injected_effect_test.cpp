#include "study/participant/injected_effects/injected_effect.h"

#include "renderer/base/error.h"
#include "tests/matchers.h"

namespace foveola::study {
namespace {

using testing::Pair;

TEST(InjectedEffect, AllKindsTogether) {
  EXPECT_EQ(parse_injected_effect("none").order_factor, 1.0);
  const InjectedEffect effect = parse_injected_effect(
      "faster:fv:2,order:0.9,outlier:3:5,dropout:0.2,tracker-loss:0.3,faster:mix:a=1:1.5");
  EXPECT_THAT(effect.faster, ElementsAre(Pair("fv", 2.0), Pair("mix:a=1", 1.5)));
  EXPECT_EQ(effect.order_factor, 0.9);
  ASSERT_TRUE(effect.outlier);
  EXPECT_EQ(effect.outlier->participant, 3);
  EXPECT_EQ(effect.outlier->slower, 5.0);
  EXPECT_EQ(effect.dropout_part, 0.2);
  EXPECT_EQ(effect.tracker_loss_part, 0.3);
}

TEST(InjectedEffect, OfSingleMarksAndRatings) {
  const InjectedEffect effect = parse_injected_effect(
      "faster-mark:third:fv:1.5,faster-mark:third:mix:a=1:0.5,faster-mark:fourth:fv:2,"
      "shift-rating:comfort:fv:+10,shift-rating:comfort:mix:a=1:-2.5,shift-rating:effort:vp:1");
  EXPECT_THAT(effect.faster_marks,
              ElementsAre(Pair("fourth", ElementsAre(Pair("fv", 2.0))),
                          Pair("third", ElementsAre(Pair("fv", 1.5), Pair("mix:a=1", 0.5)))));
  EXPECT_THAT(effect.shifted_ratings,
              ElementsAre(Pair("comfort", ElementsAre(Pair("fv", 10.0), Pair("mix:a=1", -2.5))),
                          Pair("effort", ElementsAre(Pair("vp", 1.0)))));
  EXPECT_TRUE(effect.faster.empty());
}

TEST(InjectedEffect, WhatMakesNoSenseIsRefused) {
  for (const char* text : {"",
                           "faster",
                           "faster:fv",
                           "faster::2",
                           "faster:fv:0",
                           "faster:fv:-1",
                           "faster:fv:x",
                           "faster:fv:2,",
                           "faster:fv:2,faster:fv:3",
                           "order:nan",
                           "order:0.9,order:0.8",
                           "order:fv:0.9",
                           "outlier:0:5",
                           "outlier:1.5:5",
                           "outlier:5",
                           "dropout:1.1",
                           "dropout:-0.1",
                           "tracker-loss:2",
                           "none,order:0.9",
                           "slower:fv:2",
                           "faster-mark:fv:2",
                           "faster-mark:third:fv:-2",
                           "faster-mark:third:fv:2,faster-mark:third:fv:3",
                           "shift-rating:comfort:1",
                           "shift-rating:comfort:fv:",
                           "shift-rating:comfort:fv:+-1",
                           "shift-rating:comfort:fv:inf",
                           "shift-rating:comfort:fv:1,shift-rating:comfort:fv:1",
                           "order:0.9 "}) {
    EXPECT_THROW(parse_injected_effect(text), UsageError) << "'" << text << "'";
  }
}

}  // namespace
}  // namespace foveola::study
