open Scc_exact
open Scc_calculus
open Scc_verify

(* Runs of a sample are not longer for it, nor are there more of them. *)
let of_size (t : Verdict.truncation) =
  match t.limit with
  | States _ | Seconds _ | Memory _ | Interrupted -> true
  | Depth _ | Time _ | Instant _ | Bits _ | Omission _ -> false

let tells (path : Path.t) =
  match (path.question, Path.test path) with
  | Amounts (_, range), _ -> Option.is_some (Range.both range)
  | Does, None -> true
  | Does, Some (_, test) -> Rat.sign test.than > 0 && Rat.compare test.than Rat.one < 0

(* Of two that meet a third one, nothing draws which bounces first. *)
let several_bounce (m : Model.t) =
  let walkers = List.filter (fun (l : Model.leaf) -> Law.draws l.law) (Array.to_list m.leaves) in
  m.blocked = Bounce && List.compare_length_with walkers 1 > 0

let of_outcome model (o : Verdict.outcome) =
  let cured = List.exists of_size (Verdict.truncated o.verdict) && not (Verdict.over_zones o) in
  match Path.of_check model o.check with
  | Ok path when cured && tells path ->
    let ends = match path.horizon with Some _ -> "" | None -> ", if most of them come to where it is known" in
    let free = if several_bounce model then "; with `--free evenly` where walkers bounce off each other" else "" in
    Some
      (Printf.sprintf "`scc estimate --check %s` tells it from many runs, by an interval with a confidence%s%s"
         o.check.name ends free)
  | Ok _ | Error _ -> None
