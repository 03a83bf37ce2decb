open Scc_ctl
open Scc_exact
open Scc_property
open Scc_semantics
open Scc_evaluate
open Scc_space
module Graph = State_graph

(** {2 Facts} *)

let facts_at context graph temporal (at : Scc_ctl.Positions.position) p =
  let state = Catalogue.decode (Network_lts.catalogue context) (Graph.tuple graph at.node) in
  let extent =
    if not (Scc_ctl.Positions.is_inside at) then Timeline.Instant
    else
      match Temporal.flow_choice temporal at.node with
      | None -> Timeline.Forever
      | Some k -> Lasts (Graph.duration graph (Graph.edges graph at.node).(k))
  in
  let arrived = Network_lts.arrived context (Graph.tuple graph at.node) in
  let time_seen = Catalogue.time_seen (Network_lts.catalogue context) in
  let later_than = Option.bind state.time (Time_seen.beyond time_seen) in
  Facts.at ?later_than ~arrived (Network_lts.semantics context) state extent at.offset
    (Temporal.predicate temporal p)

(* What an operator waits for, and what that waits for in turn. *)
let rec subject (f : Scc_ctl.Formula.t) =
  match f with
  | Predicate p -> [ p ]
  | And fs | Or fs -> List.concat_map subject fs
  | Not f | Finally (_, _, f) | Globally (_, _, f) | Until (_, _, _, f) | Next (_, f) -> subject f

let distinct facts =
  List.rev (List.fold_left (fun kept f -> if List.mem f kept then kept else f :: kept) [] facts)

let about_at context graph temporal formula position =
  List.concat_map (facts_at context graph temporal position) (subject formula)

let about context graph temporal formula node =
  distinct (about_at context graph temporal formula (Scc_ctl.Positions.start node))

let rec given (e : Explanation.t) =
  match (e.formula, e.because) with
  | Predicate p, Given -> [ (p, e.position) ]
  | _, Parts parts -> List.concat_map given parts
  | _, (Given | Run _ | Everywhere _) -> []

let has_run e = Option.is_some (Explanation.chain e)
let leads_on e = match Explanation.chain e with Some run -> Explanation.goes_on run | None -> false

(* The last run of the chain, and the explanations where it leads. *)
let rec last_run (e : Explanation.t) =
  match e.because with
  | Given | Everywhere _ -> None
  | Parts parts -> Option.bind (List.find_opt has_run parts) last_run
  | Run { run; parts } -> (
      match (Scc_ctl.Run.goal run, List.find_opt has_run parts) with
      | Some _, Some part when leads_on part -> last_run part
      | _ -> Some (e.formula, run, parts))

let facts context graph temporal e =
  match last_run e with
  | None -> []
  | Some (formula, run, parts) ->
    (match Scc_ctl.Run.goal run with
     | None -> about context graph temporal formula run.last
     | Some _ ->
       let at_goal (part : Explanation.t) =
         match part.because with
         | Run _ -> about_at context graph temporal part.formula part.position
         | Given | Parts _ | Everywhere _ ->
           List.concat_map (fun (p, at) -> facts_at context graph temporal at p) (given part)
       in
       distinct (List.concat_map at_goal parts))

(** {2 The tree} *)

let duration context graph (s : Graph.step) =
  Catalogue.duration (Network_lts.catalogue context) (Graph.edges graph s.source).(s.choice).label

(* Passing time is told by the clock alone. *)
let event context graph (s : Graph.step) =
  match Catalogue.label_of (Network_lts.catalogue context) (Graph.edges graph s.source).(s.choice).label with
  | Time _ -> None
  | (Bind _ | Bounce _ | Weak_split _ | Strong_split _) as label ->
    Some (Transition.label_to_string (Network_lts.model context) label)

(* What happens on a run, seen from where it starts. *)
let story context graph temporal (run : Scc_ctl.Run.t) =
  let steps = Scc_base.Long_list.map (Temporal.choice temporal) run.steps in
  let start = Algebraic.to_rat run.start.offset in
  let clock, events =
    List.fold_left
      (fun (clock, events) step ->
         let clock = Rat.add clock (duration context graph step) in
         match event context graph step with
         | None -> (clock, events)
         | Some e -> (clock, Printf.sprintf "%s after %s" e (Rat.to_string clock) :: events))
      (Rat.neg (Option.value start ~default:Rat.zero), [])
      steps
  in
  (clock, List.rev events)

let most = 12

let listed events =
  let shown = List.filteri (fun i _ -> i < most) events in
  let more = List.length events - List.length shown in
  let rest = if more > 0 then [ Printf.sprintf "%d events more" more ] else [] in
  match shown @ rest with [] -> [] | lines -> [ String.concat "; " lines ]

(* A run that repeats its steps from [k] on. *)
let again context graph temporal (run : Scc_ctl.Run.t) k =
  let first = { run with steps = List.filteri (fun i _ -> i < k) run.steps } in
  let clock, before = story context graph temporal first and _, all = story context graph temporal run in
  match (k, List.compare_lengths before all) with
  | 0, 0 -> "nothing else happens, for ever"
  | 0, _ -> "the run then repeats all of this, for ever"
  | _, 0 -> Printf.sprintf "nothing else happens after time %s from here, for ever" (Rat.to_string clock)
  | _ -> Printf.sprintf "the run then repeats what happens after time %s from here, for ever" (Rat.to_string clock)

let finish_text context graph temporal (run : Scc_ctl.Run.t) clock =
  let at offset = Algebraic.to_string (Algebraic.add_rat clock offset) in
  match run.finish with
  | At_state when run.steps = [] -> "here"
  | At_state -> Printf.sprintf "in the state after time %s from here" (Rat.to_string clock)
  | During { moment; _ } when moment.attained -> Printf.sprintf "after time %s from here" (at moment.offset)
  | During { moment; sample } ->
    Printf.sprintf "right after time %s from here, for example after %s" (at moment.offset) (at sample)
  | Rests -> "the run then rests for ever"
  | Stops -> "the run then is over"
  | Repeats k -> again context graph temporal run k
  | Passes -> "the run then passes the bound of time"

let because context graph temporal (e : Explanation.t) =
  match e.because with
  | Given -> (
      match e.formula with
      | Predicate p -> facts_at context graph temporal e.position p
      | _ -> [])
  | Parts _ -> []
  | Everywhere n ->
    [
      (match (e.formula, n) with
       | _, 0 -> "nothing on the way says otherwise"
       | _, 1 -> "the one state that counts from here on was looked at"
       | _ -> Printf.sprintf "all %d states that count from here on were looked at" n);
    ]
  | Run { run; _ } ->
    let clock, events = story context graph temporal run in
    listed events @ [ finish_text context graph temporal run clock ]

(* That "not p" fails is told as that p holds. *)
let affirmed temporal (e : Explanation.t) =
  match (Skeleton.to_temporal (Temporal.predicate temporal) e.formula, e.because) with
  | State (Not p), Given -> (Property.State p, not e.holds)
  | formula, _ -> (formula, e.holds)

(* What a fact says that a claim does not. *)
let beyond claim holds fact =
  let start = claim ^ if holds then " holds" else " fails" in
  let n = String.length start and m = String.length fact in
  if m < n || not (String.equal (String.sub fact 0 n) start) then Some fact
  else if m = n then None
  else if m > n + 2 && fact.[n] = ':' then Some (String.sub fact (n + 2) (m - n - 2))
  else Some fact

let rec tree context graph temporal (e : Explanation.t) : Witness.argument =
  let parts =
    match e.because with
    | Given | Everywhere _ -> []
    | Parts parts | Run { parts; _ } -> parts
  in
  let formula, holds = affirmed temporal e in
  let claim = Show.temporal (Network_lts.model context) formula in
  {
    claim;
    holds;
    because = List.filter_map (beyond claim holds) (because context graph temporal e);
    parts = List.map (tree context graph temporal) parts;
  }

let rec is_plain (e : Explanation.t) =
  match e.because with
  | Given -> true
  | Everywhere _ | Run _ -> false
  | Parts parts -> List.for_all is_plain parts

let argument context graph temporal (e : Explanation.t) =
  match e.because with
  | Run { parts; _ } when List.for_all is_plain parts -> None
  | Run _ | Given | Parts _ | Everywhere _ -> Some (tree context graph temporal e)
