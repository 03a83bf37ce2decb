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
  | Measured { reasons = []; _ } -> Good
  | Depends d when Option.equal Bool.equal (Verdict.everywhere d) (Some false) -> Bad
  | Depends _ -> Good
  | Holds _ | Measured _ | Undecided _ -> Doubtful
  | Violated _ -> Bad

(* Steps that are told in one line: how many passings of the same time, or one step. *)
type entry = { first : int; times : int; step : Witness.step  (** the last of them *) }

(* What comes back at a step is told from there. *)
let entries ~full (w : Witness.t) =
  let cycle = match w.finish with Repeats { cycle; _ } -> cycle | _ -> -1 in
  let add (i, entries) (s : Witness.step) =
    let fresh () = { first = i; times = 1; step = s } :: entries in
    let entries =
      match (entries, s.transition.label) with
      | ({ step = { transition = { label = Time before; _ }; _ }; _ } as e) :: rest, Time d
        when (not full) && i <> cycle && Rat.equal before d ->
        { e with times = e.times + 1; step = s } :: rest
      | _ -> fresh ()
    in
    (i + 1, entries)
  in
  List.rev (snd (List.fold_left add (0, []) w.steps))

let entry_number e =
  if e.times = 1 then string_of_int (e.first + 1) else Printf.sprintf "%d-%d" (e.first + 1) (e.first + e.times)

let entry_text ~full m e =
  let duration = Transition.duration e.step.transition in
  let preposition = if Rat.sign duration > 0 then "to" else "at" in
  let what =
    if e.times = 1 then Run_text.label ~full m e.step.transition.label
    else Run_text.passes ~full e.times duration
  in
  Printf.sprintf "%s, %s time %s" what preposition (Run_text.number ~full e.step.time)

let step_lines ?(most = shown_steps) ~full m (w : Witness.t) =
  let entries = entries ~full w in
  let n = List.length entries in
  let half = most / 2 in
  let cut = (not full) && n > most in
  let shown = if cut then List.filteri (fun i _ -> i < half || i >= n - half) entries else entries in
  let width = List.fold_left (fun w e -> Int.max w (String.length (entry_number e))) 0 shown in
  let line e = Printf.sprintf "%*s. %s" width (entry_number e) (entry_text ~full m e) in
  let lines = List.map line shown in
  if not cut then lines
  else
    let left_out = List.filteri (fun i _ -> i >= half && i < n - half) entries in
    let steps = List.fold_left (fun sum e -> sum + e.times) 0 left_out in
    List.filteri (fun i _ -> i < half) lines
    @ (Printf.sprintf "… %d more …" steps :: List.filteri (fun i _ -> i >= half) lines)

let leaves_of (label : Transition.label) =
  let ends (b : Scc_calculus.State.bond) = [ b.one.at; b.two.at ] in
  match label with
  | Bounce { firsts; _ } -> firsts
  | Absorb { first; absorber } -> [ first; absorber ]
  | Draw { first; _ } -> [ first ]
  | Lot { bond; _ } -> ends bond
  | Time _ | Bind _ | Close _ | Weak_split _ | Strong_split _ -> List.concat_map ends (Transition.bonds label)

module Leaves = Set.Make (Int)

(* Whom a property speaks of. *)
type about = Everyone | Only of int list

let about formula =
  if Scc_property.Formula.global formula then Everyone else Only (Scc_property.Formula.leaves formula)

(* Those that matter are told: whom the property speaks of, and who takes part in an event of the run and can do
   something. *)
let aside m ~about (w : Witness.t) =
  let of_step set (s : Witness.step) = Leaves.add_seq (List.to_seq (leaves_of s.transition.label)) set in
  let active = List.fold_left of_step Leaves.empty w.steps in
  let named = match about with Only leaves -> Leaves.of_list leaves | Everyone -> Leaves.empty in
  let everyone = match about with Everyone -> true | Only _ -> false in
  fun (p : Scc_calculus.State.process) ->
    let is_in set = Array.exists (fun (l : Scc_calculus.State.leaf) -> Leaves.mem l.leaf set) p.leaves in
    let inert = Run_text.fixed m p && Run_text.does_nothing m p in
    if is_in named || ((everyone || is_in active) && not inert) then None
    else Some (if Run_text.fixed m p then "fixed" else "no part in it")

let told aside (s : Scc_calculus.State.t) =
  Array.fold_left (fun n p -> if Option.is_none (aside p) then n + 1 else n) 0 s.processes

let state_lines ~full ~about c (w : Witness.t) =
  let m = Semantics.model c and s = Witness.there c w in
  let aside = aside m ~about w in
  if (not full) && told aside s > shown_processes then []
  else
    let heading =
      if Witness.is_before_bound w then "before that, in the last state:"
      else if Witness.at_rational_instant w then "there:"
      else "there, nearly (at a rational instant close by):"
    in
    heading :: List.map (fun l -> "  " ^ l) (Run_text.state ~full ~aside m s)

let ending ~full m w =
  let lines = Witness.ending m w in
  if full then lines else List.map Scc_runs.Short_text.within lines

let witness ~full ~about c w =
  let c = Witness.semantics c w in
  let m = Semantics.model c in
  List.append (step_lines ~full m w) (ending ~full m w @ state_lines ~full ~about c w)

(* Where more was to be explored: the way there in short. *)
let way ~full m w = List.append (step_lines ~most:12 ~full m w) (ending ~full m w)

let indented depth lines = List.map (fun l -> String.make depth ' ' ^ l ^ "\n") lines

(* What a run that is shown is to a probability, and how likely it is once all is chosen as it is there. *)
let counted (check : Scc_property.Property.check) (w : Witness.t) =
  let chance =
    List.fold_left
      (fun product (s : Witness.step) -> Option.fold ~none:product ~some:(Rat.mul product) s.transition.chance)
      Rat.one w.steps
  in
  let counts =
    match check.formula with
    | Globally (Chance _, _, _) -> "that does not count"
    | Finally (Chance _, _, _) | Until (Chance _, _, _, _) -> "that counts"
    | _ -> "of which the reasons speak"
  in
  if Rat.equal chance Rat.one then counts
  else Printf.sprintf "%s, of probability %s" counts (Likelihoods.number chance)

(* For which values it holds; or, of a probability, what it is for which. *)
let where_lines (o : Verdict.outcome) w =
  match o.verdict with
  | Measured { starts = (_, first) :: rest; _ }
    when List.for_all (fun (_, c) -> Scc_regions.Chances.equal first c) rest ->
    Scc_regions.Words.chances_lines first
  | Measured { starts = _ :: _ as starts; _ } ->
    let number = match o.check.asked with Expected _ -> " mean" | How_likely _ | Whether -> " probability" in
    let of_side (side, c) =
      (Likelihoods.side side ^ number) :: List.map (fun l -> "  " ^ l) (Scc_regions.Words.chances_lines c)
    in
    List.concat_map of_side starts
  | Undecided _ when Verdict.asks_number o.check -> [ "its value is not known for all starts" ]
  | Holds _ | Violated _ | Measured _ | Depends _ | Undecided _ -> Scc_regions.Words.lines w

(* What a verdict has no room for: a function, and with [full] all digits of a number. *)
let answer_lines ~full = function
  | Verdict.Depends { parameter; values; holds } -> Depending.lines ~full parameter ~values ~holds
  | Measured { values; starts = []; _ } when full ->
    let texts = List.map (fun (side, m) -> (side, Likelihoods.in_full m)) values in
    let same = match texts with (_, first) :: rest -> List.for_all (fun (_, t) -> t = first) rest | [] -> true in
    let line what text = Printf.sprintf "%sexactly: %s" what text in
    if same then List.filteri (fun i _ -> i = 0) texts |> List.filter_map (fun (_, t) -> Option.map (line "") t)
    else List.filter_map (fun (side, t) -> Option.map (line (Likelihoods.side side ^ ", ")) t) texts
  | Holds _ | Violated _ | Measured _ | Undecided _ -> []

let no_run formula =
  if Scc_property.Plan.is_search (Scc_property.Plan.of_formula formula) then
    "no run from there does otherwise: everything that counts was explored"
  else if Scc_property.Formula.by_one_run ~holds:false formula then
    "there is a run that shows it, but none was found that is short enough to be shown"
  else "no single run shows it: everything that counts was explored"

let property console ~full ?parameter ?where c ~from (o : Verdict.outcome) =
  let { Verdict.check; verdict = v; lost; left_out; _ } = o in
  let verdict = Console.styled console (style v) (Verdict.outcome_to_string o) in
  let head = Printf.sprintf "%s: %s\n  %s\n" (Console.styled console Strong check.name) verdict check.text in
  let functions = indented 2 (answer_lines ~full v) in
  let head = head ^ Curve_output.lines v ^ String.concat "" functions in
  let witness = witness ~full ~about:(about check.formula) c in
  let run =
    match v with
    | Holds { witness = Some w; _ } | Violated { witness = Some w }
    | Measured { reasons = []; witness = Some w; _ }
      when Scc_property.Formula.asks_probability check.formula ->
      [ (Printf.sprintf "a run %s:" (counted check w), witness w) ]
    | Holds { witness = Some w; _ } -> [ ("a run that shows it:", witness w) ]
    | Violated { witness = Some w } -> [ ("a run that violates it:", witness w) ]
    | Holds _ | Violated _ | Depends _ -> []
    | Measured { reasons; _ } | Undecided reasons ->
      List.filter_map
        (function
          | Verdict.Unexplored { nearest; _ } ->
            Some ("to the nearest unexplored state that matters:", way ~full (Semantics.model c) nearest)
          | Truncated _ | Unevaluated _ | Undefined _ | Fault _ -> None)
        reasons
  in
  let none =
    match v with
    | _ when lost <> [] ->
      let fault what = Printf.sprintf "  what failed: %s\n" what in
      List.map fault lost
    | _ when Option.is_some left_out -> []
    | Violated { witness = None } when Verdict.over_zones o -> [ Printf.sprintf "  %s\n" (no_run check.formula) ]
    | Violated { witness = None } when Option.is_some parameter -> []
    | Violated { witness = None } -> [ "  no run shows it: everything that counts was explored\n" ]
    | _ -> []
  in
  let cure =
    Scc_estimate.Cure.of_outcome (Semantics.model c) ~parameter ~from o
    |> Option.fold ~none:[] ~some:(fun text -> [ Printf.sprintf "  likely cure: %s\n" text ])
  in
  let other =
    match v with
    | Holds { witness = Some { otherwise = Some o; _ }; _ }
    | Violated { witness = Some { otherwise = Some o; _ } } ->
      let from = if o.shared = 0 then "at the start" else Printf.sprintf "after step %d" o.shared in
      [ (Printf.sprintf "the nearest run that does otherwise, which parts from it %s:" from, witness o.run) ]
    | Holds _ | Violated _ | Measured _ | Depends _ | Undecided _ -> []
  in
  let show (what, lines) = Printf.sprintf "  %s\n" what :: indented 4 lines in
  let where = match where with None -> [] | Some w -> indented 2 (where_lines o w) in
  String.concat "" ((head :: none) @ cure @ where @ List.concat_map show (run @ other))

let zeno ~full c w =
  let lines = witness ~full ~about:(Only []) c w in
  String.concat ""
    ("Zeno behaviour: a run that goes on for ever within one instant\n" :: indented 4 lines)

let zeno_left_out t =
  Printf.sprintf
    "Zeno behaviour: a run that goes on for ever within one instant, which is left out: making it ended at %s\n"
    (Verdict.truncation_to_string t)

let explored (s : Stats.t) =
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
  let told t = ", model time " ^ Scc_runs.Short_text.exact t in
  let time = Option.fold ~none:"" ~some:told s.model_time in
  Printf.sprintf "explored: %s, %s, depth %d%s; %s\n"
    (Scc_base.Plural.count s.states "state" "states")
    (Scc_base.Plural.count s.transitions "transition" "transitions")
    s.depth
    time
    how

let causes (m : Scc_calculus.Model.t) (s : Stats.t) =
  let cause c =
    Printf.sprintf "  likely cause: %s\n    cure: %s\n" (Growth.to_string m c) (Growth.cure m c)
  in
  let left_out t =
    Printf.sprintf "  %slikely causes are left out: looking for them ended at %s\n"
      (match s.causes with [] -> "" | _ :: _ -> "further ")
      (Verdict.truncation_to_string t)
  in
  let left_out = Option.fold ~none:"" ~some:left_out s.left_out in
  match s.causes with
  | [] -> left_out
  | causes ->
    String.concat "" (List.map cause causes) ^ left_out ^ "  (specs/guide.md, \"Why did my model blow up?\")\n"

let invariants ~asked (report : Check.report) =
  let text = function
    | By_invariant.Proved { invariant; _ } ->
      Printf.sprintf "invariant: %s that no run leaves, checked afresh\n"
        (Scc_base.Plural.count (List.length invariant.locations) "kind of states" "kinds of states")
    | None_found reason | Given_up reason -> if asked then Printf.sprintf "no invariant: %s\n" reason else ""
  in
  String.concat "" (List.map text report.invariants)

let left_out (slice : Check.slice) =
  let shown = List.filteri (fun i _ -> i < 8) slice.left_out in
  let more = List.length slice.left_out - List.length shown in
  let names = String.concat ", " shown ^ if more > 0 then Printf.sprintf " and %d more" more else "" in
  Printf.sprintf "  of that, without %s, which cannot matter: %s for %s\n" names
    (Scc_base.Plural.count slice.explored.states "state" "states")
    (String.concat ", " slice.properties)

let slices list = String.concat "" (List.map left_out list)

(* A probability of which nothing can be shown. *)
let is_anything (o : Verdict.outcome) (_, m) =
  match o.check.asked with
  | How_likely _ -> String.equal (Likelihoods.measured m) "in [0, 1]"
  | Expected _ | Whether -> false

(* A number that was asked for, and is known by an interval alone: whether the interval tells something. *)
let interval ~tells (o : Verdict.outcome) =
  match o.verdict with
  | Measured { reasons = _ :: _; starts = _ :: _; _ } -> tells
  | Measured { reasons = _ :: _; starts = []; values; _ } ->
    Bool.equal tells (not (List.for_all (is_anything o) values))
  | Measured { reasons = []; _ } | Depends _ | Holds _ | Violated _ | Undecided _ -> false

let tally console outcomes =
  let verdicts = List.map (fun (o : Verdict.outcome) -> o.verdict) outcomes in
  let count f = List.length (List.filter f verdicts) in
  let intervals ~tells = List.length (List.filter (interval ~tells) outcomes) in
  let exhaustive = count Verdict.exhaustive in
  let bounded = count (function Verdict.Holds { bounds = _ :: _; _ } -> true | _ -> false) in
  let fails d = Option.equal Bool.equal (Verdict.everywhere d) (Some false) in
  let violated = count (function Verdict.Violated _ -> true | Depends d -> fails d | _ -> false) in
  let is_number (d : Verdict.dependence) = Option.is_none d.holds in
  let is_known = function Verdict.Measured { reasons = []; _ } -> true | Depends d -> is_number d | _ -> false in
  let undecided = count (function Verdict.Undecided _ -> true | _ -> false) + intervals ~tells:false in
  let part n style text =
    if n = 0 then [] else [ Console.styled console style (Printf.sprintf "%d %s" n text) ]
  in
  let parts =
    part exhaustive Good (if exhaustive = 1 then "holds" else "hold")
    @ part bounded Doubtful (if bounded = 1 then "holds up to the bound" else "hold up to the bound")
    @ part violated Bad "violated"
    @ part (count is_known) Good "measured"
    @ part (intervals ~tells:true) Doubtful "within an interval"
    @ part undecided Doubtful "undecided"
  in
  match verdicts with
  | [] -> "no properties to check\n"
  | _ ->
    Printf.sprintf "%s: %s\n"
      (Scc_base.Plural.count (List.length verdicts) "property" "properties")
      (String.concat ", " parts)
