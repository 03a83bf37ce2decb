What a mesh says beside its faces, or what is read otherwise, is a warning, in every command that reads meshes.

  $ cat > turned.wrl <<'END'
  > #VRML V2.0 utf8
  > Transform { rotation 0 0 1 1e-5 children Shape { geometry Box { size 2e6 2 2 } } }
  > END
  $ cat > lines.obj <<'END'
  > v 0 0 0
  > v 1 0 0
  > v 0 1 0
  > v 0 0 1
  > f 1 3 2
  > f 1 2 4
  > f 2 3 4
  > f 3 1 4
  > l 1 2
  > END
  $ for file in turned.wrl lines.obj
  > do
  >   for command in shape decompose
  >   do
  >     scc $command $file 2>&1 > /dev/null | grep warning
  >     scc $command --json $file | grep -A2 '"SC032[34]"'
  >   done
  > done
  turned.wrl:2:59: warning[SC0323]: what is read is up to 10.1 from what the file describes, here the most
        "code": "SC0323",
        "severity": "warning",
        "message": "what is read is up to 10.1 from what the file describes, here the most",
  turned.wrl:2:59: warning[SC0323]: what is read is up to 10.1 from what the file describes, here the most
        "code": "SC0323",
        "severity": "warning",
        "message": "what is read is up to 10.1 from what the file describes, here the most",
  lines.obj:9:1: warning[SC0324]: lines and points are left out
        "code": "SC0324",
        "severity": "warning",
        "message": "lines and points are left out",
  lines.obj:9:1: warning[SC0324]: lines and points are left out
        "code": "SC0324",
        "severity": "warning",
        "message": "lines and points are left out",

A template of a model, and a model.

  $ cat > m.sc <<'END'
  > shape T = mesh "lines.obj"
  > process p = T mass 1 velocity (1, 0, 0) [nil]
  > check one : P = ? [ eventually[<= 1] x(p) = 1 ]
  > END
  $ scc shape m.sc:T 2>&1 > /dev/null | grep warning
  lines.obj:9:1: warning[SC0324]: lines and points are left out
  $ for command in 'shape m.sc:T' 'check m.sc' 'estimate --runs 4 m.sc'
  > do
  >   scc $command --json | grep -c '"SC0324"'
  > done
  1
  1
  1
  $ (echo 'param q = 1'; cat m.sc) > q.sc
  $ for command in 'trace m.sc' "simulate --runs 1 --until 1 --every 1 --observe x(p) m.sc -o s.csv" 'successors m.sc' \
  >   'view m.sc -o v.html' 'explore m.sc -o e.json' 'sweep q.sc -D q=1,2' 'compare m.sc m.sc'
  > do
  >   echo "$command"; scc $command 2>&1 > /dev/null | grep 'SC0324'
  > done
  trace m.sc
  lines.obj:9:1: warning[SC0324]: lines and points are left out
  simulate --runs 1 --until 1 --every 1 --observe x(p) m.sc -o s.csv
  lines.obj:9:1: warning[SC0324]: lines and points are left out
  successors m.sc
  lines.obj:9:1: warning[SC0324]: lines and points are left out
  view m.sc -o v.html
  lines.obj:9:1: warning[SC0324]: lines and points are left out
  explore m.sc -o e.json
  lines.obj:9:1: warning[SC0324]: lines and points are left out
  sweep q.sc -D q=1,2
  lines.obj:9:1: warning[SC0324]: lines and points are left out
  compare m.sc m.sc
  lines.obj:9:1: warning[SC0324]: lines and points are left out
  lines.obj:9:1: warning[SC0324]: lines and points are left out

Points without faces, beside faces; alone they are a cloud.

  $ cat > points.wrl <<'END'
  > #VRML V2.0 utf8
  > Shape { geometry PointSet { coord Coordinate { point [ 0 0 0 ] } } }
  > Shape { geometry Box {} }
  > END
  $ cat > points.x3d <<'END'
  > <X3D><Scene><Shape><Box/></Shape>
  > <Shape><PointSet><Coordinate point="9 9 9"/></PointSet></Shape></Scene></X3D>
  > END
  $ sed '3d' points.wrl > cloud.wrl
  $ python3 - <<'END'
  > import base64, json, struct
  > data = struct.pack("<12f12H", 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3)
  > faces, points = {"attributes": {"POSITION": 0}, "indices": 1}, {"attributes": {"POSITION": 0}, "mode": 0}
  > def write(name, primitives):
  >     json.dump({"asset": {"version": "2.0"}, "nodes": [{"mesh": 0}], "meshes": [{"primitives": primitives}],
  >                "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
  >                              {"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"}],
  >                "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 24}],
  >                "buffers": [{"byteLength": 72, "uri": "data:;base64," + base64.b64encode(data).decode()}]},
  >               open(name, "w"))
  > write("points.gltf", [faces, points])
  > write("cloud.gltf", [points])
  > END
  $ for file in points.wrl points.x3d points.gltf cloud.wrl cloud.gltf
  > do
  >   echo $file; scc shape --weld $file 2>&1 | grep SC0324 || true
  > done
  points.wrl
  points.wrl:2:18: warning[SC0324]: points without faces, such as those of this PointSet, bound no solid
  points.x3d
  points.x3d:2:9: warning[SC0324]: points without faces, such as those of this PointSet, bound no solid
  points.gltf
  points.gltf:1:1: warning[SC0324]: meshes[0].primitives[1]: points without faces bound no solid
  cloud.wrl
  cloud.gltf
