# Sourced by run and everything, with the root of the project as working directory.

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
passed=0
failed=0

not_run() {
  echo "not run: $*"
  [ -z "${CI:-}" ] || failed=$((failed + 1))
}

# expect WHAT COMMAND…: the command succeeds; what it has written is shown if it does not.
expect() {
  claim=$1
  shift
  if "$@" > "$work/log" 2>&1; then
    passed=$((passed + 1))
    echo "ok: $claim"
  else
    failed=$((failed + 1))
    echo "FAILED: $claim"
    tail -40 "$work/log"
  fi
}

# says TEXT COMMAND…: the command fails, and says the text.
says() {
  text=$1
  shift
  if "$@" > "$work/said" 2>&1; then
    cat "$work/said"
    echo 'that was no error'
    return 1
  fi
  cat "$work/said"
  grep -qF -e "$text" "$work/said"
}

# prints TEXT COMMAND…: the command prints the text.
prints() {
  text=$1
  shift
  "$@" > "$work/printed" 2>&1 || :
  cat "$work/printed"
  grep -qF -e "$text" "$work/printed"
}

same() { cmp "$@"; }

# The one file of a pattern.
only() {
  [ $# -eq 1 ] && [ -e "$1" ] || { echo "not one file: $*" >&2; return 1; }
  echo "$1"
}

finish() {
  echo "$passed passed, $failed failed" > "$counts"
  echo "$passed passed, $failed failed"
  [ "$failed" -eq 0 ]
}
