Files that break their format, and what is told of each.

  $ scene() { printf '<X3D><Scene>%s</Scene></X3D>' "$1" > t.x3d; scc shape t.x3d 2>&1 | grep 'SC03\|accepted\|polyhedron'; }
  $ box='<Shape><Box/></Shape>'
  $ scene "$box"
  convex closed polyhedron: yes
  $ scene "$box stray"
  t.x3d:1:35: error[SC0320]: text stands between elements here, where X3D has none: values are attributes
  $ scene "$box<![CDATA[stray]]>"
  t.x3d:1:43: error[SC0320]: text stands between elements here, where X3D has none: values are attributes
  $ scene "<Script><![CDATA[ecmascript: 1 < 2]]></Script>$box"
  convex closed polyhedron: yes
  $ scene "$box</Scene><Scene>$box"
  t.x3d:1:43: error[SC0320]: the element Scene is there twice
  $ scene "<Group><Scene>$box</Scene></Group>"
  t.x3d:1:21: error[SC0320]: the element Scene does not stand here
  $ scene "<Shape><Box containerField='appearance'/><Sphere/></Shape>"
  t.x3d:1:21: error[SC0320]: a Box is no `appearance` of a Shape, and would not be seen
  $ scene "<Group DEF='G'>$box</Group><ROUTE fromNode='H' fromField='a' toNode='G' toField='children'/>"
  t.x3d:1:58: warning[SC0324]: no node has the name `H` of this route, which is left out
  convex closed polyhedron: yes
  $ scene "<Group DEF='G'>$box</Group><ROUTE fromNode='G' fromField='a' toNode='H' toField='children'/>"
  t.x3d:1:58: warning[SC0324]: no node has the name `H` of this route, which is left out
  convex closed polyhedron: yes
  $ scene "<ProtoDeclare name='P'><ProtoBody>$box</ProtoBody></ProtoDeclare><ProtoInstance name='P'><fieldValue name='q' value='1'/></ProtoInstance>"
  t.x3d:1:137: error[SC0321]: the prototype `P` has no field `q` that has a value
  $ scene "<ProtoDeclare name='P'><ProtoBody><Group><ProtoInstance name='P'/></Group></ProtoBody></ProtoDeclare><ProtoInstance name='P'/>"
  t.x3d:1:55: error[SC0320]: the prototype `P` is used inside of itself

  $ wrl() { printf '#VRML V2.0 utf8\n%s' "$1" > t.wrl; scc shape t.wrl 2>&1 | grep 'SC03\|polyhedron'; }
  $ wrl 'PROTO P [] { Group { children P {} } } P {}'
  t.wrl:2:31: error[SC0320]: the prototype `P` is used inside of itself
  $ wrl 'Transform { translation nan 0 0 children Shape { geometry Box {} } }'
  t.wrl:2:25: error[SC0320]: a coordinate must be a finite number, not `nan`
  $ wrl 'Transform { translation 0 -inf 0 children Shape { geometry Box {} } }'
  t.wrl:2:27: error[SC0320]: a coordinate must be a finite number, not `-inf`
  $ wrl 'DEF G Group { children Shape { geometry Box {} } } ROUTE H.a TO G.children'
  t.wrl:2:52: warning[SC0324]: no node has the name `H` of this route, which is left out
  convex closed polyhedron: yes
  $ wrl 'Shape { appearance Box {} geometry Sphere {} }'
  t.wrl:2:20: error[SC0320]: a Box is no `appearance` of a Shape, and would not be seen

PLY: values beyond the types of their properties.

  $ ply() { printf 'ply\nformat ascii 1.0\nelement vertex 4\nproperty %s x\nproperty int y\nproperty int z\nproperty uchar red\nelement face 4\nproperty list uchar uchar vertex_indices\nend_header\n0 0 0 %s\n%s 0 0 1\n0 1 0 1\n0 0 1 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n%s 2 0 3\n' "$@" > t.ply; scc shape t.ply 2>&1 | grep 'SC03\|polyhedron'; }
  $ ply uchar 255 255 3
  convex closed polyhedron: yes
    warning[SC0312]: the centroid (255/4, 1/4, 1/4) is not the origin of body space (positions and motion are of the centroid)
  $ ply uchar 255 300 3
  t.ply:12:1: error[SC0320]: `300` is beyond the type of its property, which goes from 0 to 255
  $ ply char 255 -128 3
  convex closed polyhedron: no
    error[SC0309]: the faces are oriented inward: clockwise seen from outside
  $ ply char 255 128 3
  t.ply:12:1: error[SC0320]: `128` is beyond the type of its property, which goes from -128 to 127
  $ ply int 255 1.5 3
  t.ply:12:1: error[SC0320]: expected an integer, found `1.5`
  $ ply uchar 300 1 3
  t.ply:11:7: warning[SC0324]: values that are not of the types of their properties, here the first, are left out
  convex closed polyhedron: yes
    warning[SC0312]: the centroid (1/4, 1/4, 1/4) is not the origin of body space (positions and motion are of the centroid)
  $ ply uchar 1 1 259
  t.ply:18:1: error[SC0320]: `259` is beyond the type of its property, which goes from 0 to 255

glTF: JSON alone, the bounds of data, and what is not shown.

  $ cat > write.py <<'END'
  > import base64, json, struct, sys
  > data = struct.pack("<12f12H", 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3)
  > node, more, old, new = sys.argv[1:]
  > text = json.dumps({"asset": {"version": "2.0"}, "nodes": [{"mesh": 0, **json.loads(node)}],
  >     "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
  >     "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", **json.loads(more)},
  >                   {"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"}],
  >     "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 24}],
  >     "buffers": [{"byteLength": 72, "uri": "data:;base64," + base64.b64encode(data).decode()}]}, indent=1)
  > open("t.gltf", "w").write(text.replace(old, new))
  > END
  $ gltf() { python3 write.py "${1:-{\}}" "${2:-{\}}" "${3:-no}" "${4:-no}"; scc shape t.gltf 2>&1 | grep 'SC03\|polyhedron'; }
  $ gltf
  convex closed polyhedron: yes
    warning[SC0312]: the centroid (1/4, 1/4, 1/4) is not the origin of body space (positions and motion are of the centroid)
  $ gltf '' '{"min": [0, 0, 0], "max": [1, 1, 1.0001]}'
  convex closed polyhedron: yes
    warning[SC0312]: the centroid (1/4, 1/4, 1/4) is not the origin of body space (positions and motion are of the centroid)
  $ gltf '' '{"min": [0, 0, 0], "max": [1, 1, 7]}'
  t.gltf:1:1: warning[SC0324]: accessors[0]: `max` is not that of the data, and is left out
  convex closed polyhedron: yes
    warning[SC0312]: the centroid (1/4, 1/4, 1/4) is not the origin of body space (positions and motion are of the centroid)
  $ gltf '' '{"min": [-1, 0, 0]}'
  t.gltf:1:1: warning[SC0324]: accessors[0]: `min` is not that of the data, and is left out
  convex closed polyhedron: yes
    warning[SC0312]: the centroid (1/4, 1/4, 1/4) is not the origin of body space (positions and motion are of the centroid)
  $ gltf '{"scale": [0, 0, 0]}'
  t.gltf:1:1: error[SC0320]: the scene shows no faces: nodes[0] is scaled to a point
  $ gltf '{"scale": [1, 0, 1]}'
  t.gltf:1:1: error[SC0320]: nodes[0]: a scale of 0 makes everything flat
  $ gltf '{"scale": [1, 1e0, 1]}'
  convex closed polyhedron: yes
    warning[SC0312]: the centroid (1/4, 1/4, 1/4) is not the origin of body space (positions and motion are of the centroid)
  $ gltf '{"extensions": {"KHR_node_visibility": {"visible": false}}}'
  t.gltf:1:1: error[SC0320]: the scene shows no faces: nodes[0] is hidden
  $ gltf '' '' '"asset"' '"lights": 1, "asset"'
  t.gltf:1:1: error[SC0320]: `lights` is no property of a glTF file that is known here
  $ gltf '' '' '"indices": 1' '"indices": 1, "mode": 9'
  t.gltf:1:1: error[SC0320]: meshes[0].primitives[0]: there is no mode 9: modes are 0 to 6
  $ gltf '' '' '"indices": 1' '"indices": 1, "mode": 3'
  t.gltf:1:1: error[SC0320]: meshes[0].primitives[0]: the mesh is made of lines (mode 3), and a solid is made of triangles
  $ gltf '' '' '"nodes"' '// nodes
  > "nodes"'
  t.gltf:1:1: error[SC0320]: this is not JSON: in line 5 of it, `// nodes` is outside of strings
  $ gltf '' '' '"nodes"' '/* */ "nodes"'
  t.gltf:1:1: error[SC0320]: this is not JSON: in line 5 of it, `/* */ "nod` is outside of strings
  $ gltf '' '' '"nodes"' 'nodes'
  t.gltf:1:1: error[SC0320]: this is not JSON: in line 5 of it, `nodes: [` is outside of strings
  $ gltf '' '' '"count": 4' '"count": Infinity'
  t.gltf:1:1: error[SC0320]: this is not JSON: in line 26 of it, `Infinity,` is outside of strings
  $ gltf '' '' '"name": "a // b"' '"name": "a"'
  convex closed polyhedron: yes
    warning[SC0312]: the centroid (1/4, 1/4, 1/4) is not the origin of body space (positions and motion are of the centroid)

3MF: triangles with equal corners, and transforms that make things flat.

  $ cat > pack.py <<'END'
  > import sys, zipfile
  > triangle, item = sys.argv[1:]
  > faces = ["0 2 1", "0 1 3", "0 3 2", "1 2 3"] + ([triangle] if triangle else [])
  > model = ('<?xml version="1.0"?>\n<model xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources>'
  >   '<object id="1"><mesh><vertices>'
  >   + "".join('<vertex x="%s" y="%s" z="%s"/>' % p for p in ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)))
  >   + "</vertices>\n<triangles>" + "".join('<triangle v1="%s" v2="%s" v3="%s"/>\n' % tuple(f.split()) for f in faces)
  >   + '</triangles></mesh></object></resources><build><item objectid="1" %s/></build></model>' % item)
  > with zipfile.ZipFile("t.3mf", "w") as z:
  >     z.writestr("_rels/.rels", '<Relationships><Relationship Target="/m.model" '
  >         'Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>')
  >     z.writestr("m.model", model)
  > END
  $ tmf() { python3 pack.py "$1" "$2"; scc shape t.3mf 2>&1 | grep 'SC03\|polyhedron'; }
  $ tmf '' ''
  convex closed polyhedron: yes
    warning[SC0312]: the centroid (1/4, 1/4, 1/4) is not the origin of body space (positions and motion are of the centroid)
  $ tmf '1 1 2' ''
  t.3mf:1:1: warning[SC0324]: `m.model`, line 7: a triangle has two equal corners, and is left out
  convex closed polyhedron: yes
    warning[SC0312]: the centroid (1/4, 1/4, 1/4) is not the origin of body space (positions and motion are of the centroid)
  $ tmf '' 'transform="1 0 0 0 0 0 0 0 1 0 0 0"'
  t.3mf:1:1: error[SC0320]: `m.model`, line 7: the transform makes everything flat

Files without anything.

  $ printf 'solid a\nendsolid a\n' > t.stl; scc shape t.stl 2>&1 | grep SC03
  t.stl:1:1: error[SC0320]: the file has no faces and no points

Values of SVG that are computed elsewhere.

  $ svg() { printf '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9"><rect %s height="4"/></svg>' "$1" > t.svg; scc inflate t.svg 2>&1 | grep 'SC03'; }
  $ svg 'width="4" fill="var(--c)"'
  t.svg:1:59: error[SC0341]: this is not read: the paint "var(--c)" (colours are names of CSS, #rrggbb, rgb(), hsl(), hwb(), lab(), lch(), oklab(), oklch(), and color() in srgb, srgb-linear and display-p3)
  $ svg 'width="4" fill="rgb(var(--c))"'
  t.svg:1:59: error[SC0341]: this is not read: the function var() in "var(--c)": write its value
  $ svg 'width="calc(4px)"'
  t.svg:1:59: error[SC0341]: this is not read: the function calc() in "calc(4px)": write its value
  $ svg 'width="4" opacity="var(--o)"'
  t.svg:1:59: error[SC0341]: this is not read: the function var() in "var(--o)": write its value
  $ svg 'width="four"'
  t.svg:1:59: error[SC0340]: a fault in the drawing: a number is missing at "four"
