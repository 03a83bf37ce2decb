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
    match p with
    | Explored { states; _ } when states > 0 ->
      Some (elapsed *. float_of_int (max 0 (n - states)) /. float_of_int states)
    | Explored _ | Valued _ -> None
  in
  let of_seconds s = Some (Float.max 0. (s -. elapsed)) in
  Option.merge Float.min (Option.bind b.states of_states) (Option.bind b.seconds of_seconds)

let done_ ~elapsed : Limits.progress -> string = function
  | Explored { states; waiting; depth; model_time; transitions = _ } ->
    let rate = if elapsed > 0. then float_of_int states /. elapsed else 0. in
    let time t = ", model time " ^ Decimal.significant ~digits:5 t in
    Printf.sprintf "%d states (%.0f/s), %d to expand, depth %d%s" states rate waiting depth
      (Option.fold ~none:"" ~some:time (Lazy.force model_time))
  | Valued { sets; all } -> Printf.sprintf "values of %d of %d sets of states" sets all

let line ~bounds ~elapsed ~heap (p : Limits.progress) =
  let estimate =
    match left bounds ~elapsed p with
    | Some s when elapsed >= 1. -> Printf.sprintf ", at most %s left" (duration s)
    | Some _ | None -> ""
  in
  Printf.sprintf "%s, %d MiB, after %s%s" (done_ ~elapsed p) (heap / Memory.mib) (duration elapsed) estimate

let show ?about console bounds =
  let title = match about with None -> "" | Some name -> name ^ ": " in
  let start = Unix.gettimeofday () in
  let last = ref start and explores = ref true in
  fun p ->
    let now = Unix.gettimeofday () in
    let explored = match p with Limits.Explored _ -> true | Valued _ -> false in
    let begins = (not explored) && !explores in
    explores := explored;
    if begins || now -. !last >= 0.1 then begin
      last := now;
      let heap = Memory.(bytes_of_words (heap_words ())) in
      let show = if begins then Console.phase else Console.progress in
      show console (title ^ line ~bounds ~elapsed:(now -. start) ~heap p)
    end
