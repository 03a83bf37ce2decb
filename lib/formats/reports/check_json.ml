open Scc_base
open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_explain
open Scc_verify
open Scc_json
open Scc_loading
open Scc_runs
open Json_format

type t = {
  loaded : Loaded.t;
  verdicts : Verdict.outcome list;
  where : Scc_regions.Where.t list;
  report : Check.report;
  diagnostics : Diag.t list;
  exit : int;
  extra : (string * Json.t) list;
  full : bool;
  cure : Verdict.outcome -> string option;
}

let kind : Verdict.t -> string = function
  | Holds { bounds = []; _ } -> "holds"
  | Holds _ -> "holds-up-to-bound"
  | Violated _ -> "violated"
  | Measured _ -> "measured"
  | Undecided _ -> "undecided"

(* A value of a bound, as JSON. *)
let limit : Verdict.limit -> string * Json.t = function
  | Depth n -> ("depth", `Int n)
  | Time t -> ("time", Json.rat t)
  | Instant n -> ("instant", `Int n)
  | States n -> ("states", `Int n)
  | Bits n -> ("bits", `Int n)
  | Seconds s -> ("seconds", `String (Printf.sprintf "%g" s))
  | Memory words -> ("memory", `Int (Memory.bytes_of_words words))
  | Interrupted -> ("interrupted", `Null)
  | Omission p -> ("hash-compaction", `String (Verdict.at_most p))

let limits =
  [ "depth"; "time"; "instant"; "states"; "bits"; "seconds"; "memory"; "interrupted"; "hash-compaction" ]

let origin : Verdict.origin -> string = function
  | By_default -> "default"
  | By_user -> "user"
  | By_property -> "property"
  | By_system -> "system"

let truncation_format =
  let value =
    union
      [
        case (integer ()) (function `Int n -> Some n | _ -> None) ignore;
        case text (function `String s -> Some s | _ -> None) ignore;
        case null (fun _ -> Some ()) ignore;
      ]
  in
  fields
    [
      field "limit" (word Fun.id limits) (fun (t : Verdict.truncation) -> fst (limit t.limit));
      field "value" value (fun (t : Verdict.truncation) -> snd (limit t.limit));
      field "origin" (word origin [ By_default; By_user; By_property; By_system ]) (fun (t : Verdict.truncation) ->
          t.origin);
    ]
  |> about
    "A bound that was met, and whose it is; \"system\": that of the process, as by ulimit -v. Memory is in bytes."
  |> named ~file:"check" "truncation"

let truncation = write truncation_format

let finish (w : Witness.t) =
  match w.finish with
  | At_state -> "state"
  | During _ -> "instant"
  | Rests _ -> "rests"
  | Stops -> "stops"
  | Repeats _ -> "repeats"
  | Passes _ -> "passes"
  | Goes_on _ -> "goes_on"

let moved (m : Model.t) (by : Witness.moved) =
  match by with
  | Together by -> [ ("moved", Json.vec by) ]
  | Apart all ->
    let one (leaf, by) = `Assoc [ ("leaf", Json.text m.leaves.(leaf).name); ("by", Json.vec by) ] in
    [ ("moved", `Null); ("moved_apart", `List (List.map one all)) ]

let cycle m (w : Witness.t) =
  match w.finish with
  | Repeats { cycle; moved = by; _ } -> (`Int cycle, moved m by)
  | Goes_on { cycle } -> (`Int cycle, [ ("moved", `Null) ])
  | At_state | During _ | Rests _ | Stops | Passes _ -> (`Null, [ ("moved", `Null) ])

let step m (s : Witness.step) =
  `Assoc
    [
      ("choice", `Int s.choice);
      ("label", State_json.label m s.transition.label);
      ("time", Json.rat s.time);
    ]

(* An irrational instant is told by an interval with rational ends around it. *)
let instant w =
  let width = Rat.make Z.one (Z.pow (Z.of_int 10) 12) in
  let low, high = Algebraic.enclose (Witness.instant w) ~width in
  `Assoc
    [
      ("low", Json.rat low);
      ("high", Json.rat high);
      ("text", `String (Algebraic.to_string (Witness.instant w)));
    ]

let rec argument (a : Witness.argument) =
  `Assoc
    [
      ("where", Json.option Json.text a.where);
      ("time", Json.option Json.rat a.time);
      ("claim", Json.text a.claim);
      ("holds", `Bool a.holds);
      ("because", `List (List.map Json.text a.because));
      ("parts", `List (List.map argument a.parts));
    ]

(* The first and the last steps, and how many are left out in between. *)
let most_steps = 100

let shortened steps =
  let more = List.length steps - (2 * most_steps) in
  if more <= 0 then (steps, [])
  else
    let kept = List.filteri (fun i _ -> i < most_steps || i >= most_steps + more) steps in
    (kept, [ ("omitted", `Assoc [ ("after", `Int most_steps); ("count", `Int more) ]) ])

let values list = `Assoc (List.map (fun (name, v) -> (name, Json.rat v)) list)

let witness ?(full = true) given (w : Witness.t) =
  let c = Witness.semantics given w in
  let m = Semantics.model c in
  let cycle, moved = cycle m w in
  let steps, omitted = if full then (w.steps, []) else shortened w.steps in
  `Assoc
    ([
      ("initial", State_json.state m w.initial);
      ("steps", `List (List.map (step m) steps));
    ]
      @ omitted @ [
        ("finish", `String (finish w));
        ("cycle", cycle);
      ]
      @ moved @ [
        ("instant", instant w);
        ("offset", Json.option Json.rat (Witness.offset w));
        ("state", State_json.state m (Witness.there c w));
        ("facts", `List (List.map Json.text w.facts));
        ("argument", Json.option argument w.argument);
      ]
      @ match w.fixed with None | Some { values = []; _ } -> [] | Some f -> [ ("values", values f.values) ])

(* The way to where an exploration ended may be as long as the exploration, and decides nothing. *)
let reason ~full c (r : Verdict.reason) =
  let kind, bound, run =
    match r with
    | Truncated t -> ("truncated", truncation t, `Null)
    | Unevaluated t -> ("unevaluated", truncation t, `Null)
    | Undefined _ -> ("undefined", `Null, `Null)
    | Fault _ -> ("fault", `Null, `Null)
    | Unexplored { nearest; _ } -> ("unexplored", `Null, witness ~full c nearest)
  in
  `Assoc
    [
      ("kind", `String kind);
      ("text", Json.text (Verdict.reason_to_string r));
      ("bound", bound);
      ("witness", run);
    ]

let halt : Witness.halt -> string = function
  | Dead_end -> "dead-end"
  | One_instant -> "one-instant"

let rest r =
  let by, halt = match (r : Verdict.rest) with By h -> ("deciding", halt h) | Among h -> ("some", halt h) in
  `Assoc [ ("runs", `String by); ("end", `String halt) ]

let slowing (s : Slowing.t) =
  let stretch (x : Slowing.stretch) = `Assoc [ ("instants", `Int x.instants); ("took", Json.rat x.took) ] in
  `Assoc [ ("stretches", `List (List.map stretch s.stretches)); ("until", Json.rat s.until) ]

let convergence : Verdict.convergence -> string * Json.t = function
  | Named s -> ("slowing", slowing s)
  | Proved q -> ("converges", `Assoc [ ("factor", Json.rat q.factor); ("until", Json.rat q.until) ])

let over ({ instants; ranges; example; _ } : Verdict.over) =
  let bound (b : Ranges.bound) = `Assoc [ ("value", Json.rat b.value); ("included", `Bool b.included) ] in
  let range (r : Ranges.range) =
    `Assoc [ ("parameter", Json.text r.name); ("low", bound r.low); ("high", bound r.high) ]
  in
  ( "over",
    `Assoc
      ([
        ("instants", `Bool instants);
        ("ranges", `List (List.map range (Array.to_list ranges)));
      ]
        @ match example with [] -> [] | _ :: _ -> [ ("example", values example) ]) )

(* An ordinary model leaves nothing open. *)
let spoken_of (o : Verdict.over) = o.instants || Array.length o.ranges > 0

(* A number, or bounds of it that are proved. *)
let measured (side, (m : Scc_ctl.Eval.measured)) =
  let end_ f a = Json.option Json.rat (f a) in
  `Assoc
    [
      ("over", `String (match (side : Scc_property.Property.side) with Least -> "least" | Greatest -> "greatest"));
      ("low", end_ Scc_chance.Answer.lower m.least);
      ("high", end_ Scc_chance.Answer.upper m.most);
    ]

let lost_members = function [] -> [] | faults -> [ ("lost", `List (List.map Json.text faults)) ]
let left_out name t = List.map (fun t -> (name, truncation t)) (Option.to_list t)

let property ?(full = false) ?(cure = fun _ -> None) ?where c (o : Verdict.outcome) =
  let { Verdict.check; verdict = v; scale; rests; converges; lost; left_out = run_left_out } = o in
  let bounds, reasons, run =
    match v with
    | Holds { bounds; witness } -> (bounds, [], witness)
    | Violated { witness } -> ([], [], witness)
    | Measured { reasons; witness; _ } -> ([], reasons, witness)
    | Undecided reasons -> ([], reasons, None)
  in
  `Assoc
    ([
      ("name", Json.text check.name);
      ("formula", Json.text check.text);
      ("verdict", `String (kind v));
      ("text", Json.text (Verdict.outcome_to_string o));
      ("bounds", `List (List.map truncation bounds));
      ("reasons", `List (List.map (reason ~full c) reasons));
      ("witness", Json.option (witness c) run);
    ]
      @ (match v with
          | Measured { values; _ } -> [ ("values", `List (List.map measured values)) ]
          | Holds _ | Violated _ | Undecided _ -> [])
      @ (match rests with [] -> [] | _ :: _ -> [ ("rests_on", `List (List.map rest rests)) ])
      @ List.map convergence (Option.to_list converges)
      @ List.map (fun s -> ("split_step", Json.rat s)) (Option.to_list scale.split_step)
      @ List.map over (List.filter spoken_of (Option.to_list scale.over))
      @ lost_members lost
      @ left_out "run_left_out" run_left_out
      @ List.map (fun text -> ("likely_cure", Json.text text)) (Option.to_list (cure o))
      @ (if Verdict.by_invariant o then [ ("by_invariant", `Bool true) ] else [])
      @ List.map (fun w -> ("where", Where_json.where w)) (Option.to_list where))

let dead_ends list = `List (List.map (fun (d : Diag.t) -> Json.text d.message) list)

let cause (m : Model.t) c =
  let leaf i = Json.text m.leaves.(i).name in
  `Assoc
    [
      ("kind", `String (Growth.kind c));
      ("bodies", `List (List.map leaf (Growth.leaves c)));
      ("text", Json.text (Growth.to_string m c));
      ("cure", Json.text (Growth.cure m c));
    ]

let explored model (s : Check.stats) =
  `Assoc
    ([
      ("states", `Int s.states);
      ("transitions", `Int s.transitions);
      ("depth", `Int s.depth);
      ("time", Json.option Json.rat s.model_time);
      ("complete", `Bool s.complete);
      ("decided_early", `Bool s.decided_early);
      ("stopped_by", `List (List.map truncation s.stopped_by));
      ("faults", `List (List.map (fun (f : Diag.t) -> Json.text f.message) s.faults));
      ("dead_ends", dead_ends s.dead_ends);
    ]
      @ (match s.causes with [] -> [] | causes -> [ ("likely_causes", `List (List.map (cause model) causes)) ])
      @ left_out "causes_left_out" s.left_out)

let slice model (s : Check.slice) =
  `Assoc
    [
      ("properties", `List (List.map Json.text s.properties));
      ("left_out", `List (List.map Json.text s.left_out));
      ("explored", explored model s.explored);
    ]

let properties r =
  let one where o = property ~full:r.full ~cure:r.cure ?where r.loaded.semantics o in
  match r.where with
  | [] -> List.map (one None) r.verdicts
  | where -> List.map2 (fun w o -> one (Some w) o) where r.verdicts

let invariants model (report : Check.report) =
  match report.invariants with
  | [] -> []
  | all -> [ ("invariants", `List (List.map (Invariant_json.found model) all)) ]

let document ~source r =
  let model = r.loaded.model in
  `Assoc
    ([
      ("format", `String "scc-check");
      ("version", `Int 1);
      ("semantics", `String Scc_calculus.Parameters.version);
    ]
      @ Origin_json.members r.loaded.origin
      @ [ ("exit", `Int r.exit) ]
      @ (match Model.resolution model with
          | Some resolution -> [ ("resolution", Json.rat resolution) ]
          | None -> [])
      @ [
        ("properties", `List (properties r));
        ("explored", explored model r.report.stats);
        ("slices", `List (List.map (slice model) r.report.slices));
        ("zeno", Json.option (witness r.loaded.semantics) r.report.zeno);
      ]
      @ lost_members r.report.lost
      @ left_out "run_left_out" r.report.left_out
      @ [
        ("diagnostics", `List (List.map (Diag_json.diagnostic ~source) r.diagnostics));
      ]
      @ invariants model r.report
      @ r.extra)
