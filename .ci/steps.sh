# Sourced by the scripts beside it: steps that say at the end how long each took.
minutes=()
in_minutes() { printf '%3d:%02d min' $(($1 / 60)) $(($1 % 60)); }
print_minutes() { printf 'CI: %s\n' "${minutes[@]}" "$(in_minutes "$SECONDS") in all"; }
trap print_minutes EXIT

# The test programs that the thread sanitizer looks at.
where_threads_meet=(base_test film_test gaze_test preview_test window_test headset_test record_test)

# Those that the sanitizer for addresses and undefined behaviour looks at on every submission: they
# read files and devices, or write the record. What is built upon them (commands, replays, the analysis)
# takes as long to compile as all of these, and has its turn with the rest in .ci/long sanitized.
where_data_are_read_and_kept=(base_test glb_test image_test film_test scene_test scenes_test
  gaze_test design_test protocol_test record_test study_tables_test fuzz_corpus_test)

# Those that meet what differs from one Debian release to another: the libraries that read scenes and
# pictures, trace rays, draw in windows and terminals, talk to devices and keep the record.
where_releases_differ=(base_test glb_test image_test scene_test trace_test progressive_test gaze_test
  window_test renderer_commands_test record_test console_test)

# any_of NAME...: a regular expression.
any_of() { (IFS='|' && echo "($*)"); }

# step NAME COMMAND...
step() {
  local name=$1 began=$SECONDS
  shift
  "$@"
  minutes+=("$(in_minutes $((SECONDS - began))) $name")
}

# at_once FIRST SECOND: runs two commands, neither of which keeps two cores busy by itself, and shows
# what FIRST says when it has ended.
at_once() {
  local said first passed=yes
  said=$(mktemp)
  "$1" >"$said" 2>&1 &
  first=$!
  "$2"
  wait "$first" || passed=no
  cat "$said"
  rm -f "$said"
  [ "$passed" = yes ]
}

# leaves_nothing COMMAND...: shows what it says only if it fails, and runs it again where the leak
# detector itself failed (see tests/CMakeLists.txt).
leaves_nothing() {
  local said
  for _ in 1 2 3 4; do
    said=$("$@" 2>&1) && return
    grep -q 'LeakSanitizer has encountered a fatal error' <<<"$said" || break
  done
  printf '%s\n' "$said"
  return 1
}

# leaks PROGRAM...: whole test programs, several at a time.
leaks() {
  export -f leaves_nothing
  printf '%s\n' "$@" |
    xargs -P "$(nproc)" -I PROGRAM bash -c 'leaves_nothing build/asan/tests/PROGRAM --gtest_brief=1'
}
