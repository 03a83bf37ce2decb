open Scc_base
open Scc_exact
open Scc_graph_search

let duration s =
  if s < 100. then Printf.sprintf "%.0f s" s
  else if s < 6000. then Printf.sprintf "%.0f min" (s /. 60.)
  else Printf.sprintf "%.1f h" (s /. 3600.)

(* What is left of the bounds; nothing can be said of those of depth and model time, whose states nobody knows. *)
let left (b : Scc_verdicts.Budget.t) ~elapsed (p : Limits.progress) =
  let of_states n =
    if p.states = 0 then None
    else Some (elapsed *. float_of_int (max 0 (n - p.states)) /. float_of_int p.states)
  in
  let of_seconds s = Some (Float.max 0. (s -. elapsed)) in
  Option.merge Float.min (Option.bind b.states of_states) (Option.bind b.seconds of_seconds)

let line ~bounds ~elapsed ~heap (p : Limits.progress) =
  let rate = if elapsed > 0. then float_of_int p.states /. elapsed else 0. in
  let estimate =
    match left bounds ~elapsed p with
    | Some s when elapsed >= 1. -> Printf.sprintf ", at most %s left" (duration s)
    | Some _ | None -> ""
  in
  Printf.sprintf "%d states (%.0f/s), %d to expand, depth %d, model time %s, %d MiB%s" p.states rate p.waiting
    p.depth (Decimal.significant ~digits:5 p.model_time) (heap / Memory.mib) estimate

let show ?about console bounds =
  let title = match about with None -> "" | Some name -> name ^ ": " in
  let start = Unix.gettimeofday () in
  let last = ref start in
  fun p ->
    let now = Unix.gettimeofday () in
    if now -. !last >= 0.1 then begin
      last := now;
      let heap = Memory.(bytes_of_words (heap_words ())) in
      Console.progress console (title ^ line ~bounds ~elapsed:(now -. start) ~heap p)
    end
