# Sourced by the scripts beside it: steps that say at the end how long each took.
minutes=()
in_minutes() { printf '%3d:%02d min' $(($1 / 60)) $(($1 % 60)); }
print_minutes() { printf 'CI: %s\n' "${minutes[@]}" "$(in_minutes "$SECONDS") in all"; }
trap print_minutes EXIT

# The test programs that the thread sanitizer looks at.
where_threads_meet=(base_test film_test gaze_test preview_test window_test record_test)

# any_of NAME...: a regular expression.
any_of() { (IFS='|' && echo "($*)"); }

# step NAME COMMAND...
step() {
  local name=$1 began=$SECONDS
  shift
  "$@"
  minutes+=("$(in_minutes $((SECONDS - began))) $name")
}
