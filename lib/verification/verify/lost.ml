open Scc_base
open Scc_explain

type t = { mutable faults : string list  (** the last first *) }

let make () = { faults = [] }

let run t semantics make =
  let made () =
    let found = make () in
    Option.iter (fun w -> ignore (Witness.there (Witness.semantics semantics w) w)) found;
    found
  in
  match made () with
  | found -> found
  | exception e when Option.is_some (Bug.broken e) ->
    Option.iter (fun what -> if not (List.mem what t.faults) then t.faults <- what :: t.faults) (Bug.broken e);
    None

let taken t =
  let faults = List.rev t.faults in
  t.faults <- [];
  faults
