#include "analysis/tables/table.h"

#include <set>

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
      throw Error(column.name, "is the name of two columns of a table",
                  "give the protocol's marks, ratings and questionnaires other ids");
    }
  }
}

}  // namespace foveola::analysis
