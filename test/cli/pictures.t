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
  scc: --names, --without, --camera, --from, --up and --width tell how --svg draws
  Usage: scc view [OPTION]… MODEL
  Try 'scc view --help' or 'scc --help' for more information.
  [64]

  $ scc check ../../specs/models/meeting.sc --draw meeting.svg > /dev/null
  [1]
  $ cmp ../../specs/pictures/meeting.svg meeting.svg
  $ scc shape ell.off --svg ell.svg > /dev/null
  [3]
  $ cmp ../../specs/pictures/ell.svg ell.svg

From the camera of a page, in its frame, with or without perspective. A link and what follows # in it are the same:

  $ camera='camera=%7B%22at%22%3A%5B%22-105%2F256%22%2C%22241%2F512%22%2C%2269%2F256%22%5D%2C%22distance%22%3A12.764%2C%22turn%22%3A0.5%2C%22height%22%3A0.42%7D'
  $ draw() { scc view ../../specs/models/hexokinase.sc --svg 1 -o seen.svg "$@" 2> /dev/null; sed -n 's/.*viewBox="\([^"]*\)".*/\1/p' seen.svg; }
  $ draw --camera "$camera&size=400x300" && cp seen.svg first.svg
  0 0 400 358
  $ draw --camera "file:///hexokinase.html#run=0&$camera&size=400x300" && cmp first.svg seen.svg
  0 0 400 358
  $ draw --camera "$camera&size=400x300" --width 800
  0 0 800 658
  $ draw --camera "$camera"
  0 0 800 658

An eye among the bodies sees only what is before it:

  $ near='camera={"at":["0","0","0"],"distance":2.5,"turn":0,"height":0.3}'
  $ draw --camera "$near" && grep -c '<path' seen.svg
  0 0 800 658
  33
  $ draw --camera 'camera={"at":["0","0","40"],"distance":1,"turn":3.14159,"height":0}' && grep -c '<path' seen.svg
  0 0 800 658
  1
  $ draw --camera 'camera={"at":["0","0","40"],"distance":1,"turn":0,"height":0}' && grep -c '<path' seen.svg
  0 0 800 658
  27

Bodies may be farther from the eye than floats go:

  $ for x in 1e200 1e400 -1e999; do rm seen.svg; draw --camera "camera={\"at\":[\"$x\",\"0\",\"0\"],\"distance\":9,\"turn\":0,\"height\":1}"; done
  0 0 800 658
  0 0 800 658
  0 0 800 658

  $ scc view ../../specs/models/hexokinase.sc --svg 1 --camera 'run=0'
  scc: option '--camera': this is no link with a camera: it has no camera: copy
       the link of a page of scc view, or what follows # in it
  Usage: scc view [OPTION]… MODEL
  Try 'scc view --help' or 'scc --help' for more information.
  [64]
  $ scc view ../../specs/models/hexokinase.sc --svg 1 --camera 'camera={"at":["0","0","0"],"distance":-1,"turn":0,"height":0}'
  scc: option '--camera': this is no link with a camera: its camera is not one
       of a page of scc view
  Usage: scc view [OPTION]… MODEL
  Try 'scc view --help' or 'scc --help' for more information.
  [64]
  $ scc view ../../specs/models/hexokinase.sc --svg 1 --camera "$camera&size=0x300"
  scc: option '--camera': this is no link with a camera: its size is not of the
       form 800x600
  Usage: scc view [OPTION]… MODEL
  Try 'scc view --help' or 'scc --help' for more information.
  [64]
  $ scc view ../../specs/models/hexokinase.sc --svg 1 --camera "$camera" --from 0,1,0
  scc: --camera does not go with --from and --up: it says from where the picture is seen
  Usage: scc view [OPTION]… MODEL
  Try 'scc view --help' or 'scc --help' for more information.
  [64]
  $ scc view ../../specs/models/hexokinase.sc --camera "$camera"
  scc: --names, --without, --camera, --from, --up and --width tell how --svg draws
  Usage: scc view [OPTION]… MODEL
  Try 'scc view --help' or 'scc --help' for more information.
  [64]
