The pictures of the README and the guide are those that scc draws.

  $ scc view ../../specs/models/hexokinase.sc --svg 1 --names -o hexokinase.svg 2> /dev/null
  $ cmp ../../specs/pictures/hexokinase.svg hexokinase.svg

  $ scc check ../../specs/models/meeting.sc --draw meeting.svg > /dev/null
  [1]
  $ cmp ../../specs/pictures/meeting.svg meeting.svg
  $ cat > ell.off <<'END'
  > OFF
  > 12 8 0
  > 0 0 0
  > 2 0 0
  > 2 0 1
  > 1 0 1
  > 1 0 2
  > 0 0 2
  > 0 2 0
  > 2 2 0
  > 2 2 1
  > 1 2 1
  > 1 2 2
  > 0 2 2
  > 6 0 1 2 3 4 5
  > 6 6 11 10 9 8 7
  > 4 0 6 7 1
  > 4 1 7 8 2
  > 4 2 8 9 3
  > 4 3 9 10 4
  > 4 4 10 11 5
  > 4 5 11 6 0
  > END
  $ scc shape ell.off --svg ell.svg > /dev/null
  [3]
  $ cmp ../../specs/pictures/ell.svg ell.svg
