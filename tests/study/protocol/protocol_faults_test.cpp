// Every way in which a protocol can be wrong, and where the message says that it is.

#include "tests/matchers.h"
#include "tests/study/protocol/protocol_folder.h"

namespace foveola::study {
namespace {

/// What is wrong, at which line and column, and what the message must say.
struct Fault {
  const char* name;
  std::string text;
  std::string place;
  std::string says;
};
void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.name; }

/// A protocol whose second method is a mask of `file`.
Fault with_mask(const char* name, const std::string& file, const char* says) {
  return {name,
          "name = \"a\"\ntitle = \"b\"\nscenes = [\"s\"]\nmethods = [\"od\", \"mask:file=" + file +
              "\"]\n",
          "4:18", says};
}

std::string many_trials() {
  std::string scenes;
  for (int i = 0; i < 501; ++i) {
    scenes += "\"s" + std::to_string(i) + "\", ";
  }
  return "name = \"a\"\ntitle = \"b\"\nscenes = [" + scenes + "]\nmethods = [\"od\", \"fv\"]\n";
}

std::string many_methods() {
  std::string methods;
  for (int i = 0; i < 101; ++i) {
    methods += "\"fv:cutoff=" + std::to_string(i + 10) + "\", ";
  }
  return "name = \"a\"\ntitle = \"b\"\nscenes = [\"s\"]\nmethods = [" + methods + "]\n";
}

std::string many_questionnaires() {
  std::string tables;
  for (int i = 0; i < 101; ++i) {
    tables += "[[questionnaire]]\nid = \"q" + std::to_string(i) + "\"\nfile = \"sus\"\n";
  }
  return minimal + tables;
}

class ProtocolFault : public ProtocolFolder, public testing::WithParamInterface<Fault> {};

TEST_P(ProtocolFault, IsRefusedWithItsPlace) {
  EXPECT_THAT([&] { load(GetParam().text); },
              ThrowsMessage<Error>(AllOf(HasSubstr(path_.string() + ":" + GetParam().place + ":"),
                                         HasSubstr(GetParam().says), Not(HasSubstr("\n")))));
}

INSTANTIATE_TEST_SUITE_P(
    OfSettings, ProtocolFault,
    testing::Values(
        Fault{"no_toml", "name = \n", "1:8", ""},
        Fault{"unknown_key", minimal + "colour = 3\n", "5:1", "colour"},
        Fault{"unknown_table", minimal + "[lens]\nk = 1\n", "5:2", "lens"},
        Fault{"unknown_key_in_table", minimal + "[film]\ndepth = 3\n", "6:1", "film.depth"},
        Fault{"unknown_method",
              "name = \"a\"\ntitle = \"b\"\nscenes = [\"s\"]\nmethods = [\"od\", \"xx\"]\n", "4:18",
              "xx"},
        Fault{"method_twice",
              "name = \"a\"\ntitle = \"b\"\nscenes = [\"s\"]\nmethods = [\"od\", \"od\"]\n", "4:18",
              "twice"},
        with_mask("mask_that_is_missing", "no_such.png", "a file that does not exist"),
        with_mask("mask_by_an_absolute_path", "/etc/passwd", "an absolute path"),
        with_mask("mask_out_of_the_folder", "../x.png", "leads out of the folder"),
        with_mask("mask_that_is_a_folder", ".", "not a regular file"),
        Fault{"background_of_an_older_version", "name = \"a\"\n[[background]]\nid = \"age\"\n",
              "2:1", "write [[questionnaire]] with id"},
        Fault{"method_with_a_pointer",
              "name = \"a\"\ntitle = \"b\"\nscenes = [\"s\"]\n"
              "methods = [\"od\", \"hybrid:1*od+1*pointer:radius=5\"]\n",
              "4:18", "follows a pointer"},
        Fault{"third_eye", minimal + "[display.lens]\neye = \"third\"\n", "6:7", "no eye 'third'"},
        Fault{"no_scenes", "name = \"a\"\ntitle = \"b\"\nscenes = []\nmethods = [\"od\"]\n", "3:10",
              "scenes"},
        Fault{"scene_is_a_number",
              "name = \"a\"\ntitle = \"b\"\nscenes = [3]\nmethods = [\"od\"]\n", "3:10", "scenes"},
        Fault{"missing_methods", "name = \"a\"\ntitle = \"b\"\nscenes = [\"s\"]\n", "1:1",
              "methods"},
        Fault{"text_for_number", minimal + "[film]\nwidth = \"wide\"\n", "6:9", "film.width"},
        Fault{"fraction_for_integer", minimal + "[film]\nwidth = 64.5\n", "6:9", "film.width"},
        Fault{"film_too_large_for_any_memory", minimal + "[film]\nwidth = 65536\nheight = 65536\n",
              "6:9", "65536 x 65536 pixels would take 174 GB of memory; make it smaller"},
        Fault{"film_too_large_in_one_scene",
              minimal + "[film]\nwidth = 32768\n[[override]]\nscene = \"room\"\nfilm.height = "
                        "16384\n",
              "9:15", "32768 x 16384 pixels would take 22 GB"},
        Fault{"too_many_trials", many_trials(), "4:11",
              "501 scenes with 2 methods make 1002 trials; the maximum of a session is 1000; use "
              "fewer"},
        Fault{"too_many_methods", many_methods(), "4:11",
              "the protocol has 101 methods; the maximum is 100; use fewer"},
        Fault{"endless_method",
              "name = \"a\"\ntitle = \"b\"\nscenes = [\"s\"]\nmethods = [\"od\", \"hybrid:1*fv" +
                  std::string(1000, '+') + "\"]\n",
              "4:18", "the method has 1011 characters; the maximum is 1000"},
        Fault{"negative_size", minimal + "[film]\nwidth = -64\n", "6:9", "film.width"},
        Fault{"nan_rate", minimal + "[machine]\nframe_rate_hz = nan\n", "6:17", "frame_rate_hz"},
        Fault{"infinite_rate", minimal + "[machine]\nframe_rate_hz = inf\n", "6:17",
              "frame_rate_hz"},
        Fault{"flat_view", minimal + "[display]\nfov_deg = 180\n", "6:11", "fov_deg"},
        Fault{"folding_lens", minimal + "[display]\n[display.lens]\nk1 = -3\n", "6:1", "fold"},
        Fault{"profile_of_no_tracker", minimal + "[tracker]\nprofile = \"fove1\"\n", "6:11",
              "did you mean 'fove0'?"},
        Fault{"seven_points", minimal + "[tracker.validation]\npoints = 7\n", "6:10", "5 or 9"},
        Fault{"no_attempts", minimal + "[tracker.validation]\nattempts = 0\n", "6:12",
              "tracker.validation.attempts"},
        Fault{"unknown_gate", minimal + "[tracker.validation]\nmax_error = 1\n", "6:1",
              "tracker.validation.max_error"},
        Fault{"filter_of_nothing", minimal + "[tracker.filter]\n", "5:1",
              "one_euro, extrapolate_s or hold_s"},
        Fault{"unknown_filter", minimal + "[tracker.filter]\nkalman = 1\n", "6:1",
              "tracker.filter.kalman"},
        Fault{"far_extrapolation", minimal + "[tracker.filter]\nextrapolate_s = 0.2\n", "6:17",
              "tracker.filter.extrapolate_s"},
        Fault{"no_hold", minimal + "[tracker.filter]\nhold_s = 0\n", "6:10",
              "tracker.filter.hold_s"},
        Fault{"hold_of_a_word", minimal + "[tracker.filter]\nhold_s = \"long\"\n", "6:10",
              "tracker.filter.hold_s"},
        Fault{"no_cutoff", minimal + "[tracker.filter.one_euro]\nmin_cutoff_hz = 0\n", "6:17",
              "tracker.filter.one_euro.min_cutoff_hz"},
        Fault{"table_is_a_number", minimal + "film = 3\n", "5:8", "film"}),
    [](const testing::TestParamInfo<Fault>& test) { return test.param.name; });

/// A questionnaire with what is said of its one question.
std::string asking(const std::string& question) {
  return minimal + "[[questionnaire]]\nid = \"after\"\ntitle = \"t\"\n" +
         "[[questionnaire.question]]\nid = \"q\"\ntext = \"?\"\n" + question;
}

INSTANTIATE_TEST_SUITE_P(
    OfQuestions, ProtocolFault,
    testing::Values(
        Fault{"question_without_text", minimal + "[[rating]]\nid = \"age\"\n", "5:1", "text"},
        Fault{"question_twice", asking("[[questionnaire.question]]\nid = \"q\"\ntext = \"c\"\n"),
              "12:6", "twice"},
        Fault{"rating_called_like_a_mark", minimal + "[[rating]]\nid = \"outline\"\ntext = \"?\"\n",
              "6:6", "twice"},
        Fault{"id_with_a_space", minimal + "[[mark]]\nid = \"the outline\"\n", "6:6",
              "is not an id"},
        Fault{"mark_without_instruction", minimal + "[[mark]]\nid = \"outline\"\n", "5:1",
              "mark.instruction"},
        Fault{"unknown_kind", asking("kind = \"essay\"\n"), "11:8", "likert, number"},
        Fault{"scale_backwards", asking("minimum = 5\nmaximum = 1\n"), "12:11", "larger"},
        Fault{"scale_that_is_too_short", asking("minimum = 5\n"), "11:11",
              "range from 5 to 5 is empty"},
        Fault{"scale_of_fractions", asking("maximum = 4.5\n"), "11:11", "whole points"},
        Fault{"endless_scale", asking("maximum = 1000\n"), "11:11", "at most 101"},
        Fault{"three_labels_for_five", asking("labels = [\"a\", \"b\", \"c\"]\n"), "11:10",
              "3 labels for 5 points"},
        Fault{"labels_of_numbers", asking("labels = [1, 2]\n"), "11:10", "labels"},
        Fault{"number_without_its_end", asking("kind = \"number\"\nminimum = 1\n"), "8:1",
              "maximum"},
        Fault{"number_with_labels",
              asking("kind = \"number\"\nlabels = [\"a\", \"b\"]\nminimum = 1\nmaximum = 2\n"),
              "12:10", "a number has no labels"},
        Fault{"choice_without_options", asking("kind = \"choice\"\n"), "8:1", "two options"},
        Fault{"choice_of_one", asking("kind = \"choice\"\noptions = [{ label = \"a\" }]\n"), "8:1",
              "two options"},
        Fault{"choice_of_the_same",
              asking("kind = \"choice\"\noptions = [{ label = \"a\" }, { label = \"a\" }]\n"),
              "12:29", "not unique"},
        Fault{"choice_of_the_same_value",
              asking("kind = \"choice\"\noptions = [{ label = \"a\", value = 1 }, { label = \"b\", "
                     "value = 1 }]\n"),
              "12:40", "not unique"},
        Fault{"option_with_a_colour",
              asking("kind = \"choice\"\noptions = [{ label = \"a\", colour = 1 }]\n"), "12:27",
              "options.colour"},
        Fault{"text_with_a_maximum", asking("kind = \"text\"\nmaximum = 3\n"), "12:11",
              "a text has no maximum"},
        Fault{"questionnaire_that_asks_nothing",
              minimal + "[[questionnaire]]\nid = \"a\"\ntitle = \"t\"\n", "5:1",
              "has no questions"},
        Fault{"questionnaire_without_a_title",
              minimal + "[[questionnaire]]\nid = \"a\"\n[[questionnaire.question]]\nid = \"q\"\n"
                        "text = \"?\"\n",
              "5:1", "no title"},
        Fault{"too_many_questionnaires", many_questionnaires(), "5:1",
              "the protocol has 101 questionnaires; the maximum is 100; remove some"},
        Fault{"questionnaire_called_like_a_phase", minimal + "[[questionnaire]]\nid = \"trials\"\n",
              "6:6", "twice"},
        Fault{"questionnaire_that_is_not_ready",
              minimal + "[[questionnaire]]\nid = \"a\"\nfile = \"mine\"\n", "7:8",
              "nasa-tlx, ssq, sus"},
        Fault{"questionnaire_out_of_the_folder",
              minimal + "[[questionnaire]]\nid = \"a\"\nfile = \"../a.toml\"\n", "7:8",
              "leads out of the folder"},
        Fault{"questionnaire_of_a_file_and_its_own",
              minimal + "[[questionnaire]]\nid = \"a\"\nfile = \"ssq\"\n"
                        "[[questionnaire.question]]\nid = \"q\"\ntext = \"?\"\n",
              "8:1", "both a file and questions"}),
    [](const testing::TestParamInfo<Fault>& test) { return test.param.name; });

/// The minimal protocol with more keys at its beginning.
std::string beginning(const std::string& keys) { return keys + minimal; }

INSTANTIATE_TEST_SUITE_P(
    OfTheProcedure, ProtocolFault,
    testing::Values(
        Fault{"no_such_order", beginning("scene_order = \"balanced\"\n"), "1:15",
              "fixed, random, latin, williams"},
        Fault{"order_of_a_number", beginning("method_order = 3\n"), "1:16", "method_order"},
        Fault{"object_per_day", beginning("object = \"per day\"\n"), "1:10",
              "per scene, per method"},
        Fault{"no_language", beginning("language = \"plain English\"\n"), "1:12",
              "not a language tag"},
        Fault{"unknown_text", minimal + "[texts]\ngreeting = \"Hi\"\n", "6:1", "texts.greeting"},
        Fault{"unknown_name_in_a_text", minimal + "[texts]\nready_title = \"{method} is next\"\n",
              "6:15", "{method}"},
        Fault{"practice_in_another_scene",
              minimal + "[[practice]]\nscene = \"hall\"\nmethod = \"od\"\n", "6:9", "'hall'"},
        Fault{"practice_with_another_method",
              minimal + "[[practice]]\nscene = \"room\"\nmethod = \"vp\"\n", "7:10", "'vp'"},
        Fault{"practice_of_no_method", minimal + "[[practice]]\nscene = \"room\"\n", "5:1",
              "practice.method"},
        Fault{"too_many_catch_trials", minimal + "[catch_trials]\ncount = 5\n", "6:9",
              "between 4 trials"},
        Fault{"waits_backwards", minimal + "[reaction]\nshortest_wait_s = 2\nlongest_wait_s = 1\n",
              "7:18", "longest"},
        Fault{"wait_longer_than_the_longest", minimal + "[reaction]\nshortest_wait_s = 4\n", "6:19",
              "from 4 to 3 seconds is empty"},
        Fault{"override_of_nothing", minimal + "[[override]]\nfilm.width = 9\n", "5:1",
              "has neither a scene nor a method"},
        Fault{"override_in_another_scene", minimal + "[[override]]\nscene = \"hall\"\n", "6:9",
              "'hall'"},
        Fault{"override_twice",
              minimal + "[[override]]\nscene = \"room\"\n[[override]]\nscene = \"room\"\n", "7:1",
              "another override"},
        Fault{"override_of_the_display", minimal + "[[override]]\nscene = \"room\"\ndisplay = {}\n",
              "7:1", "override.display"},
        Fault{"override_of_an_unknown_key",
              minimal + "[[override]]\nscene = \"room\"\nfilm.depth = 3\n", "7:6", "film.depth"},
        Fault{"phases_without_trials", beginning("phases = []\n"), "1:10", "phases"},
        Fault{"phases_that_forget_the_trials",
              beginning("phases = [\"reaction\"]\n") + "[reaction]\n", "1:10",
              "'trials' is in no phase"},
        Fault{"phase_twice", beginning("phases = [\"trials\", \"trials\"]\n"), "1:21", "twice"},
        Fault{"phase_of_nothing", beginning("phases = [\"trials\", \"quiz\"]\n"), "1:21", "quiz"},
        Fault{"letter_as_a_key",
              minimal + "[texts]\nlook_around_keys = \"[Enter] weiter    [R] noch einmal\"\n",
              "6:20", "names the key [R]"},
        Fault{"letter_of_another_alphabet", minimal + "[texts]\nready_keys = \"[Д] да\"\n", "6:14",
              "names the key [Д]"},
        Fault{"keys_of_a_page_with_a_list",
              minimal + "[texts]\nconsent_keys = \"[Enter] Ja    [Backspace] Nein\"\n", "6:16",
              "consent_yes"},
        Fault{"consent_to_nothing", beginning("phases = [\"consent\", \"trials\"]\n"), "1:11",
              "[texts]"},
        Fault{"validation_of_nothing", beginning("phases = [\"validation\", \"trials\"]\n"), "1:11",
              "[tracker.validation]"},
        Fault{"questionnaire_in_no_phase",
              beginning("phases = [\"trials\"]\n") +
                  "[[questionnaire]]\nid = \"ssq\"\nfile = \"ssq\"\n",
              "1:10", "'ssq' is in no phase"},
        Fault{"nothing_measures_that",
              minimal + "[[analysis.primary]]\nmeasure = \"beauty\"\nmethod = \"fv\"\n", "6:11",
              "outline, material, artifacts"},
        Fault{"compared_with_itself",
              minimal + "[[analysis.primary]]\nmeasure = \"outline\"\nmethod = \"od\"\n", "7:10",
              "itself"},
        Fault{"compared_twice",
              minimal + "[[analysis.primary]]\nmeasure = \"outline\"\nmethod = \"fv\"\n"
                        "[[analysis.primary]]\nmeasure = \"outline\"\nmethod = \"fv\"\n",
              "8:1", "twice"},
        Fault{"compared_twice_the_other_way_round",
              minimal + "[[analysis.primary]]\nmeasure = \"outline\"\nmethod = \"fv\"\n"
                        "[[analysis.primary]]\nmeasure = \"outline\"\nmethod = \"od\"\n"
                        "baseline = \"fv\"\n",
              "8:1", "twice"},
        Fault{"mark_called_like_the_built_in_rating",
              minimal + "[[mark]]\nid = \"a\"\ninstruction = \"Now.\"\n"
                        "[[mark]]\nid = \"artifacts\"\ninstruction = \"Now.\"\n",
              "9:6", "is the id of the built-in rating; give the mark another id"},
        Fault{"rating_called_like_a_mark",
              minimal + "[[mark]]\nid = \"a\"\ninstruction = \"Now.\"\n"
                        "[[rating]]\nid = \"a\"\ntext = \"?\"\n",
              "9:6", "used twice"},
        Fault{"compared_with_another_study",
              minimal + "[[analysis.primary]]\nmeasure = \"outline\"\nmethod = \"fv\"\n"
                        "baseline = \"vp\"\n",
              "8:12", "'vp'"},
        Fault{"margin_of_nothing", minimal + "[analysis.equivalence_margins]\nbeauty = 2\n", "6:1",
              "the keys here are artifacts, material, outline"},
        Fault{"margin_that_is_no_ratio", minimal + "[analysis.equivalence_margins]\noutline = 1\n",
              "6:11", "outline"},
        Fault{"background_of_nothing",
              minimal + "[analysis]\nbackground = [\"children\"]\n"
                        "[[questionnaire]]\nid = \"background\"\ntitle = \"You\"\n"
                        "[[questionnaire.question]]\nid = \"expertise\"\ntext = \"1 to 7\"\n"
                        "minimum = 1\nmaximum = 7\n"
                        "[[questionnaire.question]]\nid = \"hand\"\ntext = \"Hand\"\n"
                        "kind = \"choice\"\n"
                        "options = [{ label = \"left\", value = 1 }, { label = \"right\" }]\n",
              "6:15", "question 'children'; choose from expertise"},
        Fault{"nobody_is_planned", minimal + "[analysis]\nparticipants = 0\n", "6:16",
              "participants"}),
    [](const testing::TestParamInfo<Fault>& test) { return test.param.name; });

}  // namespace
}  // namespace foveola::study
