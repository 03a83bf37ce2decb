open Scc_base
open Scc_exact
open Scc_calculus
open Scc_property
open Scc_motion
open Scc_explain
open Scc_loading
open Scc_json
open Scc_runs
open Json_format

type t = {
  origin : Origin.t;
  check : Property.check option;
  ending : Replay.ending;
  explanation : Omission.t;
  diagnostics : Diag.t list;
  exit : int;
}

let in_explain name t = named ~file:"explain" name t
let leaf = from (fun ((m : Model.t), i) -> m.leaves.(i).name) some_text

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
let reason =
  let step (x, (r : Causes.reason)) = (Causes.events x).(r.cause).step + 1 in
  fields
    [
      field "step" Shared.from_one step ~about:"Its number, from 1.";
      field "what" (word aspect [ Motion; Structure; Behaviour; Clock; Itself ]) (fun (_, (r : Causes.reason)) ->
          r.aspect)
        ~about:
          "Velocity and line of flight of the leaf's process; its leaves and bonds; the leaf's behaviour; the \
           split clock of its process; or the event itself, when the fact is that it happened.";
      field "of" leaf (fun (x, (r : Causes.reason)) -> (Causes.model x, r.leaf)) ~about:"The leaf.";
    ]
  |> about "The step that was the last to change this of the leaf."
  |> in_explain "reason"

let reasons =
  from (fun (x, all) -> List.map (fun r -> (x, r)) all) (list reason) |> checked |> in_explain "reasons"

(* An event of a story, with its role. *)
let event =
  let expires (x, ((e : Causes.event), _)) =
    match e.happening with Discrete _ -> None | Expiry l -> Some (Causes.model x, l)
  in
  let kind e = if Option.is_some (expires e) then "expiry" else "transition" in
  fields
    [
      field "kind" (word Fun.id [ "transition"; "expiry" ]) kind
        ~about:"The transition of the step, or an eps that expires at the end of a passing of time.";
      field "of" (nullable leaf) expires ~about:"The leaf whose eps expires.";
      field "role" (word role [ Irrelevant; Cause; Keeps_away ]) (fun (_, (_, role)) -> role);
      field "because" reasons (fun (x, ((e : Causes.event), _)) -> (x, e.reasons));
    ]
  |> in_explain "event"

let step =
  let after ({ label; start; _ } : Course.leg) = Rat.add start (Scc_semantics.Transition.duration_of label) in
  fields
    [
      field "step" Shared.from_one (fun (_, (i, _, _)) -> i + 1);
      field "label" State_json.label_format (fun (x, (_, (l : Course.leg), _)) -> (Causes.model x, l.label));
      field "time" Shared.rational (fun (_, (_, leg, _)) -> after leg) ~about:"Model time after it.";
      field "events" (list event) (fun (x, (_, _, events)) -> List.map (fun e -> (x, e)) events);
    ]
  |> in_explain "step"

let steps (x : Omission.t) =
  let legs = Course.legs (Causes.run x.story).course in
  let of_step = Array.make (Array.length legs) [] in
  Array.iteri
    (fun i (e : Causes.event) -> of_step.(e.step) <- (e, x.roles.(i)) :: of_step.(e.step))
    (Causes.events x.story);
  Array.to_list (Array.mapi (fun i leg -> (x.story, (i, leg, List.rev of_step.(i)))) legs)

let body =
  from (fun (m, leaves) -> List.map (fun l -> (m, l)) leaves) (list ~least:1 leaf)
  |> about "A process of the model, by its leaves."
  |> checked |> in_explain "body"

let format =
  let part f (_, t) = f t in
  let story f (_, t) = f t.explanation in
  let of_check f (_, t) = Option.map f t.check in
  let bodies all (x : Omission.t) = List.map (fun b -> (Causes.model x.story, b)) (all x) in
  let keeps =
    fields
      [
        field "body" body (fun (m, (leaves, _)) -> (m, leaves));
        field "without" some_text (fun (_, (_, why)) -> why);
      ]
  in
  fields
    (Shared.head "scc-explanation" 1
     @ [
       Shared.semantics ();
       within (part (fun t -> t.origin)) Origin_json.fields;
       field "exit" Shared.exit (part (fun t -> t.exit));
       field "check" (nullable text) (of_check (fun (c : Property.check) -> c.name))
         ~about:"The property whose atoms are the facts; null when the last event is explained.";
       field "formula" (nullable text) (of_check (fun (c : Property.check) -> c.text));
       field "time" Shared.rational (story (fun x -> Causes.duration x.story))
         ~about:"Model time of the facts.";
       field "facts" (list some_text) (story (fun x -> x.facts));
       field "because" reasons (story (fun x -> (x.story, x.basis.reasons)));
       field "steps" (list step) (story steps);
       field "ending" Trace.ending_format (part (fun t -> t.ending))
         ~about:
           "How the run stands where it is left: stuck is a dead end, whose SC0602 is among the diagnostics, \
            with a note that says where.";
       field "left_out" (list body) (story (bodies (fun x -> x.left_out)))
         ~about:
           "Tried: without all these bodies, the same causes happen at the same times, and the facts are the \
            same.";
       field "keep_away" (list keeps) (story (bodies (fun x -> x.keep_away)))
         ~about:"Bodies that matter by what they keep out of the way, and what differs without each.";
       field "diagnostics" Diag_json.formats (fun (source, t) -> (source, t.diagnostics));
     ])

let document ~source t = write format (source, t)
