The chapter of the guide on what is not known: its model says what the guide says, and draws its picture.

  $ guide=../../specs/guide.md
  $ block () { awk -v n="$1" '/^## /{inside = /What if I do not know/} inside && /^```/{k++; next} inside && k == 2 * n - 1' $guide; }
  $ block 1 > race.sc
  $ block 2 > expected
  $ scc check race.sc --where --draw race.svg > found
  [1]
  $ diff expected found
  $ cmp ../../specs/race.svg race.svg
