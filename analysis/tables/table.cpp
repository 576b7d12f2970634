#include "analysis/tables/table.h"

#include <set>

#include <fmt/format.h>

#include "renderer/base/error.h"

namespace foveola::analysis {

const char* name_of(ColumnType type) {
  switch (type) {
    case ColumnType::whole:
      return "integer";
    case ColumnType::number:
      return "number";
    case ColumnType::truth:
      return "boolean";
    case ColumnType::text:
      break;
  }
  return "string";
}

void require_distinct_names(const std::vector<Column>& columns) {
  std::set<std::string> names;
  for (const Column& column : columns) {
    if (!names.insert(column.name).second) {
      throw Error(
          fmt::format("column '{}'", column.name), "two columns of a table have this name",
          "rename the mark, rating or questionnaire of the protocol that is part of the name");
    }
  }
}

}  // namespace foveola::analysis
