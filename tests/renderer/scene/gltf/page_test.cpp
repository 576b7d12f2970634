// renderer/GLTF.md says of each extension what becomes of a file that uses it, or requires it.
#include <filesystem>
#include <regex>
#include <string>
#include <vector>

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

/// The rows of its tables that name extensions, as far as they end in a bar.
std::vector<Row> rows_of_page() {
  std::vector<Row> rows;
  const std::string page =
      read_file(std::filesystem::path(TEST_DATA_DIR) / "../../renderer/GLTF.md");
  for_each_line(page, [&](std::string_view line) {
    const std::size_t middle = line.find(" | ", 2);
    if (!line.starts_with("| ") || middle == std::string_view::npos) {
      return;
    }
    const std::string verdict(line.substr(middle + 3));
    for (const std::string& extension : extensions_in(std::string(line.substr(2, middle - 2)))) {
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
  const std::vector<Row> rows = rows_of_page();
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

}  // namespace
}  // namespace foveola::test
