#include "renderer/base/work_scope.h"

#include <utility>

namespace foveola {
namespace {

thread_local const WorkScope* current_scope = nullptr;

}  // namespace

WorkScope::WorkScope(std::stop_token stop, Report report)
    : stop_(std::move(stop)), report_(std::move(report)), member_(this) {}

WorkScope::~WorkScope() = default;

void WorkScope::report(const char* step, double fraction_done) const {
  if (report_) {
    report_(step, fraction_done);
  }
}

const WorkScope* WorkScope::current() { return current_scope; }

WorkScope::Member::Member(const WorkScope* scope) : before_(std::exchange(current_scope, scope)) {}

WorkScope::Member::~Member() { current_scope = before_; }

bool is_work_stopped() { return current_scope != nullptr && current_scope->is_stopped(); }

void throw_if_work_stopped() {
  if (is_work_stopped()) {
    throw WorkStopped();
  }
}

}  // namespace foveola
