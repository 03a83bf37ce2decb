open Scc_data

type t = { backwards : Backwards.t; stay : int -> bool; goal : int -> bool }

let until backwards ~stay ~goal = { backwards; stay; goal }
let backwards q = q.backwards
let mdp q = Backwards.mdp q.backwards
let goal q = q.goal
let on_the_way q s = q.stay s && not (q.goal s)

type directed = { set : Bits.t; choice : int array }

let size q = Mdp.states (mdp q)

(* Breadth first, backwards from a set by choices that are allowed: each state is found by a choice that leads to
   one that was found before. *)
let nearer q ~into ~allowed =
  let n = size q in
  let set = Worklist.create n and choice = Array.make n (-1) in
  for s = 0 to n - 1 do
    if into s then Worklist.add set s
  done;
  Worklist.run set (fun t ->
      Backwards.iter q.backwards t (fun c ->
          let s = Backwards.owner q.backwards c in
          if on_the_way q s && (not (Worklist.mem set s)) && allowed c then begin
            choice.(s) <- c;
            Worklist.add set s
          end));
  (set, choice)

let towards q ~into =
  let set, choice = nearer q ~into ~allowed:(fun _ -> true) in
  { set = Bits.init (size q) (Worklist.mem set); choice }

let zero_max q =
  let reached = (towards q ~into:q.goal).set in
  Bits.init (size q) (fun s -> not (Bits.mem reached s))

let choices_of m s = Mdp.first_choice m (s + 1) - Mdp.first_choice m s

(* The states from which every scheduler leads into the set of goals with positive probability: on the way, and
   each choice leads to one of them. A choice counts when its first target is found. *)
let zero_min q =
  let m = mdp q in
  let n = size q in
  let leading = Bits.create (Mdp.choices m) in
  let others = Array.init n (choices_of m) in
  let found = Worklist.create n in
  for s = 0 to n - 1 do
    if q.goal s then Worklist.add found s
  done;
  Worklist.run found (fun t ->
      Backwards.iter q.backwards t (fun c ->
          let s = Backwards.owner q.backwards c in
          if on_the_way q s && not (Bits.mem leading c) then begin
            Bits.add leading c;
            others.(s) <- others.(s) - 1;
            if others.(s) = 0 then Worklist.add found s
          end));
  Bits.init n (fun s -> not (Worklist.mem found s))

let avoiding q =
  let m = mdp q in
  let set = zero_min q in
  let staying s =
    let last = Mdp.first_choice m (s + 1) in
    let rec go c =
      if c = last then Scc_base.Bug.fail __POS__ "no choice avoids the goal"
      else if Mdp.every_branch m c (Bits.mem set) then c
      else go (c + 1)
    in
    go (Mdp.first_choice m s)
  in
  { set; choice = Array.init (size q) (fun s -> if Bits.mem set s && on_the_way q s then staying s else -1) }

(* The greatest set from which goal is reached through the set by choices that do not leave it. What cannot reach
   goal so leaves, with what has no choice left; until nothing leaves. *)
let surely q =
  let m = mdp q in
  let n = size q in
  let dead = Bits.create (Mdp.choices m) and gone = Worklist.create n in
  let others = Array.init n (choices_of m) in
  let rec rounds () =
    let reached, choice =
      nearer q ~into:(fun s -> q.goal s) ~allowed:(fun c -> not (Bits.mem dead c))
    in
    let left = ref false in
    for s = 0 to n - 1 do
      if not (Worklist.mem reached s || Worklist.mem gone s) then begin
        left := true;
        Worklist.add gone s
      end
    done;
    if !left then begin
      Worklist.run gone (fun t ->
          Backwards.iter q.backwards t (fun c ->
              let s = Backwards.owner q.backwards c in
              if on_the_way q s && not (Bits.mem dead c) then begin
                Bits.add dead c;
                others.(s) <- others.(s) - 1;
                if others.(s) = 0 then Worklist.add gone s
              end));
      rounds ()
    end
    else { set = Bits.init n (Worklist.mem reached); choice }
  in
  rounds ()

let one_max q = (surely q).set

let one_min q =
  let zero = zero_min q in
  let below = (towards q ~into:(Bits.mem zero)).set in
  Bits.init (size q) (fun s -> not (Bits.mem below s))
