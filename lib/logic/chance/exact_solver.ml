open Scc_exact
open Scc_data

type solution = { value : Rat.t array; row : int array }
type given_up = Component of int | Elimination of Elimination.given_up

exception Given_up of given_up

let greatest_component (e : Equations.t) =
  let greatest = ref 0 in
  for k = 0 to Array.length e.parts - 2 do
    greatest := Int.max !greatest (e.parts.(k + 1) - e.parts.(k))
  done;
  !greatest

let better (e : Equations.t) x y =
  match e.direction with Min -> Rat.compare x y < 0 | Max -> Rat.compare x y > 0

let better_float (e : Equations.t) (x : float) y = match e.direction with Min -> x < y | Max -> x > y

(* The best row of a node for some values; the one that is given, unless another is better. *)
let best (e : Equations.t) value v row =
  let found = ref row and sum = ref (Equations.row_sum e value row) in
  for r = Equations.first_row e v to Equations.first_row e (v + 1) - 1 do
    if not (Int.equal r row) then begin
      let s = Equations.row_sum e value r in
      if better e s !sum then begin
        found := r;
        sum := s
      end
    end
  done;
  (!found, !sum)

type part = { first : int; last : int }

let inside part w = w >= part.first && w <= part.last

let leads (e : Equations.t) part r test =
  let rec go i =
    i < Equations.first_entry e (r + 1)
    && ((inside part (Equations.node e i) && test (Equations.node e i)) || go (i + 1))
  in
  go (Equations.first_entry e r)

(* Gives the nodes of the part, one after the other, rows of theirs by which it is left; whether all got one. Rows
   are taken among those that the nodes have already, or any. The passes go down and up by turns, and are few as a
   rule. *)
let leaving (e : Equations.t) part ~any (row : int array) =
  let settled = Array.make (part.last - part.first + 1) false in
  let is_settled v = settled.(v - part.first) in
  let good r = Bits.mem e.leaks r || leads e part r is_settled in
  let look v =
    if is_settled v then false
    else begin
      let rec go r = if r = Equations.first_row e (v + 1) then -1 else if good r then r else go (r + 1) in
      let r = if any then go (Equations.first_row e v) else if good row.(v) then row.(v) else -1 in
      if r >= 0 then begin
        row.(v) <- r;
        settled.(v - part.first) <- true
      end;
      r >= 0
    end
  in
  let rec passes () =
    let more = ref false in
    for v = part.first to part.last do
      if look v then more := true
    done;
    for v = part.last downto part.first do
      if look v then more := true
    done;
    if !more then passes ()
  in
  passes ();
  Array.for_all Fun.id settled

let sweeps = 1_000
let small = 0x1p-40

(* A good scheduler, by value iteration in floats from that of [row] on: nothing is proved here. *)
let guess (e : Equations.t) part value (row : int array) =
  let near = Array.make (part.last - part.first + 1) 0. in
  let base = Array.make (Equations.first_row e (part.last + 1) - (Equations.first_row e part.first)) 0. in
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
  let rec go n =
    let change = ref 0. in
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
  go sweeps

let evaluate (e : Equations.t) (effort : Effort.t) part (value : Rat.t array) (row : int array) =
  let size = part.last - part.first + 1 in
  let entries i =
    let r = row.(part.first + i) in
    let rec go k l =
      if k < Equations.first_entry e r then l
      else
        go (k - 1)
          (let w = Equations.node e k in
           if inside part w then (w - part.first, Equations.probability e k) :: l else l)
    in
    go (Equations.first_entry e (r + 1) - 1) []
  in
  let constant i =
    let known w = if inside part w then Rat.zero else value.(w) in
    Equations.row_sum e known row.(part.first + i)
  in
  match
    Elimination.solve ~size ~row:entries ~constant ~bits:effort.bits ~interrupted:effort.interrupted
  with
  | Ok x -> Array.blit x 0 value part.first size
  | Error why -> raise (Given_up (Elimination why))

(* The values of one scheduler decide all changes of a round. *)
let improve e part value (row : int array) =
  let at = Array.get value in
  let changed = ref false in
  let next =
    Array.init (part.last - part.first + 1) (fun i ->
        let v = part.first + i in
        if Equations.first_row e (v + 1) - Equations.first_row e v = 1 then row.(v) else fst (best e at v row.(v)))
  in
  Array.iteri
    (fun i r ->
       if not (Int.equal r row.(part.first + i)) then begin
         changed := true;
         row.(part.first + i) <- r
       end)
    next;
  !changed

let solve_part (e : Equations.t) effort part value (row : int array) =
  let found ok = if not ok then Scc_base.Bug.fail __POS__ "a component that cannot be left" in
  found (leaving e part ~any:true row);
  let guessed = Array.copy (Array.sub row part.first (part.last - part.first + 1)) in
  guess e part value row;
  if not (leaving e part ~any:false row) then Array.blit guessed 0 row part.first (Array.length guessed);
  let rec iterate () =
    evaluate e effort part value row;
    if improve e part value row then iterate ()
  in
  iterate ()

let solve (e : Equations.t) (effort : Effort.t) =
  let value = Array.make e.size Rat.zero in
  let row = Array.init e.size (fun v -> Equations.first_row e v) in
  let at = Array.get value in
  let one v =
    let r, x = best e at v row.(v) in
    if Rat.bits x > effort.bits then raise (Given_up (Elimination Too_long));
    row.(v) <- r;
    value.(v) <- x
  in
  let component k =
    if k land 0xfff = 0 && effort.interrupted () then raise (Given_up (Elimination Interrupted));
    let part = { first = e.parts.(k); last = e.parts.(k + 1) - 1 } in
    let size = part.last - part.first + 1 in
    if size = 1 then one part.first
    else if size > effort.component then raise (Given_up (Component size))
    else solve_part e effort part value row
  in
  match
    for k = 0 to Array.length e.parts - 2 do
      component k
    done
  with
  | () -> Ok { value; row }
  | exception Given_up why -> Error why
