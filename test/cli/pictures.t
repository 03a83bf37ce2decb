The pictures of the README and the guide are those that scc draws.

  $ scc view ../../specs/models/hexokinase.sc --svg 1 --names -o hexokinase.svg 2> /dev/null
  $ cmp ../../specs/pictures/hexokinase.svg hexokinase.svg

  $ scc view ../../specs/models/bone.sc --svg 9 --up 0,0,1 --from 1,-3,1 --width 480 -o bone.svg 2> /dev/null
  $ cmp ../../specs/pictures/bone.svg bone.svg
  $ scc view ../../specs/models/crosslink.sc --check can --svg 3 --up 0,0,1 --from 1,-4,2 --width 480 \
  >   --without cell.south --without cell.ceiling -o crosslink.svg 2> /dev/null
  $ cmp ../../specs/pictures/crosslink.svg crosslink.svg
  $ scc view ../../specs/models/glycolysis.sc --check possible --svg 1 --up 0,0,1 --from 1,-2,3 --width 480 \
  >   --without cell.south --without cell.ceiling -o glycolysis.svg 2> /dev/null
  $ cmp ../../specs/pictures/glycolysis.svg glycolysis.svg
  $ scc view ../../specs/models/capsid.sc --svg 2 --width 480 -o capsid.svg 2> /dev/null
  $ cmp ../../specs/pictures/capsid.svg capsid.svg

The one of a drawn enzyme is made from the drawing, and the solid in between is the one that the model has:

  $ scc inflate ../../specs/models/parts/hexokinase.svg --resolution 48 --strength 1/2 --faces 60 --scale 1/8 \
  >   -o hexokinase.obj > /dev/null && cmp ../../specs/models/parts/hexokinase.obj hexokinase.obj
  $ grep -c -- '--resolution 48 --strength 1/2 --faces 60 --scale 1/8' ../../scripts/drawing
  1
  $ scc view ../../specs/models/drawn_hexokinase.sc --svg 3 --from 3,2,9 --width 480 -o drawn_hexokinase.svg 2> /dev/null
  $ cmp ../../specs/pictures/drawn_hexokinase.svg drawn_hexokinase.svg

What is left out takes its marks along: here a family, of which the bonds are.

  $ scc view ../../specs/models/crosslink.sc --check can --svg 3 --without cell --without receptor -o few.svg 2> /dev/null
  $ grep -c 'fab' few.svg crosslink.svg
  few.svg:0
  crosslink.svg:2
Near walls of a room are of glass, from any side, while something is inside:

  $ scc view ../../specs/models/crowds/pore.sc -D n=2 --svg 0 -o room.svg 2> /dev/null; grep -c 'opacity="0.22"' room.svg
  3
  $ scc view ../../specs/models/crowds/pore.sc -D n=2 --svg 0 --from 0,0,-1 -o room.svg 2> /dev/null
  $ grep -c 'opacity="0.22"' room.svg
  1
  $ scc view ../../specs/models/crowds/pore.sc -D n=2 --svg 0 --without p -o room.svg 2> /dev/null
  $ grep -c 'opacity="0.22"' room.svg
  0
  [1]

  $ scc view ../../specs/models/bone.sc --svg 9 --without cell.south
  command line: error[SC0201]: no body, part or family of bodies is called `cell.south`
    hint: parts of compounds are named with their body, as in --without room.south
  [64]
  $ scc view ../../specs/models/bone.sc --without marrow
  scc: --names, --without, --from, --up and --width tell how --svg draws
  Usage: scc view [OPTION]… MODEL
  Try 'scc view --help' or 'scc --help' for more information.
  [64]

  $ scc check ../../specs/models/meeting.sc --draw meeting.svg > /dev/null
  [1]
  $ cmp ../../specs/pictures/meeting.svg meeting.svg
  $ scc shape ell.off --svg ell.svg > /dev/null
  [3]
  $ cmp ../../specs/pictures/ell.svg ell.svg
