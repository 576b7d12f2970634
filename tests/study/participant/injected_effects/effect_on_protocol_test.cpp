#include "study/participant/injected_effects/effect_on_protocol.h"

#include "renderer/base/error.h"
#include "tests/matchers.h"

namespace foveola::study {
namespace {

Protocol protocol_with_marks_and_ratings() {
  Protocol protocol;
  protocol.methods = {"od", "fv"};
  protocol.marks = {{.id = "outline", .instruction = {}, .simulated = {}},
                    {.id = "third", .instruction = {}, .simulated = {}}};
  protocol.ratings = {
      {.id = "comfort", .minimum = 0.0, .maximum = 100.0},
      {.id = "noise", .kind = QuestionKind::choice, .options = {{"none", 0.0}, {"much", 2.0}}},
      {.id = "colour", .kind = QuestionKind::choice, .options = {{"red", {}}, {"blue", {}}}},
      {.id = "remark", .kind = QuestionKind::text}};
  return protocol;
}

TEST(EffectOnProtocol, WhatTheProtocolHasIsTaken) {
  for (const char* effect :
       {"none", "order:1", "faster:fv:2", "faster-mark:third:fv:2", "faster-mark:outline:od:9",
        "faster-mark:outline:fv:0.5", "faster-mark:outline:od:3,faster-mark:third:od:6",
        "shift-rating:comfort:fv:10", "shift-rating:noise:fv:-1.9",
        "shift-rating:comfort:fv:40,shift-rating:comfort:od:-50"}) {
    EXPECT_NO_THROW(
        require_drawable(parse_injected_effect(effect), protocol_with_marks_and_ratings()))
        << effect;
  }
}

TEST(EffectOnProtocol, AMarkThatWouldComeTooSoonAfterTheOneBeforeIsRefused) {
  for (const char* effect : {"faster-mark:third:fv:2.1", "faster-mark:outline:fv:0.4",
                             "faster-mark:outline:fv:2,faster-mark:third:fv:4.5"}) {
    EXPECT_THAT(
        [&] { require_drawable(parse_injected_effect(effect), protocol_with_marks_and_ratings()); },
        ThrowsMessage<UsageError>(HasSubstr("'third' would follow 'outline' too soon")))
        << effect;
  }
}

TEST(EffectOnProtocol, WhatItDoesNotHaveIsNamedWithWhatItHas) {
  Protocol protocol = protocol_with_marks_and_ratings();
  const auto refused = [&protocol](const std::string& effect, const std::string& what) {
    EXPECT_THAT([&] { require_drawable(parse_injected_effect(effect), protocol); },
                ThrowsMessage<UsageError>(AllOf(HasSubstr("--inject " + effect), HasSubstr(what))))
        << effect;
  };
  refused("faster:fw:2", "no method 'fw'; choose one of od, fv");
  refused("faster-mark:material:fv:2", "no mark 'material'; choose one of outline, third");
  refused("faster-mark:third:fw:2", "choose one of od, fv");
  refused("shift-rating:comfrt:fv:2", "no rating 'comfrt'; choose one of comfort, noise, colour");
  refused("shift-rating:comfort:fw:2", "choose one of od, fv");
  refused("shift-rating:colour:fv:1", "the answers to 'colour' are not numbers");
  refused("shift-rating:remark:fv:1", "the answers to 'remark' are not numbers");
  refused("shift-rating:comfort:fv:-100", "which is 100 wide");
  refused("shift-rating:noise:fv:2", "which is 2 wide");
  protocol.ratings.clear();
  refused("shift-rating:comfort:fv:1", "no rating");
}

}  // namespace
}  // namespace foveola::study
