open Scc_calculus
open Scc_semantics

type t = { states : int; expanded : int; complete : bool; bound : int }

(* Between all states: processes take most of the space. *)
let most_processes = 40_000

let bound (m : Model.t) most = Int.min most (Int.max 1 (most_processes / Int.max 1 (Array.length m.leaves)))

let look states world ~most (n, state) =
  let semantics = States.semantics world in
  match Network.successors semantics state with
  | Error fault ->
    States.set_stuck states n (Transition.diagnostic (Semantics.model semantics) fault).message;
    States.set_next states n [];
    States.set_extent world n state Instant;
    []
  | Ok transitions ->
    States.set_extent world n state (Scc_evaluate.Trajectory.extent semantics state transitions);
    if transitions = [] && Network.quiescent semantics state then States.set_rests states n;
    let one (found, possible) (t : Transition.t) =
      let known = States.known world t.target in
      let is_new = Option.is_none known && States.count states < most in
      let target =
        if is_new then Some (States.after world (n, state) (Transition.duration t) t.target) else known
      in
      let found = match target with Some k when is_new -> (k, t.target) :: found | _ -> found in
      let label = States.label world t.label in
      (found, { States.label; rules = t.rules; target; chance = t.chance } :: possible)
    in
    let found, possible = List.fold_left one ([], []) transitions in
    States.set_next states n (List.rev possible);
    List.rev found

let expand states world ~most (n, state) =
  if States.has_next states n || States.too_long world state then [] else look states world ~most (n, state)

let reach states world ~most (n, state) =
  if not (States.told states n) then ignore (look states world ~most (n, state))

let explore states world ~most ~interrupted initial =
  let most = bound (Semantics.model (States.semantics world)) most in
  let start = States.start world initial in
  let queue = Queue.create () in
  Queue.add (start, initial) queue;
  let expanded = ref 0 in
  while (not (Queue.is_empty queue)) && not (interrupted ()) do
    List.iter (fun s -> Queue.add s queue) (expand states world ~most (Queue.take queue));
    incr expanded
  done;
  let complete = Queue.is_empty queue && States.all_told states in
  { states = States.count states; expanded = !expanded; complete; bound = most }
