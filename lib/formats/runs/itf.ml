open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_json

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

let start model (origin : Scc_loading.Origin.t) put =
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

(* {2 The values of a state} *)

let named (m : Model.t) (l : State.leaf) = Json.text m.leaves.(l.leaf).name

(* For each leaf, by its name. *)
let of_each m s f = map (List.map (fun (p, l) -> (named m l, f p l)) (State.by_leaf s))

(* For those processes that have one, by the name of their first leaf. *)
let of_some m (s : State.t) f =
  let entry (p : State.process) = Option.map (fun v -> (named m p.leaves.(0), v)) (f p) in
  map (List.filter_map entry (Array.to_list s.processes))

let of_all_models (m : Model.t) ~action ~time (s : State.t) =
  let each f = of_each m s f in
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
    ("process", each (fun (p : State.process) _ -> named m p.leaves.(0)));
    ("bonds", set (List.map (bond m) (State.bonds s)));
    ("clock", of_some m s (fun p -> Option.map rational p.clock));
    ("step", step s);
  ]

let of_own_steps m s =
  let phase (p : State.process) = Option.fold ~none:"none" ~some:State_json.phase p.phase in
  [
    ("waited", of_each m s (fun _ (l : State.leaf) -> rational l.waited));
    ("phase", of_each m s (fun p _ -> `String (phase p)));
  ]

let of_draws m (s : State.t) =
  let drawn (p : State.process) =
    let motion (g : Given.t) = vector g.velocity :: List.map vector (Option.to_list g.spin) in
    match p.draw with
    | Some (Drawn g) -> Some (match motion g with [ velocity ] -> velocity | both -> tuple both)
    | Some Waits | None -> None
  in
  let waits (p : State.process) =
    match p.draw with Some Waits -> Some (named m p.leaves.(0)) | Some (Drawn _) | None -> None
  in
  [ ("drawn", of_some m s drawn); ("waits", set (List.filter_map waits (Array.to_list s.processes))) ]

let of_lots m (s : State.t) =
  let decided (lot : State.lot) =
    match lot with Undecided -> "undecided" | Let_go _ -> "release" | Next _ -> "first"
  in
  let pending (p : State.process) =
    let one (b, lot) = tuple [ bond m b; `String (decided lot) ] in
    Option.fold ~none:[] ~some:(fun (l : State.lots) -> List.map one l.pending) p.lots
  in
  [
    ("split_clock", of_some m s (fun p -> Option.map (fun (l : State.lots) -> rational l.since) p.lots));
    ("lots", set (List.concat_map pending (Array.to_list s.processes)));
  ]

let of_turning m s =
  let each f = of_each m s f in
  [
    ("turned", each (fun _ (l : State.leaf) -> quaternion l.turned));
    ("spin", each (fun (p : State.process) _ -> vector p.spin));
    ("since", each (fun (p : State.process) _ -> rational p.since));
    ("lasts", each (fun (p : State.process) _ -> rational (Option.value p.lasts ~default:(Rat.of_int (-1)))));
  ]
  @ if Turn.is_free m then [ ("angular_momentum", each (fun (p : State.process) _ -> vector p.kept)) ] else []

let values (m : Model.t) ~action ~time (s : State.t) =
  let parts =
    [
      (true, fun () -> of_all_models m ~action ~time s);
      (Model.of_each m, fun () -> of_own_steps m s);
      (Model.draws m, fun () -> of_draws m s);
      (m.lots, fun () -> of_lots m s);
      (Option.is_some m.rigid, fun () -> of_turning m s);
    ]
  in
  List.concat_map (fun (has, part) -> if has then part () else []) parts

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
