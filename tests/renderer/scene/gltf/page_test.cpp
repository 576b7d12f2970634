// renderer/GLTF.md says of each extension what becomes of a file that uses it, or requires it. Each
// of its other rows is held by a test of its own.
#include <array>
#include <filesystem>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "renderer/base/error.h"
#include "renderer/base/files/files.h"
#include "renderer/scene/obj/text_lines.h"
#include "tests/renderer/scene/glb_builder.h"

namespace foveola::test {
namespace {

struct Row {
  std::string extension;
  bool works;
  bool refuses_if_required;
};

/// Names such as "KHR_materials_ior, _volume" share the beginning up to their last part.
std::vector<std::string> extensions_in(const std::string& feature) {
  std::vector<std::string> names;
  std::string beginning;
  const std::regex name(R"(\b(?:KHR|EXT)_\w+|(?:^|[ ,])(_\w+))");
  for (std::sregex_iterator found(feature.begin(), feature.end(), name), end; found != end;
       ++found) {
    if ((*found)[1].matched) {
      names.push_back(beginning + (*found)[1].str());
      continue;
    }
    names.push_back(found->str());
    const std::size_t group = names.back().find('_', 4);
    beginning = names.back().substr(0, group);
  }
  return names;
}

/// Calls visit(feature, verdict) for the rows of its tables.
template <typename Visit>
void visit_rows_of_page(const Visit& visit) {
  const std::string page =
      read_file(std::filesystem::path(TEST_DATA_DIR) / "../../renderer/GLTF.md");
  for_each_line(page, [&](std::string_view line) {
    const std::size_t middle = line.find(" | ", 2);
    if (line.starts_with("| ") && middle != std::string_view::npos && !line.ends_with("| |")) {
      visit(std::string(line.substr(2, middle - 2)), line.substr(middle + 3));
    }
  });
}

/// The rows that name extensions, and one of an extension that nothing knows.
std::vector<Row> extensions_of_page() {
  std::vector<Row> rows = {
      {.extension = "EXT_of_nobody", .works = false, .refuses_if_required = true}};
  visit_rows_of_page([&](const std::string& feature, std::string_view verdict) {
    for (const std::string& extension : extensions_in(feature)) {
      rows.push_back(
          {.extension = extension,
           .works = verdict.starts_with("works"),
           .refuses_if_required =
               verdict.find("refuses where required") != std::string::npos ||
               verdict.find("refuses where the extension is required") != std::string::npos});
    }
  });
  return rows;
}

using GltfPage = LoadGltf;

TEST_F(GltfPage, IsTrueOfEveryExtension) {
  const std::vector<Row> rows = extensions_of_page();
  EXPECT_GE(rows.size(), 20U);
  for (const Row& row : rows) {
    GlbBuilder glb = one_triangle();
    glb.document["extensionsUsed"] = {row.extension};
    EXPECT_EQ(load(glb).warnings.empty(), row.works) << row.extension;
    glb.document["extensionsRequired"] = {row.extension};
    const bool is_refused = [&] {
      try {
        load(glb);
        return false;
      } catch (const Error&) {
        return true;
      }
    }();
    EXPECT_EQ(is_refused, !row.works) << row.extension;
    EXPECT_TRUE(row.works || row.refuses_if_required) << row.extension << ": the page does not say";
  }
}

/// The beginnings of the page's rows without an extension, in order, and the tests that hold them.
struct HeldRow {
  std::string_view beginning;
  std::string_view test;
};
constexpr std::array<HeldRow, 68> held_rows = {{
    {".glb; .gltf with external", "GltfFiles, ReadsBuffersBesideTheScene"},
    {"unused buffers without", "GltfFiles, BuffersThatNothingUsesNeedNoContent"},
    {"integers written as 1.0", "LoadGltf, WholeNumbersMayBeWrittenWithAPoint"},
    {"references with backslashes", "ConfinedFile, PathsThatReturnIntoTheFolderStay"},
    {"references out of the", "ConfinedFile, PathsOutOfTheFolderNameAFileInIt"},
    {"links out of the folder", "ConfinedFile, RefusesLinksThatLeaveTheFolder"},
    {"triangles, strips, fans", "Geometry, StripsAndFansMayBeIndexed"},
    {"points and lines", "Geometry, PointsAreSkippedWithAWarning"},
    {"missing normals", "Geometry, ComputesMissingTangentsOfNormalMappedMeshes"},
    {"several sets of texture", "GltfMaterials, AMeshKeepsTheCoordinatesThatItsTexturesUse"},
    {"further vertex colours", "Geometry, WarnsOfFurtherColours"},
    {"morph targets", "GltfDeformation, MorphsByTheMeshsWeights"},
    {"skins", "GltfDeformation, SkinsStandWhereTheirJointsDo"},
    {"animations: translation", "GltfAnimation, GoesOnCubicSplines"},
    {"nodes: translation", "Nodes, ComposesInDoublePrecision"},
    {"meshes in several places", "Placing, ManyTrianglesAreKeptOnceAndShownByInstances"},
    {"scenes far from their", "Placing, FarScenesAreSeenFromNearby"},
    {"perspective cameras", "Nodes, CamerasKeepTheirFieldOfViewAndAspectRatio"},
    {"orthographic cameras", "Nodes, OrthographicCamerasAreIgnoredWithAWarning"},
    {"samplers", "GltfMaterials, SamplersSayHowToFilter"},
    {"a texture that is missing", "GltfTextures, TexturesThatCannotBeHadAreLeftOut"},
    {"metallic-roughness with", "GltfMaterials, ReadsFactors"},
    {"occlusion textures", "GltfMaterials, OcclusionAndThicknessTexturesHaveNoEffect"},
    {"thickness textures", "GltfMaterials, OcclusionAndThicknessTexturesHaveNoEffect"},
    {"single-sided surfaces", "SurfaceTest, SingleSidedEmittersShineFromTheirFront"},
    {"volumes in volumes", "NestedVolumes, AreWarnedOf"},
    {"triangles without area", "Geometry, DropsTrianglesWithoutAreaAndCountsThem"},
    {"factors out of range", "GltfMaterials, LimitsFactorsWithAWarning"},
    {"another extension in", "GltfPage, IsTrueOfEveryExtension"},
    {"another extension in", "GltfPage, IsTrueOfEveryExtension"},
    {"damaged files, indices", "Geometry, RefusesAnIndexBeyondTheVertices"},
    {"images beyond the limits", "GltfMaterials, RefusesMoreTexelsThanHalfOfTheMemoryHolds"},
    {"`radius_m`", "GltfLights, HaveTheSizesOfTheirExtras"},
    {"`angular_radius_rad`", "GltfLights, SizesAreLimitedWithAWarning"},
    {"v, vt, vn, f", "LoadObj, NegativeIndicesCountBackwards"},
    {"coordinates that are not", "LoadObj, WhatIsNoNumberIsNotZero"},
    {"a vertex's colour", "ObjColors, MayBePaintedByZBrush"},
    {"a vertex's weight", "ObjColors, FollowTheCoordinates"},
    {"UTF-8 with a byte order", "Utf8Text, KeepsUtf8AndBlanksItsByteOrderMark"},
    {"folders in the names of", "ForeignObj, FindsTexturesAsOtherSystemsNameThem"},
    {"paths of another machine", "ForeignObj, TexturesOfAnotherMachineAreThoseBesideTheScene"},
    {"links out of the OBJ", "ObjReferences, StayInTheFolder"},
    {"a material library that", "ForeignObj, AMissingLibraryIsLeftOut"},
    {"textures: PNG, JPEG", "ImageDecoder, OnePictureHasTheSameTexelsInEveryFormat"},
    {"a texture that is missing", "ForeignObj, TexturesThatCannotBeHadAreLeftOut"},
    {"s: faces without normals", "ForeignObj, SmoothingGroupsHaveSmoothNormals"},
    {"l, p, curves", "LoadObj, AnEmptySceneLoadsAndSaysSo"},
    {"Kd, Ks, Ke", "MtlMaterials, KsAndNsAreAHighlight"},
    {"bump maps in colours", "MtlMaterials, ABumpMapInColoursIsANormalMap"},
    {"words in place of", "MtlMaterials, WhatIsNoNumberIsNotZero"},
    {"d -halo", "MtlMaterials, HaloIsReadWithoutItsHalo"},
    {"illum 6, 7, 9", "MtlMaterials, GlassIsSolidAndSmooth"},
    {"d < 1", "MtlMaterials, DissolveBlends"},
    {"illum 3, 5", "MtlMaterials, BlackWithAMirrorsIllumIsASmoothMetal"},
    {"Pr, Pm, Ps", "MtlMaterials, ReadsTheExtensionForPhysicallyBasedRendering"},
    {"bump maps in greys", "MtlMaterials, SaysWhatItIgnoresAndLimits"},
    {"options of maps", "MtlMaterials, TextureOptionsMayLeaveOutNumbers"},
    {"other options of maps", "MtlMaterials, TextureOptionsMayLeaveOutNumbers"},
    {"a map that names no file", "MtlMaterials, MapsWithoutAFileAreNoMaps"},
    {"EXR, HDR", "LoadEnvironment, ReadsThePicturesThatCompareReads"},
    {"EXR: data windows", "LoadEnvironment, APartOfThePictureStandsWhereTheFileSays"},
    {"EXR: channels R, G, B", "LoadEnvironment, OfSeveralLayersTheCombinedOneIsShown"},
    {"HDR: scanlines", "LoadEnvironment, RadianceScanlinesRunAsTheirHeaderSays"},
    {"one channel, or two", "LoadEnvironment, GreyAndAlphaAreSpreadAndDropped"},
    {"pictures that are not", "LoadEnvironment, WhatIsNoPanoramaIsNamed"},
    {"pixels that are negative", "LoadEnvironment, WhatIsNotLightIsDarkAndCounted"},
    {"infinite pixels", "LoadEnvironment, InfiniteLightIsLimitedAndCounted"},
    {"damaged files, other", "LoadEnvironment, RefusesWhatIsNoImage"},
}};

std::string all_tests_of_renderer() {
  std::string text;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(
           std::filesystem::path(TEST_DATA_DIR) / "../renderer")) {
    text += entry.path().extension() == ".cpp" ? read_file(entry.path()) : "";
  }
  return text;
}

TEST_F(GltfPage, HoldsEveryOtherRowByATest) {
  std::vector<std::string> features;
  visit_rows_of_page([&](const std::string& feature, std::string_view) {
    if (extensions_in(feature).empty()) {
      features.push_back(feature);
    }
  });
  ASSERT_EQ(features.size(), held_rows.size());
  const std::string tests = all_tests_of_renderer();
  for (std::size_t i = 0; i < features.size(); ++i) {
    const auto& [beginning, test] = held_rows[i];
    EXPECT_THAT(features[i], StartsWith(std::string(beginning)));
    EXPECT_NE(tests.find(fmt::format("({})", test)), std::string::npos) << test;
  }
}

}  // namespace
}  // namespace foveola::test
