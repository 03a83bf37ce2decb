open Scc_base
open Scc_exact
open Scc_calculus
open Scc_property
open Scc_motion
open Scc_explain
open Scc_loading
open Scc_json
open Scc_runs

type t = {
  origin : Origin.t;
  check : Property.check option;
  ending : Replay.ending;
  explanation : Omission.t;
  diagnostics : Diag.t list;
  exit : int;
}

let leaf (m : Model.t) i = Json.text m.leaves.(i).name

let aspect : Causes.aspect -> string = function
  | Motion -> "motion"
  | Structure -> "bonds"
  | Behaviour -> "behaviour"
  | Clock -> "clock"
  | Itself -> "event"

let role : Omission.role -> string = function
  | Irrelevant -> "irrelevant"
  | Cause -> "cause"
  | Keeps_away -> "keeps-away"

(* Steps are numbered from 1, as in a trace. *)
let reason m events (r : Causes.reason) =
  let cause : Causes.event = events.(r.cause) in
  `Assoc
    [
      ("step", `Int (cause.step + 1)); ("what", `String (aspect r.aspect)); ("of", leaf m r.leaf);
    ]

let event m events roles i (e : Causes.event) =
  let kind, of_leaf =
    match e.happening with
    | Discrete _ -> ("transition", `Null)
    | Expiry l -> ("expiry", leaf m l)
  in
  `Assoc
    [
      ("kind", `String kind);
      ("of", of_leaf);
      ("role", `String (role roles.(i)));
      ("because", `List (List.map (reason m events) e.reasons));
    ]

let steps (x : Omission.t) =
  let legs = Course.legs (Causes.run x.story).course and events = Causes.events x.story in
  let m = Causes.model x.story in
  let of_step = Array.make (Array.length legs) [] in
  Array.iteri
    (fun i (e : Causes.event) -> of_step.(e.step) <- event m events x.roles i e :: of_step.(e.step))
    events;
  let step i ({ label; start; _ } : Course.leg) =
    `Assoc
      [
        ("step", `Int (i + 1));
        ("label", State_json.label m label);
        ("time", Json.rat (Rat.add start (Scc_semantics.Transition.duration_of label)));
        ("events", `List (List.rev of_step.(i)));
      ]
  in
  Array.to_list (Array.mapi step legs)

let body m leaves = `List (List.map (leaf m) leaves)

let document ~source t =
  let x = t.explanation in
  let m = Causes.model x.story and events = Causes.events x.story in
  let keeps (leaves, why) = `Assoc [ ("body", body m leaves); ("without", Json.text why) ] in
  `Assoc
    ([
      ("format", `String "scc-explanation");
      ("version", `Int 1);
      ("semantics", `String Scc_calculus.Parameters.version);
    ]
      @ Origin_json.members t.origin
      @ [
        ("exit", `Int t.exit);
        ("check", Json.option (fun (c : Property.check) -> Json.text c.name) t.check);
        ("formula", Json.option (fun (c : Property.check) -> Json.text c.text) t.check);
        ("time", Json.rat (Causes.duration x.story));
        ("facts", `List (List.map Json.text x.facts));
        ("because", `List (List.map (reason m events) x.basis.reasons));
        ("steps", `List (steps x));
        ("ending", `String (Trace.ending t.ending));
        ("left_out", `List (List.map (body m) x.left_out));
        ("keep_away", `List (List.map keeps x.keep_away));
        ("diagnostics", `List (List.map (Diag_json.diagnostic ~source) t.diagnostics));
      ])
