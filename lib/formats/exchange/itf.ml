open Scc_exact
open Scc_calculus
open Scc_semantics

type t = {
  model : Model.t;
  put : string -> unit;
  mutable number : int;  (** of the next state *)
  mutable waiting : ((string * Json.t) list -> Json.t) option;
  (** the last state, which is still to be told how the run ended *)
  mutable closed : bool;
}

let variables =
  [ "action"; "time"; "position"; "velocity"; "behaviour"; "origin"; "process"; "bonds"; "clock"; "step" ]

(* Those of rigid models come last. *)
let variables (m : Model.t) =
  let variables = if Model.of_each m then variables @ [ "waited"; "phase" ] else variables in
  let variables = if Model.draws m then variables @ [ "drawn"; "waits" ] else variables in
  let variables = if m.lots then variables @ [ "split_clock"; "lots" ] else variables in
  match m.rigid with
  | None -> variables
  | Some _ ->
    variables @ [ "turned"; "spin"; "since"; "lasts" ] @ if Turn.is_free m then [ "angular_momentum" ] else []

let integer z = `Assoc [ ("#bigint", `String (Z.to_string z)) ]
let tuple items = `Assoc [ ("#tup", `List items) ]
let rational (q : Rat.t) = tuple [ integer (Q.num q); integer (Q.den q) ]
let quaternion (q : Quaternion.t) = tuple [ integer q.w; integer q.x; integer q.y; integer q.z ]
let vector (v : Vec.t) = tuple [ rational v.x; rational v.y; rational v.z ]
let map pairs = `Assoc [ ("#map", `List (List.map (fun (key, value) -> `List [ key; value ]) pairs)) ]
let set items = `Assoc [ ("#set", `List items) ]

let start model (origin : Scc_session.Origin.t) put =
  let meta =
    `Assoc
      [
        ("format", `String "ITF");
        ("description", `String "a run of the Shape Calculus, made by scc");
        ("model", Json.option Json.text origin.name);
        ("digest", `String origin.digest);
        ("semantics", `String Scc_calculus.Parameters.version);
        ("parameters", Origin_json.parameters origin);
        ("settings", Origin_json.settings origin);
      ]
  in
  put (Printf.sprintf "{\n\"#meta\": %s,\n" (Json.line meta));
  put
    (Printf.sprintf "\"vars\": %s,\n\"states\": [\n"
       (Json.line (`List (List.map (fun v -> `String v) (variables model)))));
  { model; put; number = 0; waiting = None; closed = false }

let by_leaf (s : State.t) =
  List.concat_map
    (fun (p : State.process) -> List.map (fun l -> (p, l)) (Array.to_list p.leaves))
    (Array.to_list s.processes)
  |> List.sort (fun (_, (l : State.leaf)) (_, (m : State.leaf)) -> Int.compare l.leaf m.leaf)

let bond m (b : State.bond) =
  let site (f : State.finish) = Json.text (Model.site_name m ~leaf:f.at f.site) in
  `Assoc [ ("name", Json.text b.name); ("one", site b.one); ("two", site b.two) ]

let step (s : State.t) =
  let record remaining phase = `Assoc [ ("remaining", rational remaining); ("phase", `String phase) ] in
  match s.step with
  | None -> record Rat.zero "none"
  | Some { remaining; phase = Moving } -> record remaining "moving"
  | Some { remaining; phase = Due } -> record remaining "due"
  | Some { remaining; phase = Steered } -> record remaining "steered"

let values (m : Model.t) ~action ~time (s : State.t) =
  let leaves = by_leaf s in
  let name (l : State.leaf) = Json.text m.leaves.(l.leaf).name in
  let each f = map (List.map (fun (p, l) -> (name l, f p l)) leaves) in
  let processes = Array.to_list s.processes in
  let first (p : State.process) = name p.leaves.(0) in
  let origin (l : State.leaf) =
    match l.behaviour.origin with
    | Some k -> Json.text m.definitions.(k).name
    | None -> `String ""
  in
  [
    ("action", Json.text action);
    ("time", rational time);
    ("position", each (fun _ (l : State.leaf) -> vector l.position));
    ("velocity", each (fun (p : State.process) _ -> vector p.velocity));
    ("behaviour", each (fun _ (l : State.leaf) -> Json.text (State_json.behaviour m ~leaf:l.leaf l.behaviour)));
    ("origin", each (fun _ l -> origin l));
    ("process", each (fun p _ -> first p));
    ( "bonds",
      set
        (List.concat_map
           (fun (p : State.process) -> List.map (bond m) (Array.to_list p.bonds))
           processes) );
    ( "clock",
      map
        (List.filter_map
           (fun (p : State.process) -> Option.map (fun c -> (first p, rational c)) p.clock)
           processes) );
    ("step", step s);
  ]
  @ (if Model.of_each m then
       [
         ("waited", each (fun _ (l : State.leaf) -> rational l.waited));
         ( "phase",
           each (fun (p : State.process) _ ->
               `String (Option.fold ~none:"none" ~some:State_json.phase p.phase)) );
       ]
     else [])
  @ (if Model.draws m then
       let drawn (p : State.process) =
         match p.draw with Some (Drawn v) -> Some (first p, vector v) | Some Waits | None -> None
       in
       let waits (p : State.process) =
         match p.draw with Some Waits -> Some (first p) | Some (Drawn _) | None -> None
       in
       [ ("drawn", map (List.filter_map drawn processes)); ("waits", set (List.filter_map waits processes)) ]
     else [])
  @ (if m.lots then
       let since (p : State.process) = Option.map (fun (l : State.lots) -> (first p, rational l.since)) p.lots in
       let pending (p : State.process) =
         let one (b, (lot : State.lot)) =
           let decided =
             match lot with Undecided -> "undecided" | Let_go _ -> "release" | Next _ -> "first"
           in
           tuple [ bond m b; `String decided ]
         in
         Option.fold ~none:[] ~some:(fun (l : State.lots) -> List.map one l.pending) p.lots
       in
       [
         ("split_clock", map (List.filter_map since processes));
         ("lots", set (List.concat_map pending processes));
       ]
     else [])
  @
  if Option.is_none m.rigid then []
  else
    [
      ("turned", each (fun _ (l : State.leaf) -> quaternion l.turned));
      ("spin", each (fun (p : State.process) _ -> vector p.spin));
      ("since", each (fun (p : State.process) _ -> rational p.since));
      ("lasts", each (fun (p : State.process) _ -> rational (Option.value p.lasts ~default:(Rat.of_int (-1)))));
    ]
    @
    if Turn.is_free m then
      [ ("angular_momentum", each (fun (p : State.process) _ -> vector p.kept)) ]
    else []

let flush t ~last meta =
  Option.iter
    (fun state -> t.put (Json.line (state meta) ^ if last then "\n" else ",\n"))
    t.waiting;
  t.waiting <- None

let add t ~action ~time s =
  flush t ~last:false [];
  let number = t.number in
  let values = values t.model ~action ~time s in
  t.number <- number + 1;
  t.waiting <-
    Some (fun meta -> `Assoc (("#meta", `Assoc (("index", `Int number) :: meta)) :: values))

let finish t meta =
  if not t.closed then begin
    flush t ~last:true meta;
    t.put "]\n}\n";
    t.closed <- true
  end

let event t (e : Replay.event) =
  match e with
  | Start s -> add t ~action:"init" ~time:Rat.zero s
  | Step { time; taken; state; _ } ->
    add t ~action:(Transition.label_to_string t.model taken.label) ~time (state ())
  | Instant { time; state; _ } -> add t ~action:"pass" ~time state
  | End { ending; _ } -> finish t (("ending", `String (Trace.ending ending)) :: Trace.why t.model ending)

let close t = finish t [ ("ending", `String "broken off") ]
