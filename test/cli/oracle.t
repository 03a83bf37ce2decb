The service answers a line by a line:

  $ cat > define.json <<'END'
  > {"jsonrpc":"2.0","id":1,"method":"shape.define","params":{"vertices":[[0,0,0],[1,0,0],[0,1,0],[0,0,1]],"faces":[[0,2,1],[0,1,3],[1,2,3],[0,3,2]]}}
  > {"jsonrpc":"2.0","id":2,"method":"first_time_of_contact","params":{"a":"s1","b":"s1","offset":[4,0,0],"velocity":[-2,0,0]}}
  > END
  $ scc oracle < define.json
  {"jsonrpc":"2.0","id":1,"result":{"shape":"s1","vertices":4,"edges":6,"faces":4,"volume":"1/6","centroid":["1/4","1/4","1/4"],"warnings":[{"code":"SC0312","message":"the centroid (1/4, 1/4, 1/4) is not the origin of body space (positions and motion are of the centroid)"}]}}
  {"jsonrpc":"2.0","id":2,"result":{"outcome":"at","time":{"exact":"3/2","float":1.5}}}

A batch is one line; a notification has no answer; the last line may lack its end, and lines may end like those of
other systems:

  $ printf '[{"jsonrpc":"2.0","id":"a","method":"x"},{"jsonrpc":"2.0","method":"x"}]\r\n\r\n{"jsonrpc":"2.0","id":9}' | scc oracle
  [{"jsonrpc":"2.0","id":"a","error":{"code":-32601,"message":"there is no method `x`","data":{"method":"x"}}}]
  {"jsonrpc":"2.0","id":9,"error":{"code":-32600,"message":"invalid request: `method` is a string","data":{}}}

What is no request is answered, too, and the service goes on. A line that is too long is skipped:

  $ (echo '{"a":'; head -c 3000000 /dev/zero | tr '\0' '['; echo; head -c 20000000 /dev/zero; echo; cat define.json) | scc oracle | cut -c1-110
  {"jsonrpc":"2.0","id":null,"error":{"code":-32700,"message":"this is not JSON: a value is expected here","data
  {"jsonrpc":"2.0","id":null,"error":{"code":-32000,"message":"the limit `depth` is 64","data":{"limit":"depth",
  {"jsonrpc":"2.0","id":null,"error":{"code":-32000,"message":"the limit `line_bytes` is 16777216","data":{"limi
  {"jsonrpc":"2.0","id":1,"result":{"shape":"s1","vertices":4,"edges":6,"faces":4,"volume":"1/6","centroid":["1/
  {"jsonrpc":"2.0","id":2,"result":{"outcome":"at","time":{"exact":"3/2","float":1.5}}}

The lines of a replay are those of scc trace:

  $ cat > load.py <<'END'
  > import json, subprocess, sys
  > path = sys.argv[1]
  > ask = lambda i, method, **params: json.dumps({"jsonrpc": "2.0", "id": i, "method": method, "params": params}) + "\n"
  > sent = ask(1, "model.load", text=open(path).read()) + ask(2, "replay", model="m1", choose={"random": 7}, steps=40)
  > out = subprocess.run(["scc", "oracle"], input=sent, capture_output=True, text=True).stdout.splitlines()
  > lines = json.loads(out[1])["result"]["lines"]
  > traced = subprocess.run(["scc", "trace", path, "--choose", "random:7", "--steps", "40"], capture_output=True, text=True)
  > print(path, lines == [json.loads(line) for line in traced.stdout.splitlines()])
  > END
  $ for m in hexokinase gas carousel gears latch; do python3 load.py ../../specs/models/$m.sc; done
  ../../specs/models/hexokinase.sc True
  ../../specs/models/gas.sc True
  ../../specs/models/carousel.sc True
  ../../specs/models/gears.sc True
  ../../specs/models/latch.sc True

A request that takes too long is given up, and the others are answered:

  $ cat > loop.sc <<'END'
  > shape C {
  >   vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)  e (-1,-1,1)  f (1,-1,1)  g (1,1,1)  h (-1,1,1)
  >   faces bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]  right [b,c,g,f]  front [a,b,f,e]  back [d,h,g,c]
  > }
  > for i in 1..300000 { process p[i] = C mass 1 at translate (3*i, 0, 0) velocity (0, i, 0) [nil] }
  > END
  $ cat > slow.py <<'END'
  > import json
  > params = {"text": open("loop.sc").read(), "limits": {"seconds": "1/5"}}
  > print(json.dumps({"jsonrpc": "2.0", "id": 1, "method": "model.load", "params": params}))
  > END
  $ (python3 slow.py; cat define.json) | scc oracle | cut -c1-110
  {"jsonrpc":"2.0","id":1,"error":{"code":-32004,"message":"the request took more time than it may","data":{"lim
  {"jsonrpc":"2.0","id":1,"result":{"shape":"s1","vertices":4,"edges":6,"faces":4,"volume":"1/6","centroid":["1/
  {"jsonrpc":"2.0","id":2,"result":{"outcome":"at","time":{"exact":"3/2","float":1.5}}}

The command line:

  $ scc oracle --line-bytes 0 2> /dev/null
  [64]
  $ scc oracle < /dev/null

A dead end is the end of a run, and no error.

  $ cat > dead_end.py <<'END'
  > import json
  > text = open('../../specs/models/topple.sc').read()
  > for method, params in [('model.load', {'text': text}), ('replay', {'model': 'm1', 'choose': 'first', 'states': 'ends'}),
  >                        ('replay', {'model': 'm1', 'choices': [0, 0, 0, 0, 0]})]:
  >     print(json.dumps({'jsonrpc': '2.0', 'id': method, 'method': method, 'params': params}))
  > END
  $ python3 dead_end.py | scc oracle | tail -n 2 | grep -o '"steps":[0-9]*,"time":"[^"]*","ending":"[^"]*"\|"error":.*' | cut -c1-200
  "steps":4,"time":"2/1","ending":"stuck"
  "steps":4,"time":"2/1","ending":"stuck"
  "error":{"code":-32006,"message":"the transitions cannot be computed: persistent contact: spike and p would interpenetrate at once, though they do not approach where they touch","data":{"at":4,"diagno
