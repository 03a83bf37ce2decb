open Scc_base
open Scc_exact
open Scc_chance
open Scc_verify
open Scc_estimate

type number = { over : string; low : Rat.t option; high : Rat.t option; infinite : bool }
type estimate = {
  value : Rat.t option;
  from : Rat.t option;
  upto : Rat.t option;
  never : bool;
  approximate : bool;
  runs : int;
}

type check = {
  name : string;
  verdict : string;
  numbers : number list;
  estimate : estimate option;
  reasons : string list;
  stopped : bool;
  faults : string list;
}

type t =
  | Checked of { checks : check list; lattices : Scc_elaborate.Lattices.t list }
  | Refused of { code : string; message : string }

let number (side, (m : Scc_ctl.Eval.measured)) =
  let infinite = match m.least with Answer.Infinite -> true | Exact _ | Within _ | At_least _ -> false in
  let over = match (side : Scc_property.Property.side) with Least -> "least" | Greatest -> "greatest" in
  { over; low = Answer.lower m.least; high = Answer.upper m.most; infinite }

let reasons : Verdict.t -> Verdict.reason list = function
  | Measured { reasons; _ } | Undecided reasons -> reasons
  | Depends _ -> []
  | Holds { bounds; _ } -> List.map (fun b -> Verdict.Truncated b) bounds
  | Violated _ -> []

let check (o : Verdict.outcome) =
  let numbers = match o.verdict with Measured { values; _ } -> List.map number values | _ -> [] in
  {
    name = o.check.name;
    verdict = Scc_reports.Check_json.kind o.verdict;
    numbers;
    estimate = None;
    reasons = List.map Verdict.reason_to_string (reasons o.verdict);
    stopped = Verdict.resources o.verdict;
    faults = o.lost;
  }

let share (t : Tally.t) =
  if t.runs = 0 || Tally.open_ended t > 0 then None else Some (Rat.make (Z.of_int t.yes) (Z.of_int t.runs))

let estimate (a : Estimation.answer) =
  let make value from upto = { value; from; upto; never = false; approximate = false; runs = a.tally.runs } in
  match a.value with
  | Probability (low, high) -> make (share a.tally) (Some low) (Some high)
  | Mean { mean; low; high } -> make mean low high
  | Approximate { mean; low; high } -> { (make (Some mean) (Some low) (Some high)) with approximate = true }
  | Sample { mean; _ } -> make (Some mean) None None
  | Infinite -> { (make None None None) with never = true }
  | Unknown -> make None None None

let of_answer ~stopped (a : Estimation.answer) =
  {
    name = a.path.check.name;
    verdict = Estimate_report.verdict a.verdict;
    numbers = [];
    estimate = Some (estimate a);
    reasons = a.reasons;
    stopped;
    faults = [];
  }

let of_answers ~lattices ~stopped answers = Checked { checks = List.map (of_answer ~stopped) answers; lattices }

let of_outcomes ~lattices list = Checked { checks = List.map check list; lattices }

let of_diagnostics = function
  | [] -> Bug.fail __POS__ "refused without a diagnostic"
  | (d : Diag.t) :: _ -> Refused { code = d.code; message = d.message }

let checks = function Refused _ -> [] | Checked { checks; _ } -> checks
let lattices = function Refused _ -> [] | Checked { lattices; _ } -> lattices
let faults t = List.concat_map (fun c -> c.faults) (checks t)
let is_stopped t = List.exists (fun c -> c.stopped) (checks t)

let is_known = function
  | Refused _ -> false
  | Checked { checks; _ } ->
    let known c =
      match c.verdict with
      | "holds" | "violated" | "estimated_holds" | "estimated_violated" -> true
      | "measured" | "estimated" -> c.reasons = []
      | _ -> false
    in
    List.for_all known checks
