scc export writes a run for other programs. What they make of its files is held against traces by test/outside.

  $ models=../../specs/models

A table: the state at first and after each transition, exactly and in floats.

  $ scc export $models/hexokinase.sc -o run.csv --observe 'z(atp)' --observe 'distance2(atp, enzyme) < 10'
  $ tr -d '\r' < run.csv
  time,time (float),event,z(atp),z(atp) (float),"distance2(atp, enzyme) < 10","distance2(atp, enzyme) < 10 (float)"
  0,0,,0,0,false,0
  2,2,,0,0,true,1
  2,2,"bind(atp, enzyme.floorA.top, atp.bottom)",0,0,true,1
  2,2,"weak(atp, enzyme.floorA.top, atp.bottom)",0,0,true,1
  2,2,"bind(glc, enzyme.floorB.top, glucose.bottom)",0,0,true,1
  2,2,"weak(glc, enzyme.floorB.top, glucose.bottom)",0,0,true,1

At even steps, to standard output; a place that has no value is empty.

  $ scc export $models/hexokinase.sc --format csv --every 3/4 --observe 'z(atp)' --observe '1 / (time - 3/2)' | tr -d '\r'
  time,time (float),event,z(atp),z(atp) (float),1 / (time - 3/2),1 / (time - 3/2) (float)
  0,0,,0,0,-2/3,-0.6666666666666666
  3/4,0.75,,0,0,-4/3,-1.3333333333333333
  3/2,1.5,,0,0,,
  2,2,,0,0,2,2
  $ scc export $models/outlet.sc --format csv --observe 'gone(first)' --steps 6 | tr -d '\r'
  time,time (float),event,gone(first),gone(first) (float)
  0,0,,false,0
  2,2,,false,0
  2,2,"bind(site, enzyme.right, first.left)",false,0
  3,3,,false,0
  3,3,"strong({<site, {enzyme.right, first.left}> push(2)})",false,0
  3,3,"bounce(shuttle, roof)",false,0
  11/3,3.6666666666666665,,false,0

One state: at the end, or at a time.

  $ scc export $models/hexokinase.sc -o end.obj
  $ scc export $models/hexokinase.sc --at 1/2 --format obj > half.obj
  $ head -n 4 half.obj; grep -c '^o ' half.obj
  # hexokinase.sc at time 1/2
  o enzyme.floorA
  v -5 -1 -1 0.58 0.631 0.69
  v 0 -1 -1 0.58 0.631 0.69
  7
  $ cmp -s end.obj half.obj
  [1]

Animations begin with what the formats begin with:

  $ scc export $models/hexokinase.sc -o run.glb; head -c 4 run.glb; echo
  glTF
  $ scc export $models/hexokinase.sc -o run.x3d; head -n 5 run.x3d | cut -c 1-100
  <?xml version='1.0' encoding='UTF-8'?>
  <!DOCTYPE X3D PUBLIC 'ISO//Web3D//DTD X3D 3.3//EN' 'http://www.web3d.org/specifications/x3d-3.3.dtd'
  <X3D profile='Interchange' version='3.3'>
  <head>
  <meta name='title' content='hexokinase.sc'/>
  $ grep -c '<PositionInterpolator' run.x3d
  2
  $ grep '<PositionInterpolator' run.x3d
  <PositionInterpolator DEF='way_1' key='0 1' keyValue='-2.25 3 0, -2.25 1 0'/>
  <PositionInterpolator DEF='way_2' key='0 1' keyValue='2.25 3 0, 2.25 1 0'/>

Who is absorbed vanishes:

  $ scc export $models/outlet.sc -o outlet.x3d --steps 40; grep -E 'there_|<TimeSensor' outlet.x3d | head -n 4
  <TimeSensor DEF='clock' cycleInterval='87' loop='true'/>
  <PositionInterpolator DEF='there_1' key='0 0.1724137931034483 0.1724137931034483 1' keyValue='1 1 1, 1 1 1, 0 0 0, 0 0 0'/>
  <ROUTE fromNode='clock' fromField='fraction_changed' toNode='there_1' toField='set_fraction'/>
  <ROUTE fromNode='there_1' fromField='value_changed' toNode='leaf_1_first' toField='set_scale'/>

A series is a list and a folder; meshes are beside the trajectory that has them.

  $ scc export $models/hexokinase.sc -o series.pvd --every 1
  $ cat series.pvd; ls series
  <?xml version="1.0"?>
  <VTKFile type="Collection" version="1.0" byte_order="LittleEndian">
  <Collection>
  <DataSet timestep="0" file='series/step-000000.vtp'/>
  <DataSet timestep="1" file='series/step-000001.vtp'/>
  <DataSet timestep="2" file='series/step-000002.vtp'/>
  </Collection>
  </VTKFile>
  step-000000.vtp
  step-000001.vtp
  step-000002.vtp
  $ scc export $models/hexokinase.sc --format vtp -o other.vtp; ls -d other*
  other
  other.pvd
  $ scc export $models/hexokinase.sc -o run.simularium --every 1/2; ls run.*
  run.0-Enzyme.obj
  run.1-Cube.obj
  run.2-Cube.obj
  run.csv
  run.glb
  run.simularium
  run.x3d
  $ tr , '\n' < run.simularium | grep -E 'url|totalSteps|timeStepSize|"time"'
  "timeStepSize":0.5
  "totalSteps":5
  "url":"run.0-Enzyme.obj"
  "url":"run.1-Cube.obj"
  "url":"run.2-Cube.obj"
  "time":0
  "time":0.5
  "time":1
  "time":1.5
  "time":2
  "xaxis":{"title":"time"}

The same run gives the same bytes, whether it is chosen or followed:

  $ scc trace $models/tumble.sc --choose random:7 --steps 30 > tumble.jsonl
  $ for ending in glb x3d pvd simularium obj csv; do
  >   scc export $models/tumble.sc --choose random:7 --steps 30 -o chosen.$ending
  >   scc export $models/tumble.sc --schedule tumble.jsonl -o followed.$ending
  >   if [ $ending != pvd ]; then sed 's/followed/chosen/g' followed.$ending | cmp - chosen.$ending; fi
  > done
  $ diff -r chosen followed

A model with ranges is run from a start that is chosen; the run of a dead end is written up to there.

  $ scc export $models/meeting.sc --start simple --steps 3 --format csv | wc -l
  scc: for y = 0, z = 0
  4
  $ scc export $models/meeting.sc --steps 3 --format csv 2>&1 | head -n 1
  error[SC0903]: this needs the values of all parameters, and of `y`, `z` a range is known
  $ scc export $models/topple.sc -o topple.csv
  error[SC0602]: persistent contact: spike and p would interpenetrate at once, though they do not approach where they touch
  note: after step 4, at time 2
  [2]
  $ tr -d '\r' < topple.csv
  time,time (float),event
  0,0,
  1/2,0.5,
  1/2,0.5,"bounce(far, away)"
  2,2,
  2,2,"bounce(p, push)"

What cannot be:

  $ scc export $models/hexokinase.sc --at 50 -o late.obj
  command line: error[SC0208]: the run is over at time 2: there is no state at 50
  [64]
  $ scc export $models/hexokinase.sc --every 1e-40 -o many.simularium
  command line: error[SC0208]: the run lasts 2: it has more than 1000000 multiples of 1/10000000000000000000000000000000000000000
    hint: a longer step, or an earlier end by --time
  [64]
  $ sed 's/velocity (1\/3,0,0)/velocity (1e400,0,0)/' $models/drift.sc > far.sc
  $ for ending in glb x3d pvd simularium obj; do scc export far.sc --time 2 -o far.$ending 2>&1 | head -n 1; done
  far.sc:1:1: error[SC0106]: the run leads to a number that is too great for the floats of this format
  far.sc:1:1: error[SC0106]: the run leads to a number that is too great for the floats of this format
  far.sc:1:1: error[SC0106]: the run leads to a number that is too great for the floats of this format
  far.sc:1:1: error[SC0106]: the run leads to a number that is too great for the floats of this format
  far.sc:1:1: error[SC0106]: the run leads to a number that is too great for the floats of this format
  $ sed 's/1e400/1e50/' far.sc > single.sc; scc export single.sc --time 2 -o single.glb 2>&1 | head -n 1
  single.sc:1:1: error[SC0106]: the run leads to a number that is too great for the floats of this format
  $ ls -d far* single*
  far
  far.sc
  single.sc
  $ scc export far.sc --time 2 --format csv --observe 'x(p) > 0' --observe 'x(p)' |
  >   tr -d '\r' | cut -c 1-40
  time,time (float),event,x(p) > 0,x(p) > 
  0,0,,false,0,0,0
  2,2,,true,1,2000000000000000000000000000
  $ scc export $models/hexokinase.sc -o missing/run.glb
  missing/run.glb: error[SC0103]: cannot write: No such file or directory
  [74]
  $ scc export $models/hexokinase.sc -o missing/run.pvd
  missing/run: error[SC0103]: cannot make this folder: No such file or directory
  [74]
  $ scc export $models/hexokinase.sc --format csv --observe 'x(nobody)'
  <observable 1>:1:3: error[SC0201]: unknown process `nobody`
     |
   1 | x(nobody)
     |   ^^^^^^
  [3]
  $ scc export $models/hexokinase.sc --format csv --observe 'x(atp'
  <observable 1>:1:6: error[SC0110]: the text ends here: expected an operator, `,` or the closing bracket
     |
   1 | x(atp
     |      ^
  <observable 1>:1:2: note: this `(` is not closed
     |
   1 | x(atp
     |  ^
  [3]
  $ scc export $models/hexokinase.sc --format csv --observe 'possibly x(atp) > 1'
  <observable 1>:1:1: error[SC0205]: possibly x(atp) > 1 is a formula about runs: a number or a predicate of a state is needed here
     |
   1 | possibly x(atp) > 1
     | ^^^^^^^^^^^^^^^^^^^
    hint: `scc check` decides it
  [3]
  $ touch file; scc export $models/hexokinase.sc -o file/run.pvd
  file/run: error[SC0103]: cannot make this folder: Not a directory
  [74]
  $ touch flat; scc export $models/hexokinase.sc -o flat.pvd
  flat/step-000000.vtp: error[SC0103]: cannot write: Not a directory
  [74]
  $ scc export $models/hexokinase.sc -o run.glb > /dev/full; scc export $models/hexokinase.sc --format glb > /dev/full
  standard output: error[SC0103]: cannot write: No space left on device
  [74]
  $ wrong() { scc export $models/hexokinase.sc "$@" 2>&1 | head -n 1; }
  $ wrong
  scc: which format? --format says so, or the ending of -o
  $ wrong -o run.png
  scc: which format? --format says so, or the ending of -o
  $ wrong --format png -o run.png
  scc: option '--format': invalid value 'png', expected one of 'glb', 'x3d',
  $ wrong --format vtp
  scc: this format has several files: say by -o where they go
  $ wrong --format simularium -o -
  scc: this format has several files: say by -o where they go
  $ wrong -o run.glb --every 1
  scc: --every does not go with this format
  $ wrong -o run.glb --observe 'x(atp)'
  scc: --observe does not go with this format
  $ wrong -o run.csv --at 1
  scc: --at does not go with this format
  $ wrong -o run.csv --every 0
  scc: option '--every': `0' is not positive, and no step
  $ wrong -o run.obj --at=-1
  scc: option '--at': `-1' is negative, and no time
