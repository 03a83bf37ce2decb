open Scc_exact
module Growable = Scc_data.Growable

type t = {
  first_choice : int array;  (** of each state, and the number of choices *)
  first_branch : int array;  (** of each choice, and the number of branches *)
  target : int array;
  probability : Rat.t array;
  reward : Rat.t array;
  near : float array Lazy.t;
}

let states m = Array.length m.first_choice - 1
let choices m = Array.length m.first_branch - 1
let branches m = Array.length m.target
let first_choice m s = m.first_choice.(s)
let first_branch m c = m.first_branch.(c)
let target m b = m.target.(b)
let probability m b = m.probability.(b)
let reward m c = m.reward.(c)
let near m = Lazy.force m.near

let some_branch m c test =
  let last = m.first_branch.(c + 1) in
  let rec go b = b < last && (test m.target.(b) || go (b + 1)) in
  go m.first_branch.(c)

let every_branch m c test = not (some_branch m c (fun t -> not (test t)))

type fault =
  | No_choice
  | No_such_target of int
  | Not_positive of Rat.t
  | Sum of Rat.t
  | Negative_reward of Rat.t

type error = { state : int; choice : int; fault : fault }

let describe e =
  let choice = Printf.sprintf "choice %d of state %d" e.choice e.state in
  match e.fault with
  | No_choice -> Printf.sprintf "state %d has no choice" e.state
  | No_such_target t -> Printf.sprintf "%s leads to state %d, which does not exist" choice t
  | Not_positive p -> Printf.sprintf "%s has the probability %s, which is not positive" choice (Rat.to_string p)
  | Sum p -> Printf.sprintf "the probabilities of %s have the sum %s, which is not 1" choice (Rat.to_string p)
  | Negative_reward r -> Printf.sprintf "%s has the negative reward %s" choice (Rat.to_string r)

type builder = {
  choice_starts : int Growable.t;
  branch_starts : int Growable.t;
  targets : int Growable.t;
  probabilities : Rat.t Growable.t;
  rewards : Rat.t Growable.t;
}

let builder () =
  {
    choice_starts = Growable.create ();
    branch_starts = Growable.create ();
    targets = Growable.create ();
    probabilities = Growable.create ();
    rewards = Growable.create ();
  }

let add_state b =
  Growable.push b.choice_starts (Growable.length b.branch_starts);
  Growable.length b.choice_starts - 1

let rec increasing = function
  | (t, _) :: ((u, _) :: _ as rest) -> t < u && increasing rest
  | [] | [ _ ] -> true

(* Each target once; what is not positive stays, to be told. *)
let merged branches =
  if increasing branches then branches
  else
    let sorted = List.stable_sort (fun (t, _) (u, _) -> Int.compare t u) branches in
    List.rev
      (List.fold_left
         (fun done_ (t, p) ->
            match done_ with
            | (u, q) :: rest when Int.equal t u && Rat.sign p > 0 && Rat.sign q > 0 -> (u, Rat.add q p) :: rest
            | _ -> (t, p) :: done_)
         [] sorted)

let add_choice b ?(reward = Rat.zero) branches =
  if Growable.length b.choice_starts = 0 then Scc_base.Bug.fail __POS__ "a choice of no state";
  Growable.push b.branch_starts (Growable.length b.targets);
  Growable.push b.rewards reward;
  List.iter
    (fun (t, p) ->
       Growable.push b.targets t;
       Growable.push b.probabilities p)
    (merged branches)

exception Wrong of fault

let check_choice m c =
  let n = states m in
  if Rat.sign m.reward.(c) < 0 then raise (Wrong (Negative_reward m.reward.(c)));
  let sum = ref Rat.zero in
  for b = m.first_branch.(c) to m.first_branch.(c + 1) - 1 do
    if m.target.(b) < 0 || m.target.(b) >= n then raise (Wrong (No_such_target m.target.(b)));
    if Rat.sign m.probability.(b) <= 0 then raise (Wrong (Not_positive m.probability.(b)));
    sum := Rat.add !sum m.probability.(b)
  done;
  if not (Rat.equal !sum Rat.one) then raise (Wrong (Sum !sum))

let check_state m s =
  let first = m.first_choice.(s) and last = m.first_choice.(s + 1) - 1 in
  let rec go c =
    if c > last then Ok ()
    else match check_choice m c with () -> go (c + 1) | exception Wrong fault -> Error (c - first, fault)
  in
  if last < first then Error (0, No_choice) else go first

let array g last =
  let n = Growable.length g in
  Array.init (n + 1) (fun i -> if i = n then last else Growable.get g i)

let finish b =
  let all g = Array.init (Growable.length g) (Growable.get g) in
  let probability = all b.probabilities in
  let m =
    {
      first_choice = array b.choice_starts (Growable.length b.branch_starts);
      first_branch = array b.branch_starts (Growable.length b.targets);
      target = all b.targets;
      probability;
      reward = all b.rewards;
      near = lazy (Array.map Rat.to_float probability);
    }
  in
  let rec check s =
    if s = states m then Ok m
    else
      match check_state m s with
      | Ok () -> check (s + 1)
      | Error (choice, fault) -> Error { state = s; choice; fault }
  in
  check 0
