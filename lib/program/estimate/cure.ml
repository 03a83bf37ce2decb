open Scc_exact
open Scc_verify

(* Runs of a sample are not longer for it, nor are there more of them. *)
let of_size (t : Verdict.truncation) =
  match t.limit with
  | States _ | Seconds _ | Memory _ | Interrupted -> true
  | Depth _ | Time _ | Instant _ | Bits _ | Omission _ -> false

let tells (path : Path.t) =
  match (path.question, Path.test path) with
  | Amounts (_, range), _ -> Option.is_some range
  | Does, None -> true
  | Does, Some (_, test) -> Rat.sign test.than > 0 && Rat.compare test.than Rat.one < 0

let of_outcome model (o : Verdict.outcome) =
  let cured = List.exists of_size (Verdict.truncated o.verdict) && not (Verdict.over_zones o) in
  match Path.of_check model o.check with
  | Ok path when cured && tells path ->
    let ends = match path.horizon with Some _ -> "" | None -> ", if most of them come to where it is known" in
    Some
      (Printf.sprintf "`scc estimate --check %s` tells it from many runs, by an interval with a confidence%s"
         o.check.name ends)
  | Ok _ | Error _ -> None
