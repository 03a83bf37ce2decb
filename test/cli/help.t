Every command has a manual with its exit codes.

  $ for command in check trace view export explore shape inflate decompose fmt translate; do
  >   scc $command --help=plain | grep -A 40 'EXIT STATUS' | grep -cE '^ +(0|3|4|64|70) '
  > done
  5
  5
  5
  5
  5
  5
  5
  5
  5
  5
  $ scc --version
  0.1.0 (semantics 3)
  $ python3 -B unread.py scc check --help=plain
  [4]
  $ scc check --help=plain > /dev/full
  standard output: error[SC0103]: cannot write: No space left on device
  [74]
