open Scc_semantics
open Scc_verify

type t = Holds | Violated | Undecided | Invalid | Stopped | Usage | Bug | Unwritten

let all = [ Holds; Violated; Undecided; Invalid; Stopped; Usage; Bug; Unwritten ]

let to_int = function
  | Holds -> 0
  | Violated -> 1
  | Undecided -> 2
  | Invalid -> 3
  | Stopped -> 4
  | Usage -> 64
  | Bug -> 70
  | Unwritten -> 74

let equal a b = Int.equal (to_int a) (to_int b)

let meaning = function
  | Holds -> "on success: every property holds, exhaustively or within bounds that the user gave."
  | Violated -> "if some property is violated."
  | Undecided -> "if something is undecided, or holds only up to a default bound that cut the run short."
  | Invalid -> "if the model or another input is invalid."
  | Stopped ->
    "if a limit of time, of memory or of the system (open files, processes), or an interruption, stopped the run."
  | Usage -> "if the command line is wrong."
  | Unwritten -> "if an output could not be written; what else was asked for has been."
  | Bug -> "if scc itself is at fault: the message says what to send."

let rank = function
  | Holds -> 0
  | Undecided -> 1
  | Stopped -> 2
  | Violated -> 3
  | Invalid -> 4
  | Usage -> 5
  | Bug -> 7
  | Unwritten -> 6

let worst codes = List.fold_left (fun w c -> if rank c > rank w then c else w) Holds codes


let of_bounds bounds =
  let known = Verdict.Holds { bounds; witness = None } in
  if Verdict.resources known then Stopped else if Verdict.by_default known then Undecided else Holds

let of_verdict (v : Verdict.t) =
  match v with
  | Violated _ -> Violated
  | Holds { bounds; _ } -> of_bounds bounds
  | Depends d -> if Option.equal Bool.equal (Verdict.everywhere d) (Some false) then Violated else Holds
  | Measured { reasons = []; _ } -> Holds
  | Measured _ | Undecided _ -> if Verdict.resources v then Stopped else Undecided

let of_exploration ~complete ~faults ~stopped_by =
  match faults with
  | _ when complete -> Holds
  | _ :: _ -> Undecided
  | [] -> of_bounds stopped_by

let of_fault : Transition.fault -> t = function
  | Bad_law _ | Bad_chance _ -> Invalid
  | Persistent_contact _ -> Undecided
