open Scc_calculus
open Scc_semantics

let standard = Scc_engine.Standard.of_model

module Seen = Hashtbl.Make (struct
    type t = State.t

    let equal = State.equal
    let hash = State.hash
  end)

let ok m = function
  | Ok x -> x
  | Error fault -> failwith (Transition.diagnostic m fault).message

let initial m declared = ok m (Network.initial (standard m) declared)

(* None in a dead end. *)
let successors m s =
  match Network.successors (standard m) s with
  | Error (Persistent_contact _) -> []
  | result -> ok m result

let states m start ~limit =
  let seen = Seen.create 64 and queue = Queue.create () in
  let add s =
    if Seen.length seen < limit && not (Seen.mem seen s) then begin
      Seen.add seen s ();
      Queue.add s queue
    end
  in
  add start;
  let rec go found =
    match Queue.take_opt queue with
    | None -> List.rev found
    | Some s ->
      let transitions = successors m s in
      List.iter (fun (t : Transition.t) -> add t.target) transitions;
      go ((s, transitions) :: found)
  in
  go []

let follow semantics s choices =
  let rec go s place acc = function
    | [] -> Ok (List.rev acc)
    | choice :: rest -> (
        match Network.successors semantics s with
        | Error _ -> Error place
        | Ok list -> (
            match if choice < 0 then None else List.nth_opt list choice with
            | None -> Error place
            | Some t -> go t.Transition.target (place + 1) (t :: acc) rest))
  in
  go s 0 [] choices
