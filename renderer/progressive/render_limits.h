// Checks the ranges of a render's settings, for the command line and for Python.
#pragma once

#include <cstdint>
#include <optional>

#include "renderer/progressive/headless_render.h"

namespace foveola {

/// The settings' names in the user's interface; messages begin with these.
struct SettingNames {
  const char* camera = "--camera";
  const char* head = "--head";
  const char* gaze = "--gaze";
  const char* size = "--size";
  const char* samples_per_pixel = "--spp";
  const char* samples = "--samples";
  const char* seconds = "--seconds";
  const char* max_depth = "--max-depth";
  const char* threads = "--threads";
  const char* remedy = "see foveola render --help";
};

/// The amount of rendering: one of these.
struct BudgetChoices {
  std::optional<double> samples_per_pixel;
  std::optional<std::int64_t> samples;
  std::optional<double> seconds;
  double default_samples_per_pixel = 16.0;
};

/// Throws UsageError for more than one choice, and for a number out of its range.
RenderBudget budget_of(const BudgetChoices& choices, const SettingNames& names = {});

/// Throws UsageError for the first impossible setting, except the budget.
void require_possible(const RenderSettings& settings, const SettingNames& names = {});

}  // namespace foveola
