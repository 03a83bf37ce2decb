open Scc_property
open Scc_verify
open Scc_json
open Scc_runs
open Json_format

let status : Labelling.status -> string = function
  | Moves -> "expanded"
  | Rests -> "quiescent"
  | Stuck -> "stuck"
  | Unexplored -> "unexplored"

let predicate =
  let part f (l, k) = f (Labelling.predicates l).(k) in
  fields
    [
      field "name" Explicit_files.name_format (part (fun (p : State_predicates.t) -> p.name));
      field "text" text (part (fun (p : State_predicates.t) -> p.text));
      field "changes" natural (fun (l, k) -> Labelling.changes l k)
        ~about:"In how many passings of time it changes between the start (included) and the end.";
      field "undecided" (nullable text) (fun (l, k) -> Option.map snd (Labelling.undecided l k))
        ~about:"Why it has no truth value somewhere, where it is told not to hold.";
    ]

let check =
  fields
    [
      field "name" text (fun (c : Property.check) -> c.name);
      field "text" text (fun (c : Property.check) -> c.text);
    ]

let edge =
  fields
    [
      field "label" State_json.label_format (fun (m, (e : Explored.edge)) -> (m, e.label));
      field "target" natural (fun (_, (e : Explored.edge)) -> e.target);
      State_json.tie_chance (fun (_, (e : Explored.edge)) -> (e.label, e.chance));
    ]

(* A state whose transitions are known has some, and any other one has none. *)
let state =
  let names (l, i) =
    let all = Array.to_list (Labelling.predicates l) in
    List.map (fun (p : State_predicates.t) -> p.name) (List.filteri (fun k _ -> Labelling.holds l i k) all)
  in
  let space (l, _) = Labelling.space l in
  let in_full ((_, i) as s) = (Explored.model (space s), (space s).state i) in
  let edges ((_, i) as s) =
    List.map (fun e -> (Explored.model (space s), e)) (Array.to_list ((space s).edges i))
  in
  let wrong (json : Json.t) =
    match (Json.member "status" json, Json.member "edges" json) with
    | Some (`String "expanded"), Some (`List []) -> Some "has no edges"
    | Some (`String "expanded"), _ | _, Some (`List []) -> None
    | _ -> Some "has edges"
  in
  let has name keyword value = `Assoc [ ("properties", `Assoc [ (name, `Assoc [ (keyword, value) ]) ]) ] in
  fields
    [
      field "number" natural snd;
      field "status" (word status [ Moves; Rests; Stuck; Unexplored ]) (fun (l, i) -> Labelling.status l i)
        ~about:
          "quiescent: nothing will ever happen again, and time passes for ever. stuck: nothing can happen, not \
           even the passing of time. unexplored: its transitions are not known.";
      field "holds" (list ~distinct:true Explicit_files.name_format) names
        ~about:"The names of the predicates that hold in the state.";
      field "state" State_json.state_format in_full;
      field "edges" (list edge) edges;
    ]
  |> constrained
    [
      ("if", has "status" "const" (`String "expanded")); ("then", has "edges" "minItems" (`Int 1));
      ("else", has "edges" "maxItems" (`Int 0));
    ]
    wrong

type t = { exported : Exported.t; labelling : Labelling.t }

(* All but the states. *)
let head =
  let space f t = f t.exported.space in
  let faults (s : Explored.t) = List.map (fun (f : Scc_base.Diag.t) -> f.message) s.faults in
  let bounds (s : Explored.t) = List.map Verdict.truncation_to_string s.stopped_by in
  let predicates t = List.mapi (fun k _ -> (t.labelling, k)) (Array.to_list (Labelling.predicates t.labelling)) in
  all
    (Shared.head "scc-graph" 1
     @ [
       Shared.semantics ();
       within (fun t -> t.exported.loaded.origin) Origin_json.fields;
       field "complete" bool (space Explored.complete) ~about:"All transitions of all states are there.";
       field "unexplored" natural (space Explored.unexpanded)
         ~about:"How many states are left whose transitions are not known.";
       field "bounds" Shared.texts (space bounds) ~about:"The bounds that left them, in words.";
       field "faults" Shared.texts (space faults) ~about:"Why transitions could not be computed.";
       field "checks" (list check) (fun t -> t.exported.loaded.checks);
       field "predicates" (list predicate) predicates
         ~about:"The state predicates of the checks: each atom, and check_NAME for the whole one of a check.";
     ])

let document =
  let get t = (t.exported.space.size, fun i -> (t.labelling, i)) in
  let about = "In the order in which they were found; the first is the initial one." in
  { Long_document.head; rows = "states"; about; row = state; get }

let format = Long_document.format document
let write exported labelling = Long_document.write document { exported; labelling }
