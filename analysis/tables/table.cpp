#include "analysis/tables/table.h"

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

}  // namespace foveola::analysis
