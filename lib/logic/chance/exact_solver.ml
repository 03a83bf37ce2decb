open Scc_exact
open Scc_data

type solution = { value : Rat.t array; row : int array }
type given_up = Lifting.given_up = Interrupted | Too_long | Too_much

exception Given_up of given_up

let better (e : Equations.t) x y =
  match e.direction with Min -> Rat.compare x y < 0 | Max -> Rat.compare x y > 0

let better_float (e : Equations.t) (x : float) y = match e.direction with Min -> x < y | Max -> x > y

type part = { first : int; last : int }

let inside part w = w >= part.first && w <= part.last

let size part = part.last - part.first + 1
let rows_of (e : Equations.t) part = Equations.first_row e (part.last + 1) - Equations.first_row e part.first
let is_chain e part = rows_of e part = size part

(* Gives the nodes of the part, from its borders inwards, rows of theirs by which it is left; whether all got one.
   Rows are those that the nodes have already, or any. *)
let leaving (e : Equations.t) part ~any (row : int array) =
  let settled = Array.make (size part) false and into = Array.make (size part) [] in
  let waiting = Queue.create () in
  let settle v r =
    if not settled.(v - part.first) then begin
      settled.(v - part.first) <- true;
      row.(v) <- r;
      Queue.add v waiting
    end
  in
  let look v r =
    if Bits.mem e.leaks r then settle v r
    else
      for i = Equations.first_entry e r to Equations.first_entry e (r + 1) - 1 do
        let w = Equations.node e i in
        if inside part w then into.(w - part.first) <- (v, r) :: into.(w - part.first)
      done
  in
  for v = part.first to part.last do
    if any then
      for r = Equations.first_row e v to Equations.first_row e (v + 1) - 1 do
        look v r
      done
    else look v row.(v)
  done;
  let rec go () =
    match Queue.take_opt waiting with
    | None -> Array.for_all Fun.id settled
    | Some w ->
      List.iter (fun (v, r) -> settle v r) into.(w - part.first);
      go ()
  in
  go ()

(* What there is to do, and how many steps of it are left. *)
type work = {
  e : Equations.t;
  effort : Effort.t;
  value : Rat.t array;
  near : float array;  (** the floats nearest to the values *)
  row : int array;
  mutable steps : int;
}

let spend w steps =
  w.steps <- w.steps - steps;
  if w.steps < 0 then raise (Given_up Too_much);
  if w.effort.interrupted () then raise (Given_up Interrupted)

(* Sums of long fractions, and their lowest terms, take time with the square of their length. *)
let spend_for w x =
  let words = Rat.bits x / 64 in
  spend w (1 + (words * words))

let set w v x =
  spend_for w x;
  if Rat.bits x > w.effort.bits then raise (Given_up Too_long);
  w.value.(v) <- x;
  w.near.(v) <- Rat.to_float x

let sweeps = 1_000
let small = 0x1p-40

(* A good scheduler, by value iteration in floats from that of [row] on: nothing is proved here. *)
let guess w part =
  let e = w.e and value = w.value and row = w.row in
  let near = Array.make (size part) 0. in
  let base = Array.make (rows_of e part) 0. in
  let first = Equations.first_row e part.first in
  for r = first to Equations.first_row e (part.last + 1) - 1 do
    let known w = if inside part w then Rat.zero else value.(w) in
    base.(r - first) <- Rat.to_float (Equations.row_sum e known r)
  done;
  let sum r =
    let s = ref base.(r - first) in
    for i = Equations.first_entry e r to Equations.first_entry e (r + 1) - 1 do
      if inside part (Equations.node e i) then s := !s +. (e.near.(i) *. near.(Equations.node e i - part.first))
    done;
    !s
  in
  let last = Equations.first_row e (part.last + 1) in
  let entries = Equations.first_entry e last - Equations.first_entry e first in
  let rec go n =
    let change = ref 0. in
    spend w entries;
    for v = part.first to part.last do
      let found = ref (sum row.(v)) in
      for r = Equations.first_row e v to Equations.first_row e (v + 1) - 1 do
        let s = sum r in
        if better_float e s (!found +. (match e.direction with Min -> -.small | Max -> small) *. Float.abs !found)
        then begin
          found := s;
          row.(v) <- r
        end
      done;
      let i = v - part.first in
      change := Float.max !change (Float.abs (!found -. near.(i)) /. Float.max 0x1p-1000 (Float.abs !found));
      near.(i) <- !found
    done;
    if n > 1 && !change > small then go (n - 1)
  in
  go (Int.min sweeps (w.steps / 8 / entries))

(* The values of the scheduler, from those of what the part leads to. *)
let evaluate w part =
  let { e; effort; value; row; _ } = w in
  let { Effort.bits; interrupted; _ } = effort in
  let entries i =
    let r = row.(part.first + i) in
    let rec go k l =
      if k < Equations.first_entry e r then l
      else
        go (k - 1)
          (let w = Equations.node e k in
           if inside part w then (w - part.first, Rat.neg (Equations.probability e k)) :: l else l)
    in
    (i, Rat.one) :: go (Equations.first_entry e (r + 1) - 1) []
  in
  let constant i =
    let known w = if inside part w then Rat.zero else value.(w) in
    let x = Equations.row_sum e known row.(part.first + i) in
    spend_for w x;
    x
  in
  match Lifting.solve ~size:(size part) ~row:entries ~constant ~bits ~steps:w.steps ~interrupted with
  | Error why -> raise (Given_up why)
  | Ok { numerators; denominator; steps } ->
    spend w steps;
    Array.iteri (fun i num -> set w (part.first + i) (Rat.make num denominator)) numerators;
    (numerators, denominator)

(* Whether floats show that a row is no better than the value of its node. A sum of k products of at least 0 has a
   relative error below (k + 4) 2^-53, and so have its terms, but for what is tiny or overflows ({!Rounded}). *)
let clearly_no_better w v r =
  let e = w.e in
  let sum = ref e.near_constant.(r) and x = w.near.(v) in
  let first = Equations.first_entry e r and last = Equations.first_entry e (r + 1) in
  for i = first to last - 1 do
    sum := !sum +. (e.near.(i) *. w.near.(Equations.node e i))
  done;
  let more = 1. +. (float_of_int (last - first + 8) *. 0x1p-52) in
  !sum > 1e-200 && x > 1e-200 && !sum < 1e200 && x < 1e200
  && match e.direction with Min -> !sum > x *. more | Max -> !sum *. more < x

(* How much a row is more than the value of its node, but for a positive denominator: the second number times one
   that is the same for all rows. The values of the part are numbers over one denominator. *)
let gain w part (numerators, denominator) v r =
  let e = w.e in
  let known u = if inside part u then Rat.zero else w.value.(u) in
  let constant : Rat.t = Equations.row_sum e known r in
  let first = Equations.first_entry e r and last = Equations.first_entry e (r + 1) in
  let fold f start =
    let rec go i x =
      if i = last then x
      else go (i + 1) (if inside part (Equations.node e i) then f x i (Equations.probability e i) else x)
    in
    go first start
  in
  let scale = fold (fun l _ (p : Rat.t) -> Z.lcm l p.den) constant.den in
  let times (p : Rat.t) z = Z.mul (Z.mul p.num (Z.divexact scale p.den)) z in
  let add sum i p = Z.add sum (times p numerators.(Equations.node e i - part.first)) in
  let sum = fold add (times constant denominator) in
  (Z.sub sum (Z.mul scale numerators.(v - part.first)), scale)

(* The values of one scheduler decide all changes of a round. *)
let improve w part found =
  let e = w.e in
  let better (x, scale) (y, scale') =
    let c = Z.compare (Z.mul x scale') (Z.mul y scale) in
    match e.direction with Min -> c < 0 | Max -> c > 0
  in
  let best v =
    let best = ref (Z.zero, Z.one) and row = ref w.row.(v) in
    for r = Equations.first_row e v to Equations.first_row e (v + 1) - 1 do
      if (not (Int.equal r w.row.(v))) && not (clearly_no_better w v r) then begin
        spend_for w w.value.(v);
        let gain = gain w part found v r in
        if better gain !best then begin
          best := gain;
          row := r
        end
      end
    done;
    !row
  in
  let next = Array.init (size part) (fun i -> best (part.first + i)) in
  let changed = ref false in
  Array.iteri
    (fun i r ->
       if not (Int.equal r w.row.(part.first + i)) then begin
         changed := true;
         w.row.(part.first + i) <- r
       end)
    next;
  !changed

let solve_part w part =
  let found ok = if not ok then Scc_base.Bug.fail __POS__ "a component that cannot be left" in
  found (leaving w.e part ~any:true w.row);
  if is_chain w.e part then ignore (evaluate w part)
  else begin
    let guessed = Array.sub w.row part.first (size part) in
    guess w part;
    if not (leaving w.e part ~any:false w.row) then Array.blit guessed 0 w.row part.first (size part);
    let rec iterate () =
      let found = evaluate w part in
      if improve w part found then iterate ()
    in
    iterate ()
  end

(* Component by component, each after those that it leads to. *)
let components w ~one ~several =
  let e = w.e in
  let component k =
    if k land 0xfff = 0 && w.effort.interrupted () then raise (Given_up Interrupted);
    let part = { first = e.parts.(k); last = e.parts.(k + 1) - 1 } in
    if size part = 1 then one part.first else several part
  in
  match
    for k = 0 to Array.length e.parts - 2 do
      component k
    done
  with
  | () -> Ok ()
  | exception Given_up why -> Error why

let work (e : Equations.t) (effort : Effort.t) row =
  { e; effort; value = Array.make e.size Rat.zero; near = Array.make e.size 0.; row; steps = effort.steps }

let sum w r =
  let x = Equations.row_sum w.e (Array.get w.value) r in
  spend_for w x;
  x

let solve (e : Equations.t) (effort : Effort.t) =
  let w = work e effort (Array.init e.size (fun v -> Equations.first_row e v)) in
  let one v =
    let best = ref (sum w w.row.(v)) in
    for r = w.row.(v) + 1 to Equations.first_row e (v + 1) - 1 do
      let x = sum w r in
      if better e x !best then begin
        best := x;
        w.row.(v) <- r
      end
    done;
    set w v !best
  in
  Result.map
    (fun () -> { value = w.value; row = w.row })
    (components w ~one ~several:(solve_part w))

let evaluate e effort ~row =
  let w = work e effort row in
  let one v = set w v (sum w row.(v)) in
  Result.map (fun () -> w.value) (components w ~one ~several:(fun part -> ignore (evaluate w part)))
