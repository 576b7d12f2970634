// The measures that simulated participants refuse, since they have no judgement for them.
#include "study/participant/answers.h"
#include "tests/study/protocol/protocol_folder.h"

namespace foveola::study {
namespace {

class JudgedMeasures : public ProtocolTables {
 protected:
  auto requiring(const std::string& tables) const {
    return [this, tables] { require_judgements(load(tables)); };
  }
};

TEST_F(JudgedMeasures, AreThePublishedOnesInAnyOrder) {
  EXPECT_NO_THROW(requiring("")());
  EXPECT_NO_THROW(
      requiring("[[mark]]\nid = \"material\"\ninstruction = \"Now.\"\n"
                "[[mark]]\nid = \"outline\"\ninstruction = \"Now.\"\n")());
  EXPECT_EQ(judgement_of({.id = "first", .simulated = "outline"}), Task::mark_outline);
  EXPECT_EQ(judgement_of({.id = "first", .simulated = "material"}), Task::mark_material);
  EXPECT_EQ(judgement_of({.id = "third"}), std::nullopt);
}

TEST_F(JudgedMeasures, AreThoseThatTheProtocolNames) {
  EXPECT_NO_THROW(
      requiring("[[mark]]\nid = \"third\"\ninstruction = \"Now.\"\n"
                "simulated = \"material\"\n"
                "[[rating]]\nid = \"comfort\"\ntext = \"?\"\n"
                "simulated = \"quality\"\n")());
}

TEST_F(JudgedMeasures, AreNoOtherMarks) {
  EXPECT_THAT(requiring("[[mark]]\nid = \"outline\"\ninstruction = \"Now.\"\n"
                        "[[mark]]\nid = \"third\"\ninstruction = \"Now.\"\n"),
              ThrowsMessage<Error>(
                  AllOf(HasSubstr("p.toml:9:6: simulated participants cannot judge the mark "
                                  "third; "),
                        HasSubstr("simulated = \"outline\""), HasSubstr("--inject"))));
}

TEST_F(JudgedMeasures, AreNoOtherRatingsButWords) {
  const std::string artifacts = "[[rating]]\nid = \"artifacts\"\ntext = \"?\"\n";
  EXPECT_NO_THROW(requiring(artifacts + "labels = [\"keine\", \"überall\"]\n")());
  EXPECT_NO_THROW(requiring(artifacts + "[[rating]]\nid = \"why\"\ntext = \"?\"\n"
                                        "kind = \"text\"\nrequired = false\n")());
  EXPECT_THAT(requiring(artifacts + "[[rating]]\nid = \"comfort\"\ntext = \"?\"\n"),
              ThrowsMessage<Error>(HasSubstr("p.toml:9:6: simulated participants cannot judge the "
                                             "rating comfort")));
}

}  // namespace
}  // namespace foveola::study
