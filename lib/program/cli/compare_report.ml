open Scc_verify
open Scc_equivalence

type t = {
  relation : Compare.relation;
  first : Compared.t;
  second : Compared.t;
  report : Compare.report;
  exit : Scc_verdicts.Exit_code.t;
}

let relations =
  [
    ("trace", Compare.Trace);
    ("weak", Weak);
    ("branching", Branching);
    ("strong", Strong);
    ("timed", Timed);
  ]

let name relation = fst (List.find (fun (_, r) -> r = relation) relations)

(* A trace of more steps is shown in part. *)
let shown_steps = 60

(* Longer formulas are no help to a person. *)
let most_printed = 200

(* Nor to a program. *)
let most_written = 100_000

let reason_text : Compare.reason -> string = function
  | Unknown_states -> "no difference within what is known; it may lie in what was not explored"
  | Effort_spent -> "a limit of seconds or memory, or an interruption, ended the comparison"
  | Too_many_sets ->
    Printf.sprintf
      "more than %d pairs of sets of states, or sets of %d states altogether, would have to be compared"
      Traces.to_decide.pairs Traces.to_decide.members
  | Too_many_pairs ->
    Printf.sprintf "more than %d pairs of states would have to be compared" Game.most_pairs

(* Two files of one name are told apart. *)
let title t first =
  let own = Scc_base.Visible.line (if first then t.first.path else t.second.path) in
  if not (String.equal t.first.path t.second.path) then own
  else if first then "the first " ^ own
  else "the second " ^ own

let limits (c : Compared.t) =
  if c.complete then "complete"
  else
    match Verdict.distinct (Compared.stopped_by c) with
    | [] -> "not complete"
    | bounds ->
      "not complete: stopped by " ^ String.concat ", " (List.map Verdict.truncation_to_string bounds)

let scale (c : Compared.t) : Verdict.scale =
  match c.source with
  | File -> { resolution = None; split_step = None; over = None }
  | Model { model; space } ->
    { resolution = Scc_calculus.Model.resolution model.model; split_step = space.split_step; over = None }

let settings (c : Compared.t) =
  match c.source with
  | File -> ""
  | Model { model; _ } -> "\n  " ^ Scc_calculus.Parameters.line model.origin.settings

let side_text t first =
  let c = if first then t.first else t.second in
  let s = if first then t.report.first else t.report.second in
  let states, transitions = Compared.size c in
  let classes =
    match s.classes with
    | Some n -> Printf.sprintf ", %s" (Scc_base.Plural.count n "class" "classes")
    | None -> ""
  in
  Printf.sprintf "%s: %s, %s%s; %s%s\n" (title t first)
    (Scc_base.Plural.count states "state" "states")
    (Scc_base.Plural.count transitions "transition" "transitions")
    classes (limits c)
    (Verdict.scale_to_string (scale c) ^ settings c)

let indented lines = String.concat "" (List.map (fun l -> "    " ^ l ^ "\n") lines)

let numbered labels =
  let lines = List.mapi (fun i l -> Printf.sprintf "%d. %s" (i + 1) l) labels in
  let n = List.length lines in
  if n <= shown_steps then lines
  else
    let head = List.filteri (fun i _ -> i < shown_steps / 2) lines in
    let tail = List.filteri (fun i _ -> i >= n - (shown_steps / 2)) lines in
    head @ (Printf.sprintf "… %d more …" (n - shown_steps) :: tail)

let trace_text t (d : Compare.difference) =
  match d.trace with
  | Some (labels, first) ->
    Printf.sprintf "  %s can do this, and %s cannot:\n%s" (title t first)
      (title t (not first))
      (indented (numbered labels))
  | None when d.trace_open -> "  whether their traces differ is not known\n"
  | None -> "  their traces are the same\n"

let formula_text t (d : Compare.difference) =
  match d.formula with
  | None -> "  a formula that tells them apart is too large, or too hard to find\n"
  | Some f when Modal_formula.size f > most_printed ->
    Printf.sprintf "  a formula of %s tells them apart%s\n"
      (Scc_base.Plural.count (Modal_formula.size f) "operator" "operators")
      (if Modal_formula.size f <= most_written then ": see --json" else "")
  | Some f ->
    Printf.sprintf "  this is true of %s, and not of %s:\n%s" (title t true) (title t false)
      (indented [ t.report.show f ])

(* What equivalence does not promise: that two models may stand for each other in a network. *)
let proviso t =
  match (t.first.source, t.second.source) with
  | Model _, Model _ -> "  as labels tell it, which know no places: beside a third body the two may differ\n"
  | File, _ | _, File -> ""

let text console t =
  let relation = name t.relation in
  let verdict, why =
    match t.report.verdict with
    | Equivalent -> (Console.styled console Good "equivalent" ^ " modulo " ^ relation ^ "\n", proviso t)
    | Different d ->
      ( Console.styled console Bad "not equivalent" ^ " modulo " ^ relation ^ "\n",
        trace_text t d ^ formula_text t d )
    | Undecided reason ->
      ( Console.styled console Doubtful "undecided" ^ " modulo " ^ relation ^ ": " ^ reason_text reason ^ "\n",
        "" )
  in
  verdict ^ why ^ side_text t true ^ side_text t false
