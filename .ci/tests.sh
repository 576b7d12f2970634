# Sourced by the scripts beside it: which test programs they build and run, and how.

# The test programs of the threaded modules, for the thread sanitizer, beside the threads' suites of
# record_test, and where their files are.
threaded_tests=(base_test film_test gaze_test preview_test window_test headset_test console_test)
threaded_files='^((tests/)?(renderer/(base|film|gaze|preview|window|headset)|study/(record|console))/|tests/(openxr/|thread_sanitizer)|CMakePresets|\.ci/)'

# The test programs of modules that read files and devices or write the record, for the sanitizer of
# addresses and undefined behaviour; .ci/long runs all. A fuzzer reads films there.
reading_tests=(base_test image_test scene_test gaze_test protocol_test record_test fuzz_corpus_test)

# Those of modules that use what differs between Debian's releases, the libraries that trace rays and draw
# in windows and terminals; what reads scenes, pictures and devices and keeps the record runs there with
# the sanitizer. .ci/long new_machines runs all.
release_tests=(trace_test window_test console_test)

# build PRESET TARGET...: prints the errors if it fails.
build() {
  local preset=$1 log
  shift
  log=$(mktemp)
  cmake --preset "$preset" -G Ninja -DBUILD_TESTING=ON >/dev/null
  cmake --build --preset "$preset" --target "$@" >"$log" || {
    grep -A 40 '^FAILED' "$log" | tail -n 100
    return 1
  }
  tail -n 1 "$log"
}

# any_of NAME...: a regular expression.
any_of() { (IFS='|' && echo "($*)"); }

# run_tests PRESET PROGRAM...: neither the slow nor the long ones.
run_tests() {
  local preset=$1
  shift
  ctest --preset "$preset" --no-tests=error --parallel "$(nproc)" --label-regex "^$(any_of "$@")\$"
}

# at_once FIRST SECOND: runs two functions, neither of which keeps two cores busy by itself, and then shows
# what each printed, what failed last. FIRST ignores SIGINT, as a shell's background jobs do.
at_once() {
  local first_log second_log first status=0
  first_log=$(mktemp)
  second_log=$(mktemp)
  (set -e; "$1") >"$first_log" 2>&1 &
  first=$!
  set +e
  (set -e; "$2") >"$second_log" 2>&1
  status=$?
  set -e
  if wait "$first"; then
    cat "$first_log" "$second_log"
  else
    status=1
    cat "$second_log" "$first_log"
  fi
  rm -f "$first_log" "$second_log"
  return "$status"
}

# --- Our files and programs beside those of others; what is missing is installed, by root ---

read_trackers_through_a_kernel() { tests/kernel_hid/run_in_qemu --install || [ $? -eq 77 ]; }
run_in_slurm() { tests/slurm/run_in_slurm --install || [ $? -eq 77 ]; }
read_tables_in_r_and_pandas() {
  tests/analysis/readers/check --install
  ctest --preset release --no-tests=error --tests-regex '^csv_files_in_|/FitModels'
}
validate_bids() {
  tests/analysis/bids/check --install
  tests/analysis/bids/check build/release/foveola
}
