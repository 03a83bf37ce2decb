open Scc_exact
open Scc_data

type t = {
  first_choice : Int_array.t;  (** of each state, and the number of choices *)
  first_branch : Int_array.t;  (** of each choice, and the number of branches *)
  target : Int_array.t;
  probability : Rat.t array;
  reward : Rat.t array;
  near : float array;
}

let states m = Int_array.length m.first_choice - 1
let choices m = Int_array.length m.first_branch - 1
let branches m = Int_array.length m.target
let first_choice m s = Int_array.get m.first_choice s
let first_branch m c = Int_array.get m.first_branch c
let target m b = Int_array.get m.target b
let probability m b = m.probability.(b)
let reward m c = m.reward.(c)
let near m = m.near

let with_numbers m ~probability ~reward =
  { m with probability; reward; near = Array.map Rat.to_float probability }

let equal a b =
  let rec all n test = n = 0 || (test (n - 1) && all (n - 1) test) in
  let same count f g = count a = count b && all (count a) (fun i -> g (f a i) (f b i)) in
  same states first_choice Int.equal
  && same choices first_branch Int.equal
  && same branches target Int.equal
  && same branches probability Rat.equal
  && same choices reward Rat.equal

let leads_into m c set =
  let last = first_branch m (c + 1) in
  let rec go b = b < last && (Bits.mem set (target m b) || go (b + 1)) in
  go (first_branch m c)

let stays_in m c set =
  let last = first_branch m (c + 1) in
  let rec go b = b = last || (Bits.mem set (target m b) && go (b + 1)) in
  go (first_branch m c)

let some_branch m c test =
  let last = first_branch m (c + 1) in
  let rec go b = b < last && (test (target m b) || go (b + 1)) in
  go (first_branch m c)

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
  choice_starts : Int_array.buffer;
  branch_starts : Int_array.buffer;
  targets : Int_array.buffer;
  probabilities : Rat.t Growable.t;
  rewards : Rat.t Growable.t;
}

let builder () =
  {
    choice_starts = Int_array.buffer ();
    branch_starts = Int_array.buffer ();
    targets = Int_array.buffer ();
    probabilities = Growable.create ();
    rewards = Growable.create ();
  }

let add_state b =
  Int_array.push b.choice_starts (Int_array.size b.branch_starts);
  Int_array.size b.choice_starts - 1

let rec increasing = function
  | (t, _) :: ((u, _) :: _ as rest) -> (t : int) < u && increasing rest
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
  if Int_array.size b.choice_starts = 0 then Scc_base.Bug.fail __POS__ "a choice of no state";
  Int_array.push b.branch_starts (Int_array.size b.targets);
  Growable.push b.rewards reward;
  List.iter
    (fun (t, p) ->
       (* What is too great for the array is no state in any case. *)
       Int_array.push b.targets (Int.max (-1) (Int.min Int_array.max_value t));
       Growable.push b.probabilities p)
    (merged branches)

exception Wrong of fault

let check_choice m c =
  let n = states m in
  if Rat.sign m.reward.(c) < 0 then raise (Wrong (Negative_reward m.reward.(c)));
  let sum = ref Rat.zero in
  for b = first_branch m c to first_branch m (c + 1) - 1 do
    if target m b < 0 || target m b >= n then raise (Wrong (No_such_target (target m b)));
    if Rat.sign m.probability.(b) <= 0 then raise (Wrong (Not_positive m.probability.(b)));
    sum := Rat.add !sum m.probability.(b)
  done;
  if not (Rat.equal !sum Rat.one) then raise (Wrong (Sum !sum))

let check_state m s =
  let first = first_choice m s and last = first_choice m (s + 1) - 1 in
  let rec go c =
    if c > last then Ok ()
    else match check_choice m c with () -> go (c + 1) | exception Wrong fault -> Error (c - first, fault)
  in
  if last < first then Error (0, No_choice) else go first

let all g = Array.init (Growable.length g) (Growable.get g)

let finish b =
  Int_array.push b.choice_starts (Int_array.size b.branch_starts);
  Int_array.push b.branch_starts (Int_array.size b.targets);
  let probability = all b.probabilities in
  let m =
    {
      first_choice = Int_array.contents b.choice_starts;
      first_branch = Int_array.contents b.branch_starts;
      target = Int_array.contents b.targets;
      probability;
      reward = all b.rewards;
      near = Array.map Rat.to_float probability;
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
