open Scc_exact
open Scc_semantics
open Scc_explain
open Scc_verify

(* A witness of more steps is shown in part: its schedule has them all. *)
let shown_steps = 60

(* States of more processes than this are not shown: the facts say what matters. *)
let shown_processes = 12

let style : Verdict.t -> Console.style = function
  | Holds { bounds = []; _ } -> Good
  | Holds _ as v when not (Verdict.by_default v || Verdict.resources v) -> Good
  | Holds _ | Undecided _ -> Doubtful
  | Violated _ -> Bad

let step_lines ?(most = shown_steps) m (w : Witness.t) =
  let n = List.length w.steps in
  let width = String.length (string_of_int n) in
  let line i (s : Witness.step) =
    let preposition = if Rat.sign (Transition.duration s.transition) > 0 then "to" else "at" in
    Printf.sprintf "%*d. %s, %s time %s" width (i + 1)
      (Run_text.label m s.transition.label)
      preposition
      (Scc_exchange.Short_text.exact s.time)
  in
  (* Only what is shown is put into words. *)
  let lines from count =
    List.filteri (fun i _ -> i >= from && i < from + count) w.steps |> List.mapi (fun i s -> line (from + i) s)
  in
  if n <= most then lines 0 n
  else
    let half = most / 2 in
    lines 0 half @ (Printf.sprintf "… %d more …" (n - most) :: lines (n - half) half)

let state_lines c (w : Witness.t) =
  let m = Semantics.model c and s = Witness.there c w in
  if Array.length s.processes > shown_processes then []
  else
    let heading =
      if Witness.at_rational_instant w then "there:"
      else "there, nearly (at a rational instant close by):"
    in
    heading :: List.map (fun l -> "  " ^ l) (Run_text.state m s)

let witness c w =
  let m = Semantics.model c in
  step_lines m w @ Witness.ending m w @ state_lines c w

(* Where more was to be explored: the way there in short. *)
let way m w = step_lines ~most:12 m w @ Witness.ending m w
let indented depth lines = List.map (fun l -> String.make depth ' ' ^ l ^ "\n") lines

let property console c ({ check; verdict = v; _ } as o : Verdict.outcome) =
  let verdict = Console.styled console (style v) (Verdict.outcome_to_string o) in
  let head = Printf.sprintf "%s: %s\n  %s\n" (Console.styled console Strong check.name) verdict check.text in
  let run =
    match v with
    | Holds { witness = Some w; _ } -> [ ("a run that shows it:", witness c w) ]
    | Violated { witness = Some w } -> [ ("a run that violates it:", witness c w) ]
    | Holds _ | Violated _ -> []
    | Undecided reasons ->
      List.filter_map
        (function
          | Verdict.Unexplored { nearest; _ } ->
            Some ("to the nearest unexplored state that matters:", way (Semantics.model c) nearest)
          | Truncated _ | Undefined _ | Fault _ -> None)
        reasons
  in
  let none =
    match v with
    | Violated { witness = None } -> [ "  no run shows it: everything that counts was explored\n" ]
    | _ -> []
  in
  let show (what, lines) = Printf.sprintf "  %s\n" what :: indented 4 lines in
  String.concat "" ((head :: none) @ List.concat_map show run)

let zeno c w =
  String.concat ""
    ("Zeno behaviour: a run that goes on for ever within one instant\n" :: indented 4 (witness c w))

let plural n one many = if n = 1 then "1 " ^ one else Printf.sprintf "%d %s" n many

let explored (s : Check.stats) =
  let how =
    if s.complete then "complete"
    else
      match Verdict.distinct s.stopped_by with
      | [] when s.decided_early -> "not complete: every property was decided before"
      | [] -> "not complete"
      | bounds ->
        "not complete: stopped by "
        ^ String.concat ", " (List.map Verdict.truncation_to_string bounds)
  in
  Printf.sprintf "explored: %s, %s, depth %d, model time %s; %s\n"
    (plural s.states "state" "states")
    (plural s.transitions "transition" "transitions")
    s.depth
    (Scc_exchange.Short_text.exact s.model_time)
    how

let left_out (slice : Check.slice) =
  let shown = List.filteri (fun i _ -> i < 8) slice.left_out in
  let more = List.length slice.left_out - List.length shown in
  let names = String.concat ", " shown ^ if more > 0 then Printf.sprintf " and %d more" more else "" in
  Printf.sprintf "  of that, without %s, which cannot matter: %s for %s\n" names
    (plural slice.explored.states "state" "states")
    (String.concat ", " slice.properties)

let slices list = String.concat "" (List.map left_out list)

let tally console verdicts =
  let count f = List.length (List.filter f verdicts) in
  let exhaustive = count Verdict.exhaustive in
  let bounded = count (function Verdict.Holds { bounds = _ :: _; _ } -> true | _ -> false) in
  let violated = count (function Verdict.Violated _ -> true | _ -> false) in
  let undecided = count (function Verdict.Undecided _ -> true | _ -> false) in
  let part n style text =
    if n = 0 then [] else [ Console.styled console style (Printf.sprintf "%d %s" n text) ]
  in
  let parts =
    part exhaustive Good (if exhaustive = 1 then "holds" else "hold")
    @ part bounded Doubtful (if bounded = 1 then "holds up to the bound" else "hold up to the bound")
    @ part violated Bad "violated"
    @ part undecided Doubtful "undecided"
  in
  match verdicts with
  | [] -> "no properties to check\n"
  | _ ->
    Printf.sprintf "%s: %s\n"
      (plural (List.length verdicts) "property" "properties")
      (String.concat ", " parts)
