open Scc_exact
open Scc_ctl
open Scc_property
open Scc_semantics
open Scc_state_space
open Scc_json
open Scc_runs

let version = 2
let digit c = Printf.sprintf "%02x" (Char.code c)
let hex text = String.concat "" (List.map digit (List.of_seq (String.to_seq text)))
let texts list = `List (List.map Json.text list)
let only_if present name value = if present then [ (name, value ()) ] else []

let diagnostic (d : Scc_base.Diag.t) : Json.t =
  `Assoc [ ("code", `String (d.code :> string)); ("message", Json.text d.message) ]

let refused d : Json.t = `Assoc [ ("error", diagnostic d) ]

let truth : Truth.t -> Json.t = function
  | True -> `Bool true
  | False -> `Bool false
  | Undecided reason -> `Assoc [ ("undecided", Json.text reason) ]

let label model l =
  [ ("label", Json.text (Transition.label_to_string model l)); ("duration", Json.rat (Transition.duration_of l)) ]
  @ only_if (Transition.is_drawn l) "chance" (fun () -> Json.rat (Transition.chance l))

(* {1 States} *)

let goals values = ("goals", `List (Array.to_list (Array.map truth values)))

let reached f (r : Filter.reached) =
  [
    ("state", `String (hex (Keys.bytes (Filter.keys f) r.tuple)));
    ("fingerprint", `String (Keys.hex r.fingerprint));
    goals r.goals;
  ]
  @ only_if r.too_long "too_long" (fun () -> `Bool true)

let met (m : Filter.met) : Json.t =
  `Assoc
    [
      ("choice", Json.option (fun k -> `Int k) m.choice);
      ("offset", Json.text (Algebraic.to_string m.moment.offset));
      ("attained", `Bool m.moment.attained);
    ]

let ahead (a : Filter.ahead) : Json.t =
  `Assoc [ ("met", Json.option met a.met); ("doubt", Json.option Json.text a.doubt) ]

let follows : _ Filter.following -> string = function
  | Moves _ -> "moves"
  | Rests -> "rests"
  | Ends _ -> "ends"
  | Stops -> "stops"
  | Fault _ -> "fault"

let answer f (e : Filter.expanded) : Json.t =
  let model = (Filter.question f).loaded.model in
  let move (number, r) = `Assoc (label model (Filter.label f number) @ reached f r) in
  let successors =
    match e.follows with Moves moves -> List.map move moves | Rests | Ends _ | Stops | Fault _ -> []
  in
  let reason =
    match e.follows with Ends d | Fault d -> [ ("reason", diagnostic d) ] | Moves _ | Rests | Stops -> []
  in
  `Assoc
    ([ ("fingerprint", `String (Keys.hex e.state.fingerprint)); goals e.state.goals ]
     @ only_if (Array.exists Option.is_some e.ahead) "ahead" (fun () ->
         `List (Array.to_list (Array.map (Json.option ahead) e.ahead)))
     @ [ ("follows", `String (follows e.follows)) ]
     @ reason
     @ [ ("successors", `List successors) ])

(* {1 The header} *)

let rec plan (p : Question.plan) : Json.t =
  match p with
  | Now t -> `Assoc [ ("now", truth t) ]
  | Possibly k -> `Assoc [ ("possibly", `Int k) ]
  | Always k -> `Assoc [ ("always", `Int k) ]
  | All plans -> `Assoc [ ("all", `List (List.map plan plans)) ]
  | Any plans -> `Assoc [ ("any", `List (List.map plan plans)) ]
  | Other -> `Null

let check (q : Question.t) ((c : Property.check), p) : Json.t =
  let premise = List.memq c q.loaded.premises in
  `Assoc
    [ ("name", Json.text c.name); ("formula", Json.text c.text); ("premise", `Bool premise); ("plan", plan p) ]

let goal model (g : Question.goal) (p : On_the_fly.predicate) : Json.t =
  `Assoc
    [
      ("formula", Json.text (Show.prop model g.prop));
      ("within", Json.option Json.rat g.within);
      ("ahead", `Bool (Option.is_some p.along));
    ]

let bound = function
  | Scc_verify.Bounds.Unbounded -> `Null
  | Default n | Given n -> `Int n

let header ~program ~framing f : Json.t =
  let q = Filter.question f in
  let model = q.loaded.model in
  `Assoc
    ([
      ("format", `String "scc-successors");
      ("version", `Int version);
      ("program", `String program);
      ("state_bytes", `Int Scc_codec.State_codec.version);
    ]
      @ Origin_json.members q.loaded.origin
      @ [
        ("framing", `String framing);
        ("reductions", texts (List.map Reduction.name q.reductions));
        ("bounds", `Assoc [ ("instant", bound Scc_verify.Bounds.default.instant); ("bits", `Int q.bits) ]);
        ("exploration", `Int q.number);
        ("explorations", `Int q.count);
        ("horizon", Json.option Json.rat (Scc_verify.Joint_check.horizon q.exploration.members));
        ("left_out", texts q.exploration.left_out);
        ("checks", `List (List.map (check q) q.plans));
        ("goals", `List (List.map2 (goal model) (Array.to_list q.goals) (Array.to_list (Filter.predicates f))));
        ("events", texts (List.map (Show.event model) (Filter.events f)));
        ("initial", `Assoc (reached f (Filter.initial f)));
      ])
