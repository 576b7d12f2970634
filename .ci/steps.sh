# Sourced by run and long: steps, whose minutes are printed at the end and kept in a file.
minutes_csv=$PWD/build/ci_minutes.csv # kind (step, skipped or case), name, seconds, those of processors
mkdir -p build
echo kind,name,seconds,processor_seconds >"$minutes_csv"

print_minutes() {
  local status=$?
  awk -F'","|",|,"' '
    $1 == "step" {
      split($3, seconds, ",")
      printf "CI: %3d:%02d min, %5.1f of processors: %s\n", seconds[1] / 60, seconds[1] % 60, seconds[2] / 60, $2
    }
    $1 == "skipped" {printf "CI:    skipped %s\n", $2}' "$minutes_csv"
  printf 'CI: %3d:%02d min in all\n' $((SECONDS / 60)) $((SECONDS % 60))
  [ "$status" -eq 0 ] || printf 'CI: failed in: %s\n' "$running_step"
}
trap print_minutes EXIT

# Sets processor_s: what the programs that this shell has waited for took, in the kernel too.
take_processor_s() {
  local stat
  read -ra stat </proc/$BASHPID/stat
  processor_s=$(((stat[15] + stat[16]) / 100))
}

running_step='what comes before the steps'

# step NAME COMMAND...
step() {
  local name=$1 began=$SECONDS processor_s began_s
  shift
  running_step=$name
  printf 'CI: %s\n' "$name"
  take_processor_s
  began_s=$processor_s
  "$@"
  take_processor_s
  printf 'step,"%s",%d,%d\n' "$name" $((SECONDS - began)) $((processor_s - began_s)) >>"$minutes_csv"
}

# skip_step NAME REASON
skip_step() { printf 'skipped,"%s: %s",\n' "$1" "$2" >>"$minutes_csv"; }

# --- What changed ---

# Prints the commit that this branch began from; fails where it is not known. It is FOVEOLA_BRANCH_BASE,
# or where the branch left origin/main, or the commit in .ci/base.
branch_base() {
  local base=${FOVEOLA_BRANCH_BASE:-}
  [ -n "$base" ] || base=$(git merge-base HEAD origin/main 2>/dev/null || true)
  if [ -z "$base" ] || [ "$(git rev-parse "$base")" = "$(git rev-parse HEAD)" ]; then
    base=$(cat .ci/base 2>/dev/null || true)
  fi
  git merge-base --is-ancestor "$base" HEAD 2>/dev/null && git rev-parse "$base"
}

# has_changed PATTERN: whether a file whose path has the extended regular expression has changed since
# then; so it has where that commit is not known.
has_changed() {
  local base
  base=$(branch_base) || return 0
  git diff --name-only "$base" -- . ':!.ci/base' | grep -E "$1" >/dev/null
}

# step_if_changed PATTERN NAME COMMAND...: a step that is skipped if has_changed PATTERN fails.
step_if_changed() {
  local pattern=$1
  shift
  if has_changed "$pattern"; then
    step "$@"
  else
    skip_step "$1" "no file like $pattern has changed since $(branch_base)"
  fi
}
