open Scc_base
open Scc_graph_search
open Scc_explain

type taken = { faults : string list; left_out : Verdict.truncation option }

type t = {
  bounds : Bounds.t;
  within : Limits.attempt;
  mutable faults : string list;  (** the last first *)
  mutable left_out : Limits.stop option;
}

let make bounds within = { bounds; within; faults = []; left_out = None }

let attempt t f =
  let given_up stop =
    if Option.is_none t.left_out then t.left_out <- Some stop;
    None
  in
  match t.within.run Concluding f with
  | Ok x -> Some x
  | Error stop -> given_up stop
  | exception Limits.Over stop -> given_up stop

let run t semantics make =
  let made () =
    let found = make () in
    Option.iter (fun w -> ignore (Witness.there (Witness.semantics semantics w) w)) found;
    found
  in
  match attempt t made with
  | found -> Option.join found
  | exception e when Option.is_some (Bug.broken e) && Option.is_none (Scc_system.Resources.refused e) ->
    Option.iter (fun what -> if not (List.mem what t.faults) then t.faults <- what :: t.faults) (Bug.broken e);
    None

let stopped t stop = Bounds.stopped t.bounds stop

let taken t =
  let taken = { faults = List.rev t.faults; left_out = Option.map (stopped t) t.left_out } in
  t.faults <- [];
  t.left_out <- None;
  taken

let nothing = { faults = []; left_out = None }

let together (a : taken) (b : taken) =
  { faults = a.faults @ b.faults; left_out = (match a.left_out with Some _ -> a.left_out | None -> b.left_out) }
