open Scc_data

type t = {
  backwards : Backwards.t;
  goals : Bits.t;
  way : Bits.t;  (** of stay, and no goal *)
  zero_min : Bits.t Lazy.t;
}

type directed = { set : Bits.t; choice : Int_array.t }

let backwards q = q.backwards
let mdp q = Backwards.mdp q.backwards
let goal q s = Bits.mem q.goals s
let on_the_way q s = Bits.mem q.way s
let size q = Mdp.states (mdp q)

(* The first choice of a state that passes the test, or -1. *)
let first_of m s test =
  let last = Mdp.first_choice m (s + 1) in
  let rec go c = if c = last then -1 else if test c then c else go (c + 1) in
  go (Mdp.first_choice m s)

(* The complement of a set. *)
let others n set = Bits.init n (fun s -> not (Bits.mem set s))

(* What waits to be looked at is what is in the set already. *)
let worklist n set =
  let found = Worklist.create n in
  for s = 0 to n - 1 do
    if Bits.mem set s then Worklist.add found s
  done;
  found

(* Backwards from a set by choices that are allowed: each state is found by a choice that leads to one that was
   found before. Where passes are slow, breadth first from what they found. *)
let nearer q ~into ~allowed =
  let m = mdp q and n = size q in
  let set = Bits.init n into and choice = Int_array.make n (-1) in
  let found s c =
    Int_array.set choice s c;
    Bits.add set s
  in
  let look s =
    on_the_way q s
    && (not (Bits.mem set s))
    &&
    let c = first_of m s (fun c -> allowed c && Mdp.leads_into m c set) in
    if c >= 0 then found s c;
    c >= 0
  in
  if not (Passes.run ~size:n look) then begin
    let waiting = worklist n set in
    Worklist.run waiting (fun t ->
        Backwards.iter q.backwards t (fun c ->
            let s = Backwards.owner q.backwards c in
            if on_the_way q s && (not (Bits.mem set s)) && allowed c then begin
              found s c;
              Worklist.add waiting s
            end))
  end;
  { set; choice }

let towards q ~into = nearer q ~into ~allowed:(fun _ -> true)
let zero_max q = others (size q) (towards q ~into:(goal q)).set

(* Adds the states on the way of which each choice leads into the set, until there is none; and the choices of
   states on the way that lead into it, to [leading]. In a search backwards a choice counts when its first target
   is found. *)
let attract q set ~leading =
  let m = mdp q and n = size q in
  let leads c =
    Bits.mem leading c
    || Mdp.leads_into m c set
       && begin
         Bits.add leading c;
         true
       end
  in
  let every_one s =
    let all = ref true in
    for c = Mdp.first_choice m s to Mdp.first_choice m (s + 1) - 1 do
      if not (leads c) then all := false
    done;
    !all
  in
  let look s =
    on_the_way q s
    && (not (Bits.mem set s))
    && every_one s
    && begin
      Bits.add set s;
      true
    end
  in
  if not (Passes.run ~size:n look) then begin
    let left = Int_array.make n 0 in
    let add s by = Int_array.set left s (Int_array.get left s + by) in
    for c = 0 to Mdp.choices m - 1 do
      if not (Bits.mem leading c) then add (Backwards.owner q.backwards c) 1
    done;
    let waiting = worklist n set in
    Worklist.run waiting (fun t ->
        Backwards.iter q.backwards t (fun c ->
            let s = Backwards.owner q.backwards c in
            if on_the_way q s && not (Bits.mem leading c) then begin
              Bits.add leading c;
              add s (-1);
              if Int_array.get left s = 0 && not (Bits.mem set s) then begin
                Bits.add set s;
                Worklist.add waiting s
              end
            end))
  end

let until backwards ~stay ~goal =
  let n = Mdp.states (Backwards.mdp backwards) in
  let goals = Bits.init n goal in
  let way = Bits.init n (fun s -> (not (Bits.mem goals s)) && stay s) in
  let rec q = { backwards; goals; way; zero_min = lazy (zero_min ()) }
  (* Outside are the states from which every scheduler leads to goal with positive probability. *)
  and zero_min () =
    let found = Bits.init n (Bits.mem goals) in
    attract q found ~leading:(Bits.create (Mdp.choices (mdp q)));
    others n found
  in
  q

let zero_min q = Lazy.force q.zero_min

let avoiding q =
  let m = mdp q and n = size q in
  let set = zero_min q in
  let choice = Int_array.make n (-1) in
  for s = 0 to n - 1 do
    if Bits.mem set s && on_the_way q s then begin
      let c = first_of m s (fun c -> Mdp.stays_in m c set) in
      if c < 0 then Scc_base.Bug.fail __POS__ "no choice avoids the goal";
      Int_array.set choice s c
    end
  done;
  { set; choice }

(* The greatest set from which goal is reached through the set by choices that do not leave it. What cannot reach
   goal so leaves, with what has no choice left; until nothing leaves. *)
let surely q =
  let n = size q in
  let dead = Bits.create (Mdp.choices (mdp q)) and gone = Bits.create n in
  let rec rounds () =
    let reached = nearer q ~into:(goal q) ~allowed:(fun c -> not (Bits.mem dead c)) in
    let left = ref false in
    for s = 0 to n - 1 do
      if not (Bits.mem reached.set s || Bits.mem gone s) then begin
        left := true;
        Bits.add gone s
      end
    done;
    if !left then begin
      attract q gone ~leading:dead;
      rounds ()
    end
    else reached
  in
  rounds ()

let one_max q = (surely q).set

let one_min q =
  let zero = zero_min q in
  others (size q) (towards q ~into:(Bits.mem zero)).set
