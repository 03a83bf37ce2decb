open Scc_exact
open Scc_calculus
open Scc_json
open Scc_runs

type json = Yojson.Safe.t

let float x : json = `Intlit (Floats.text x)
let floats list : json = `List (List.map float list)
let text s = (Json.text s :> json)

(* {1 Kinds of agents} *)

type kinds = {
  figure : Figure.t;
  of_leaf : int array;  (** the kind of each leaf *)
  firsts : int array;  (** of each kind a leaf *)
  names : string array;
}

let kinds (m : Model.t) =
  let figure = Figure.make m in
  let forms = Figure.forms figure in
  let firsts = List.filter (fun i -> forms.(i) = i) (List.init (Array.length forms) Fun.id) in
  let number form = List.length (List.filter (fun i -> i < form) firsts) in
  let family leaf = Figure.family figure ~leaf in
  let name leaf =
    let before = List.length (List.filter (fun i -> i < leaf && family i = family leaf) firsts) in
    let name = m.leaves.(leaf).template in
    if before = 0 then name else Printf.sprintf "%s#%d" name (before + 1)
  in
  let numbers = Hashtbl.create 16 in
  List.iter (fun i -> Hashtbl.add numbers i (number i)) firsts;
  {
    figure;
    of_leaf = Array.map (Hashtbl.find numbers) forms;
    firsts = Array.of_list firsts;
    names = Array.of_list (List.map name firsts);
  }

let mesh_path ~path k i =
  let base = Filename.remove_extension path in
  Printf.sprintf "%s.%d-%s.obj" base i (Xml.name k.names.(i))

let kind_entry ~path k i leaf =
  let family = (Figure.families k.figure).(Figure.family k.figure ~leaf) in
  ( string_of_int i,
    `Assoc
      [
        ("name", text k.names.(i));
        ( "geometry",
          `Assoc
            [
              ("displayType", `String "OBJ");
              ("url", text (Filename.basename (mesh_path ~path k i)));
              ("color", `String (Figure.hex family));
            ] );
      ] )

let bond_entry i name =
  ( string_of_int i,
    `Assoc
      [
        ("name", text ("bond " ^ name));
        ( "geometry",
          `Assoc [ ("displayType", `String "FIBER"); ("url", `String ""); ("color", `String "#333333") ] );
      ] )

(* Numbers for what is met, in order. *)
let numbers () =
  let number, items = Figure.numbering () in
  ((fun item -> number item (fun _ -> item)), items)

(* {1 Frames} *)

let usual = 1000
let fiber = 1001

let agent k (l : State.leaf) =
  let at = Floats.point l.position and turned = Floats.euler l.turned in
  [ Float.of_int usual; Float.of_int l.leaf; Float.of_int k.of_leaf.(l.leaf) ]
  @ Array.to_list at @ Array.to_list turned @ [ 1.; 0. ]

let bond m k channel id ~thickness (p : State.process) (b : State.bond) =
  let at (f : State.finish) = Array.to_list (Floats.point (State.centroid m (State.leaf_of p f.at))) in
  let kind = Array.length k.firsts + channel b.name in
  let id = Array.length k.of_leaf + id (b.name, b.one.at, b.two.at) in
  [ Float.of_int fiber; Float.of_int id; Float.of_int kind; 0.; 0.; 0.; 0.; 0.; 0.; thickness; 6. ]
  @ at b.one @ at b.two

let frame m k channel id ~thickness i time (s : State.t) : json =
  let process (p : State.process) =
    let agents = List.map (agent k) (Array.to_list p.leaves) in
    let fibers = List.map (bond m k channel id ~thickness p) (Array.to_list p.bonds) in
    (agents, fibers)
  in
  let all = List.map process (Array.to_list s.processes) in
  let data = List.concat (List.concat_map fst all @ List.concat_map snd all) in
  `Assoc [ ("frameNumber", `Int i); ("time", float (Floats.of_rat time)); ("data", floats data) ]

(* {1 Plots} *)

let counts events kind ~over =
  let add (xs, ys, n) (time, label) =
    if not (String.equal (State_json.kind label) kind) then (xs, ys, n)
    else
      let x = Floats.of_rat time in
      (x :: x :: xs, Float.of_int (n + 1) :: Float.of_int n :: ys, n + 1)
  in
  let xs, ys, n = List.fold_left add ([ 0. ], [ 0. ], 0) events in
  (List.rev (over :: xs), List.rev (Float.of_int n :: ys))

let plot events ~over : json =
  let kinds = List.sort_uniq String.compare (List.map (fun (_, label) -> State_json.kind label) events) in
  let line kind : json =
    let xs, ys = counts events kind ~over in
    `Assoc
      [
        ("x", floats xs);
        ("y", floats ys);
        ("type", `String "scatter");
        ("mode", `String "lines");
        ("name", `String kind);
      ]
  in
  let axis title : json = `Assoc [ ("title", `String title) ] in
  `Assoc
    [
      ("data", `List (List.map line kinds));
      ( "layout",
        `Assoc
          [ ("title", `String "Events so far"); ("xaxis", axis "time"); ("yaxis", axis "number of events") ] );
    ]

(* {1 The document} *)

let space (v : Vec.t) : json =
  let p = Floats.point v in
  `Assoc [ ("x", float p.(0)); ("y", float p.(1)); ("z", float p.(2)) ]


(* All that the bodies need over the run, as far as its frames tell, and the channels of the bonds there are. *)
let survey (f : Film.t) times =
  let m = Film.model f in
  let join f (a : Vec.t) (b : Vec.t) = Vec.make (f a.x b.x) (f a.y b.y) (f a.z b.z) in
  let channel, channels = numbers () in
  let widen box time =
    let s = Film.at f time in
    let bond (b : State.bond) = ignore (channel b.name : int) in
    List.iter bond (State.bonds s);
    Option.merge (fun (l, h) (low, high) -> (join Rat.min l low, join Rat.max h high)) box (Figure.extent m s)
  in
  let box = List.fold_left widen None times in
  (Option.value box ~default:(Vec.zero, Vec.of_ints 1 1 1), channel, channels)

let unit name : json = `Assoc [ ("magnitude", `Int 1); ("name", `String name) ]

(* Frames are made one at a time, since there may be many. *)
let write (f : Film.t) ~path k ~times put =
  let m = Film.model f in
  let (low, high), channel, channels = survey f times in
  let size = Vec.sub high low and middle = Vec.middle low high in
  let greatest = Rat.max size.x (Rat.max size.y size.z) in
  let thickness = Floats.of_rat (Rat.div greatest (Rat.of_int 200)) in
  let id, _ = numbers () in
  let step = match times with a :: b :: _ -> Floats.of_rat (Rat.sub b a) | _ -> 0. in
  let away = Rat.add greatest Rat.one in
  let camera = Vec.add middle (Vec.make away (Rat.neg (Rat.mul (Rat.of_int 2) away)) away) in
  let agents = List.mapi (kind_entry ~path k) (Array.to_list k.firsts) in
  let fibers = List.mapi (fun i c -> bond_entry (Array.length k.firsts + i) c) (Array.to_list (channels ())) in
  let events = Film.events f in
  let over = Floats.of_rat (Film.duration f) in
  let json (j : json) = put (Yojson.Safe.to_string j) in
  put "{\"trajectoryInfo\":";
  json
    (`Assoc
       [
         ("version", `Int 3);
         ("timeUnits", unit "s");
         ("timeStepSize", float step);
         ("totalSteps", `Int (List.length times));
         ("spatialUnits", unit "m");
         ("size", space size);
         ( "cameraDefault",
           `Assoc
             [
               ("position", space camera);
               ("lookAtPosition", space middle);
               ("upVector", space (Vec.of_ints 0 0 1));
               ("fovDegrees", `Int 60);
             ] );
         ("typeMapping", `Assoc (agents @ fibers));
         ("trajectoryTitle", text f.title);
       ]);
  put
    (Printf.sprintf
       ",\"spatialData\":{\"version\":1,\"msgType\":1,\"bundleStart\":0,\"bundleSize\":%d,\"bundleData\":["
       (List.length times));
  List.iteri
    (fun i time ->
       if i > 0 then put ",";
       json (frame m k channel id ~thickness i time (Film.at f time)))
    times;
  put "]},\"plotData\":";
  json (`Assoc [ ("version", `Int 1); ("data", `List (if events = [] then [] else [ plot events ~over ])) ]);
  put "}\n"

let evenly (f : Film.t) ~every =
  let over = Film.duration f in
  let step = match every with Some s -> s | None -> Rat.div over (Rat.of_int 100) in
  if Rat.sign step = 0 then [ Rat.zero ]
  else List.init (1 + Z.to_int (Rat.floor (Rat.div over step))) (fun i -> Rat.mul step (Rat.of_int i))

let files f ~path ~every =
  let m = Film.model f in
  let k = kinds m in
  let times = evenly f ~every in
  let mesh i leaf = (mesh_path ~path k i, Obj.form m ~leaf) in
  let trajectory put = write f ~path k ~times put in
  Array.to_list (Array.mapi mesh k.firsts) @ [ (path, trajectory) ]
