open Scc_exact
open Scc_geometry
open Scc_calculus
open Scc_semantics
open Scc_json
open Scc_runs

type json = Yojson.Safe.t

(* {1 Numbers in JSON} *)

let float x : json = `Intlit (Floats.text x)
let floats array : json = `List (List.map float (Array.to_list array))
let json (j : Json.t) = (j :> json)
let text s = json (Json.text s)
let singles array = Array.map Floats.single array

(* {1 The buffer}

   Three views of it, one after the other: corners with their normals, indices, and what the animation takes. *)

type buffer = {
  views : Buffer.t array;
  mutable accessors : json list;  (** the newest first *)
  mutable count : int;
}

let vertices = 0
let indices = 1
let animation = 2

let buffer () = { views = Array.init 3 (fun _ -> Buffer.create 4096); accessors = []; count = 0 }

let add b ~view ~kind ~code ~count more put =
  let bytes = b.views.(view) in
  let accessor : json =
    `Assoc
      ([
        ("bufferView", `Int view);
        ("byteOffset", `Int (Buffer.length bytes));
        ("componentType", `Int code);
        ("count", `Int count);
        ("type", `String kind);
      ]
        @ more)
  in
  put bytes;
  b.accessors <- accessor :: b.accessors;
  b.count <- b.count + 1;
  b.count - 1

let limits width values =
  let column pick k =
    let rec go i best = if i >= Array.length values then best else go (i + width) (pick best values.(i)) in
    go (k + width) values.(k)
  in
  let row pick = floats (Array.init width (column pick)) in
  [ ("min", row Float.min); ("max", row Float.max) ]

let width = function "SCALAR" -> 1 | "VEC3" -> 3 | _ -> 4

let add_floats b ~view ~kind ?(limited = false) values =
  let values = singles values and width = width kind in
  let more = if limited then limits width values else [] in
  add b ~view ~kind ~code:5126 ~count:(Array.length values / width) more (fun bytes ->
      Array.iter (fun x -> Buffer.add_int32_le bytes (Int32.bits_of_float x)) values)

let add_indices b list =
  add b ~view:indices ~kind:"SCALAR" ~code:5125 ~count:(List.length list) [] (fun bytes ->
      List.iter (fun i -> Buffer.add_int32_le bytes (Int32.of_int i)) list)

let view_of b i =
  let before = ref 0 in
  Array.iteri (fun k v -> if k < i then before := !before + Buffer.length v) b.views;
  let target =
    if i = vertices then [ ("byteStride", `Int 12); ("target", `Int 34962) ]
    else if i = indices then [ ("target", `Int 34963) ]
    else []
  in
  `Assoc
    ([
      ("buffer", `Int 0); ("byteOffset", `Int !before); ("byteLength", `Int (Buffer.length b.views.(i)));
    ]
      @ target)

(* {1 Meshes} *)

(* Each face has corners of its own, since its normal is: faces are flat. *)
let mesh b families (solid, family) : json =
  let faces = Array.to_list solid.Solid.polyhedron.faces in
  let corners = List.concat_map (fun (_, around) -> Array.to_list around) faces in
  let positions = List.map (fun i -> Floats.point (Solid.vertex solid i)) corners in
  let normal i (_, around) =
    let n = solid.normals.(i) in
    Array.make (Array.length around) (Floats.unit [| n.Ivec.x; n.y; n.z |])
  in
  let normals = List.concat (List.mapi (fun i f -> Array.to_list (normal i f)) faces) in
  let fan first n = List.concat (List.init (n - 2) (fun k -> [ first; first + k + 1; first + k + 2 ])) in
  let _, triangles =
    List.fold_left
      (fun (first, all) (_, around) ->
         let n = Array.length around in
         (first + n, fan first n :: all))
      (0, []) faces
  in
  let position = add_floats b ~view:vertices ~kind:"VEC3" ~limited:true (Array.concat positions) in
  let normal = add_floats b ~view:vertices ~kind:"VEC3" (Array.concat normals) in
  let index = add_indices b (List.concat (List.rev triangles)) in
  `Assoc
    [
      ("name", text families.(family).Figure.name);
      ( "primitives",
        `List
          [
            `Assoc
              [
                ("attributes", `Assoc [ ("POSITION", `Int position); ("NORMAL", `Int normal) ]);
                ("indices", `Int index);
                ("material", `Int family);
              ];
          ] );
    ]

let material (f : Figure.family) : json =
  `Assoc
    ([
      ("name", text f.name);
      ( "pbrMetallicRoughness",
        `Assoc
          [
            ("baseColorFactor", floats (Array.append f.linear [| Figure.opacity f |]));
            ("metallicFactor", `Int 0);
            ("roughnessFactor", float 0.8);
          ] );
    ]
      @ if f.solid then [] else [ ("alphaMode", `String "BLEND") ])

(* {1 Nodes}

   Node 0 is the root, then come the leaves in order, and after them the parts of those that have several. *)

let rotation q =
  let u = Floats.unit [| q.Quaternion.x; q.y; q.z; q.w |] in
  singles u

(* What takes z to y, and where it takes a point to. *)
let upright = [| -0.70710678118654752; 0.; 0.; 0.70710678118654752 |]
let upright_point (v : Vec.t) = Floats.point (Vec.make v.x v.z (Rat.neg v.y))

let translation ~centre at = singles (Floats.point (Vec.sub at centre))

let part_nodes figure next leaf (l : Model.leaf) =
  let simple = Array.length l.parts = 1 && Vec.is_zero l.parts.(0).offset in
  if simple then ([ ("mesh", `Int (Figure.mesh figure ~leaf ~part:0)) ], [])
  else
    let node i (p : Model.part) : json =
      let mesh = ("mesh", `Int (Figure.mesh figure ~leaf ~part:i)) in
      let place =
        if Vec.is_zero p.offset then [] else [ ("translation", floats (singles (Floats.point p.offset))) ]
      in
      `Assoc ([ ("name", text p.name); mesh ] @ place)
    in
    let nodes = Array.to_list (Array.mapi node l.parts) in
    ([ ("children", `List (List.mapi (fun i _ -> `Int (next + i)) nodes)) ], nodes)

let leaf_node model figure ~centre next leaf (track : Track.t) =
  let l = model.Model.leaves.(leaf) and first = track.keys.(0) in
  let drawn, more = part_nodes figure next leaf l in
  let turned =
    if Quaternion.is_identity first.turned && not (Track.turns track) then []
    else [ ("rotation", floats (rotation first.turned)) ]
  in
  let gone = Option.fold ~none:[] ~some:(fun t -> [ ("gone", json (Json.rat t)) ]) track.gone in
  let node : json =
    `Assoc
      ([ ("name", text l.name); ("translation", floats (translation ~centre first.at)) ]
       @ turned @ drawn
       @ [ ("extras", `Assoc ([ ("template", text l.template); ("fixed", `Bool l.fixed) ] @ gone)) ])
  in
  (node, more)

(* {1 The animation} *)

(* Keys at times that differ as floats of 32 bits: of those that do not, the last. *)
let apart keys =
  let time (k : Track.key) = Floats.single (Floats.of_rat k.time) in
  let add kept k =
    match kept with
    | (t, _) :: older when time k <= t -> (t, k) :: older
    | _ -> (time k, k) :: kept
  in
  List.rev (Array.fold_left add [] keys)

(* A rotation is told by two opposite quaternions: from key to key the nearer one. *)
let nearer rotations =
  let dot a b = (a.(0) *. b.(0)) +. (a.(1) *. b.(1)) +. (a.(2) *. b.(2)) +. (a.(3) *. b.(3)) in
  let add done_ r =
    match done_ with
    | last :: _ when dot last r < 0. -> Array.map (fun x -> -.x +. 0.) r :: done_
    | _ -> r :: done_
  in
  List.rev (List.fold_left add [] rotations)

type channels = { mutable samplers : json list; mutable channels : json list; mutable number : int }

let channel c ~node ~path ~input ~output ~step =
  let how = if step then [ ("interpolation", `String "STEP") ] else [] in
  c.samplers <- `Assoc ([ ("input", `Int input); ("output", `Int output) ] @ how) :: c.samplers;
  c.channels <-
    `Assoc
      [ ("sampler", `Int c.number); ("target", `Assoc [ ("node", `Int node); ("path", `String path) ]) ]
    :: c.channels;
  c.number <- c.number + 1

let times b list = add_floats b ~view:animation ~kind:"SCALAR" ~limited:true (Array.of_list list)

let motion b c ~centre ~node (track : Track.t) =
  match apart track.keys with
  | [] | [ _ ] -> ()
  | keys ->
    let input = times b (List.map fst keys) in
    let put path kind values =
      let output = add_floats b ~view:animation ~kind (Array.concat values) in
      channel c ~node ~path ~input ~output ~step:false
    in
    put "translation" "VEC3" (List.map (fun (_, (k : Track.key)) -> translation ~centre k.at) keys);
    if Track.turns track then
      put "rotation" "VEC4" (nearer (List.map (fun (_, (k : Track.key)) -> rotation k.turned) keys))

(* Who is gone has no extent any more, which players take for not being there. *)
let vanish b c ~node (track : Track.t) =
  let there = [| 1.; 1.; 1. |] and gone = [| 0.; 0.; 0. |] in
  match Option.map (fun t -> Floats.single (Floats.of_rat t)) track.gone with
  | None -> ()
  | Some t ->
    let keys = if t > 0. then [ (0., there); (t, gone) ] else [ (0., gone) ] in
    let input = times b (List.map fst keys) in
    let output = add_floats b ~view:animation ~kind:"VEC3" (Array.concat (List.map snd keys)) in
    channel c ~node ~path:"scale" ~input ~output ~step:true

let event m (time, label) : json =
  `Assoc
    [
      ("time", json (Json.rat time));
      ("kind", `String (State_json.kind label));
      ("text", text (Transition.label_to_string m label));
    ]

(* The root stays where it is for the whole run, which is as long as the animation then. *)
let animations b (f : Film.t) ~centre tracks : (string * json) list =
  let over = Floats.single (Floats.of_rat (Film.duration f)) in
  if over <= 0. then []
  else
    let c = { samplers = []; channels = []; number = 0 } in
    let input = times b [ 0.; over ] in
    let still = upright_point centre in
    let output = add_floats b ~view:animation ~kind:"VEC3" (Array.append still still) in
    channel c ~node:0 ~path:"translation" ~input ~output ~step:true;
    Array.iteri
      (fun i track ->
         motion b c ~centre ~node:(i + 1) track;
         vanish b c ~node:(i + 1) track)
      tracks;
    [
      ( "animations",
        `List
          [
            `Assoc
              [
                ("name", `String "run");
                ("samplers", `List (List.rev c.samplers));
                ("channels", `List (List.rev c.channels));
              ];
          ] );
    ]

(* {1 The document} *)

let lossy =
  "Numbers are rounded to 32 bits. At its keys the animation is the run, up to that; between keys bodies that \
   turn are near it only: no step turns by more than a tenth of a radian. The exact run is told by scc trace."

let document b (f : Film.t) : json =
  let m = Film.model f and figure = Figure.make (Film.model f) in
  let tracks = Film.tracks f in
  let centre = Figure.centre m (Film.initial f) in
  let families = Figure.families figure in
  let meshes = List.map (mesh b families) (Array.to_list (Figure.meshes figure)) in
  let add (nodes, parts, next) (leaf, track) =
    let node, more = leaf_node m figure ~centre next leaf track in
    (node :: nodes, List.rev_append more parts, next + List.length more)
  in
  let leaves = Array.to_list (Array.mapi (fun i t -> (i, t)) tracks) in
  let nodes, parts, _ = List.fold_left add ([], [], 1 + Array.length tracks) leaves in
  let turned = ("rotation", floats (singles upright)) in
  let root : json =
    `Assoc
      [
        ("name", text f.title);
        turned;
        ("translation", floats (singles (upright_point centre)));
        ("children", `List (List.map (fun (i, _) -> `Int (i + 1)) leaves));
      ]
  in
  let animations = animations b f ~centre tracks in
  let used = if animations = [] then [ vertices; indices ] else [ vertices; indices; animation ] in
  let bytes = Array.fold_left (fun n v -> n + Buffer.length v) 0 b.views in
  let about =
    List.map (fun (name, j) -> (name, json j)) (Film.about f)
    @ [
      ("duration", json (Json.rat (Film.duration f)));
      ("events", `List (List.map (event m) (Film.events f)));
      ("lossy", `String lossy);
    ]
  in
  `Assoc
    ([
      ( "asset",
        `Assoc [ ("version", `String "2.0"); ("generator", `String "scc"); ("extras", `Assoc about) ] );
      ("scene", `Int 0);
      ("scenes", `List [ `Assoc [ ("nodes", `List [ `Int 0 ]) ] ]);
      ("nodes", `List ((root :: List.rev nodes) @ List.rev parts));
      ("meshes", `List meshes);
      ("materials", `List (List.map material (Array.to_list families)));
    ]
      @ animations
      @ [
        ("accessors", `List (List.rev b.accessors));
        ("bufferViews", `List (List.map (view_of b) used));
        ("buffers", `List [ `Assoc [ ("byteLength", `Int bytes) ] ]);
      ])

let word n =
  let b = Bytes.create 4 in
  Bytes.set_int32_le b 0 (Int32.of_int n);
  Bytes.to_string b

let file f put =
  let b = buffer () in
  let document = Yojson.Safe.to_string (document b f) in
  let padding = (4 - (String.length document land 3)) land 3 in
  let length = String.length document + padding in
  let bytes = Array.fold_left (fun n v -> n + Buffer.length v) 0 b.views in
  put ("glTF" ^ word 2 ^ word (12 + 8 + length + 8 + bytes));
  put (word length ^ "JSON");
  put document;
  put (String.make padding ' ');
  put (word bytes ^ "BIN\000");
  Array.iter (fun v -> put (Buffer.contents v)) b.views
