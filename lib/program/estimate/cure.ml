open Scc_exact
open Scc_calculus
open Scc_verify

(* Runs of a sample are not longer for it, nor are there more of them. *)
let of_size (t : Verdict.truncation) =
  match t.limit with
  | States _ | Draws _ | Seconds _ | Memory _ | Interrupted -> true
  | Depth _ | Time _ | Instant _ | Bits _ | Omission _ -> false

(* What an estimate tells. *)
type told = Interval | Lower_end | Upper_end | Only_within_bounds

let tells (path : Path.t) =
  match (path.question, Path.test path) with
  | Does, Some (_, test) when Rat.sign test.than <= 0 || Rat.compare test.than Rat.one >= 0 -> None
  | Does, _ -> Some Interval
  | Amounts (_, { low = Some _; high = Some _; _ }), _ -> Some Interval
  | Amounts (_, { low = Some _; high = None; _ }), _ -> Some Lower_end
  | Amounts (_, { low = None; high = Some _; _ }), _ -> Some Upper_end
  | Amounts (_, { low = None; high = None; _ }), _ -> Some Only_within_bounds

let within_bounds =
  "`E = ? [ max(-a, min(f, a)) at T ]` has an interval by `scc estimate`, for its number f and a bound a that you \
   choose"

(* Of two that meet a third one, nothing draws which bounces first. *)
let several_bounce (m : Model.t) =
  let walkers = List.filter (fun (l : Model.leaf) -> Law.draws l.law) (Array.to_list m.leaves) in
  m.blocked = Bounce && List.compare_length_with walkers 1 > 0

(* With a value for each parameter that has but a range: an estimate is of one start, and of one model. *)
let of_path model ~parameter (path : Path.t) =
  let ends = match path.horizon with Some _ -> "" | None -> ", if most of them come to where it is known" in
  let free = if several_bounce model then "; with `--free evenly` where walkers bounce off each other" else "" in
  let ranges = List.map (fun (r : Ranges.range) -> r.name) (Array.to_list model.ranges) in
  let unknown = Option.to_list parameter @ ranges in
  let given = String.concat "" (List.map (Printf.sprintf " -D %s=VALUE") unknown) in
  let there = match unknown with [] -> "" | [ _ ] -> ", for that value" | _ -> ", for these values" in
  let by_runs what =
    Printf.sprintf "`scc estimate --check %s%s` tells %s%s%s%s" path.check.name given what there ends free
  in
  match tells path with
  | None -> None
  | Some Interval -> Some (by_runs "it from many runs, by an interval with a confidence")
  | Some Lower_end -> Some (by_runs "from many runs what it is at least, with a confidence")
  | Some Upper_end -> Some (by_runs "from many runs what it is at most, with a confidence")
  | Some Only_within_bounds -> Some within_bounds

let of_outcome model ~parameter ~from (o : Verdict.outcome) =
  if not (List.exists of_size (Verdict.truncated o.verdict)) then None
  else
    match Path.of_check ~from model o.check with
    | Ok path -> of_path model ~parameter path
    | Error _ -> None
