type json = Yojson.Basic.t

let json = Yojson.Basic.from_string

let cube =
  json
    {|{"vertices":[[-1,-1,-1],[1,-1,-1],[1,1,-1],[-1,1,-1],[-1,-1,1],[1,-1,1],[1,1,1],[-1,1,1]],
       "faces":[[0,3,2,1],[4,5,6,7],[0,1,5,4],[1,2,6,5],[2,3,7,6],[3,0,4,7]],
       "names":{"faces":["bottom","top","front","right","back","left"]}}|}

let tetrahedron =
  json {|{"vertices":[[0,0,0],["1",0,0],[0,"1/1",0],[0,0,1.0]],"faces":[[0,2,1],[0,1,3],[1,2,3],[0,3,2]]}|}

let model =
  {|model pair
param speed = 1
shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}
behaviour P on Cube = <k, {right}>. omega(k, {right}). P
behaviour Q on Cube = <~k, {left}>. omega(k, {left}). Q
process p = Cube mass 1 velocity (speed, 0, 0) [P]
process q = Cube mass 2 at translate (5, 0, 0) velocity (-1, 0, 0) [Q]
fixed wall = Cube at translate (12, 0, 0)
check meet : possibly bonds(k) = 1
|}

(* Two cubes, one of which comes from a place that is not known. *)
let ranged =
  {|param y in [-5, 5]
shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}
behaviour P on Cube = <k, {right}>. nil
behaviour Q on Cube = <~k, {left}>. nil
process p = Cube mass 1 velocity (1, 0, 0) [P]
process q = Cube mass 2 at translate (12, y, 0) [Q]
check meet : possibly bound(p, q)
|}

let request ~id name params : json =
  `Assoc [ ("jsonrpc", `String "2.0"); ("id", `Int id); ("method", `String name); ("params", params) ]

let setup =
  [
    request ~id:1 "shape.define" cube;
    request ~id:2 "shape.define" tetrahedron;
    request ~id:3 "model.load" (`Assoc [ ("text", `String model) ]);
  ]

let bodies =
  {|"first":{"mass":1,"centre":[0,0,0],"inertia":[[1,0,0],[0,1,0],[0,0,1]],"velocity":[1,0,0],
             "spin":[0,0,0]},
    "second":{"mass":"3/2","centre":[2,"1/3",0],"inertia":[[2,0,0],[0,1,0],[0,0,1]],
               "velocity":[0,0,0],"spin":[0,0,1]}|}

let valid =
  List.map
    (fun (name, params) -> (name, json params))
    [
      ("shape.define", {|{"vertices":[[0,0,0],[2,0,0],[0,2,0],[0,0,2]],"faces":[[0,2,1],[0,1,3],[1,2,3],[0,3,2]],
                          "linear":[[1,1,0],[0,1,0],[0,0,"1/3"]]}|});
      ("shape.check", {|{"vertices":[[0,0,0],[1,0,0],[0,1,0],[0,0,1]],"faces":[[0,2,1],[0,1,3],[1,2,3]]}|});
      ("shape.mass", {|{"shape":"s2","mass":"5/2","turned":[1,2,0,"1/2"],"at":[1,-2,0.5]}|});
      ("contact", {|{"a":"s1","b":"s1","offset":[2,"1/2",0],"velocity":[-1,0,0]}|});
      ("contact", {|{"a":"s1","b":"s2","offset":[1,0,0]}|});
      ("contact", {|{"a":"s1","b":"s2","offset":["1.001",0,0],"resolution":"1/100","turned_a":[1,0,0,0]}|});
      ("first_time_of_contact", {|{"a":"s1","b":"s2","offset":[4,"1/3",0],"velocity":[-2,0,"1/7"]}|});
      ("first_time_of_contact", {|{"a":"s2","b":"s1","offset":[4,1e1,0],"velocity":[0,-3.5,0]}|});
      ("first_time_of_contact", {|{"a":"s1","b":"s1","offset":["2.2",0,0],"velocity":[0,0,0],"spin_b":[0,0,1],
                                   "span":4,"resolution":"1/1024"}|});
      ("response", {|{"touching":[{"a":"s1","b":"s1","offset":[2,0,0]}],"first":{"mass":1,"velocity":[1,0,0]},
                      "second":{"mass":3,"velocity":[0,0,0]}}|});
      ( "response",
        {|{"touching":[{"a":"s1","b":"s1","offset":[2,"1/3",0]}],"resolution":"1/1000",|} ^ bodies ^ "}" );
      ("successors", {|{"model":"m1","path":[0]}|});
      ("successors", {|{"model":"m1","states":"all"}|});
      ("step", {|{"model":"m1","path":[],"choice":0}|});
      ("step", {|{"model":"m1","path":[0],"choice":"bind(k, p.right, q.left)"}|});
      ("replay", {|{"model":"m1","choices":[0,{"choice":0}],"offset":"1/2"}|});
      ("replay", {|{"model":"m1","choose":{"random":7},"steps":5,"states":"ends"}|});
      ("evaluate", {|{"model":"m1","path":[0,0],"formula":"bonds(k) = 1 and event bind(k)"}|});
      ("evaluate", {|{"model":"m1","path":[0],"formula":"x(q) / 3"}|});
      ("evaluate", {|{"model":"m1","formula":"possibly bonds(k) = 1 within 2",
                      "limits":{"seconds":5,"states":100}}|});
      ("values", {|{"model":"m1","path":[0,0],"formula":"distance2(p, q) / 2"}|});
      ("values", {|{"model":"m1","path":[0,0],"formula":"event bind(k) or x(p) > 1"}|});
      ("text.format", {|{"text":"process p=Cube[nil]// a\nmodel x","name":"x.sc"}|});
      ("text.describe", {|{"text":"process p = Cube [nil] check c : always x(p) = 0 or","offset":42}|});
      ("text.complete", {|{"text":"process p = Cube [nil] check c : always x(p) = 0 or","offset":42}|});
      ("text.fixes", {|{"text":"shape Cube = box(1,1,1) process p = Kube mass 1 [nil]"}|});
      ("model.check", Yojson.Basic.to_string (`Assoc [ ("text", `String ranged); ("where", `Bool true) ]));
      ("service.describe", "{}");
    ]
