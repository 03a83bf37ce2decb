open Scc_geometry
open Scc_broad_phase
module Pairs = Map.Make (Int)

(* By slots. A slot whose number is -1 has not been looked at. *)
type t = {
  local : Local.t;
  numbers : int array;
  alone : Local.alone array;
  velocities : int array;  (** their numbers; -1 of nobody *)
  acts : Bytes.t;  (** not 0 of who can do something by itself *)
  seen : Local.alone array;  (** those of whom it is known who is near them *)
  unseen : bool array;  (** where these two differ *)
  hull : float array;  (** six numbers for each: of a box about all boxes of the process *)
  near : int list array;  (** those a box of which meets one of its boxes *)
  mutable waiting : int list;  (** the unseen *)
  mutable colliding : Local.move list Pairs.t;  (** by the slots of the two *)
  mutable whole : bool;  (** no work at it was given up on the way *)
}

let create local =
  let n = Array.length (Catalogue.model (Local.catalogue local)).leaves in
  {
    local;
    numbers = Array.make n (-1);
    alone = Array.make n (Local.nobody local);
    velocities = Array.make n (-1);
    acts = Bytes.make n '\000';
    seen = Array.make n (Local.nobody local);
    unseen = Array.make n false;
    waiting = [];
    hull = Array.make (6 * n) Float.nan;
    near = Array.make n [];
    colliding = Pairs.empty;
    whole = false;
  }

let slots t = Array.length t.numbers
let pair t i j = if i < j then (i * slots t) + j else (j * slots t) + i

(* {1 Who is near whom} *)

let boxes t i = t.alone.(i).Local.boxes

let set_hull t i =
  if Array.length (boxes t i) > 0 then begin
    let hull = Float_box.hull (boxes t i) in
    for axis = 0 to 2 do
      t.hull.((6 * i) + axis) <- Float_box.low hull axis;
      t.hull.((6 * i) + axis + 3) <- Float_box.high hull axis
    done
  end
  else Array.fill t.hull (6 * i) 6 Float.nan

let hulls_meet (h : float array) i j =
  let i = 6 * i and j = 6 * j in
  h.(i) <= h.(j + 3)
  && h.(j) <= h.(i + 3)
  && h.(i + 1) <= h.(j + 4)
  && h.(j + 1) <= h.(i + 4)
  && h.(i + 2) <= h.(j + 5)
  && h.(j + 2) <= h.(i + 5)

let some_meet some others = Array.exists (fun a -> Array.exists (Float_box.meet a) others) some

let near_to t i =
  let mine = boxes t i in
  let rec from j found =
    if j < 0 then found
    else from (j - 1) (if j <> i && hulls_meet t.hull i j && some_meet mine (boxes t j) then j :: found else found)
  in
  if Array.length mine = 0 then [] else from (slots t - 1) []

let forget t i = List.iter (fun j -> t.near.(j) <- List.filter (fun k -> k <> i) t.near.(j)) t.near.(i)

let find_again t i =
  forget t i;
  t.near.(i) <- near_to t i;
  List.iter (fun j -> if not (List.mem i t.near.(j)) then t.near.(j) <- i :: t.near.(j)) t.near.(i)

let find_all t =
  let owned i = Array.map (fun box -> (i, box)) (boxes t i) in
  let all = Array.concat (List.init (slots t) owned) in
  Array.fill t.near 0 (slots t) [];
  let meet (k, l) =
    let i = fst all.(k) and j = fst all.(l) in
    if i <> j && not (List.mem j t.near.(i)) then begin
      t.near.(i) <- j :: t.near.(i);
      t.near.(j) <- i :: t.near.(j)
    end
  in
  List.iter meet (Boxes.pairs (Array.map snd all))

(* {1 Looking} *)

(* Nobody has no place and no form, whatever numbers stand for them. *)
let has_moved (a : Local.alone) (b : Local.alone) =
  let is_there (a : Local.alone) = a.body.number <> Catalogue.nobody in
  let stays = is_there a && is_there b && a.body.place = b.body.place && a.body.form = b.body.form in
  not (stays || Scc_data.Arrays.equal Float_box.equal a.boxes b.boxes)

let enter t number i =
  let is_nobody = number = Catalogue.nobody in
  let a = if is_nobody then Local.nobody t.local else Local.alone t.local number in
  t.alone.(i) <- a;
  t.numbers.(i) <- number;
  t.velocities.(i) <- (if is_nobody then -1 else a.body.velocity);
  Bytes.set t.acts i (if a.urgent = [] && a.weak = [] then '\000' else '\001');
  if not t.unseen.(i) then begin
    t.unseen.(i) <- true;
    t.waiting <- i :: t.waiting
  end

let start_over t =
  let n = slots t and nobody = Local.nobody t.local in
  Array.fill t.numbers 0 n (-1);
  Array.fill t.alone 0 n nobody;
  Array.fill t.seen 0 n nobody;
  Array.fill t.unseen 0 n false;
  Array.fill t.near 0 n [];
  t.waiting <- [];
  Array.fill t.velocities 0 n (-1);
  Bytes.fill t.acts 0 n '\000';
  t.colliding <- Pairs.empty

let look t tuple =
  if not t.whole then start_over t;
  t.whole <- false;
  for i = 0 to slots t - 1 do
    let number = Array.unsafe_get tuple i in
    if Array.unsafe_get t.numbers i <> number then enter t number i
  done;
  t.whole <- true

(* {1 Seeing who is near whom} *)

let part t i = List.iter (fun j -> t.colliding <- Pairs.remove (pair t i j) t.colliding) t.near.(i)

let meet t i j =
  let a = t.alone.(Int.min i j) and b = t.alone.(Int.max i j) in
  if a.Local.body.velocity <> b.Local.body.velocity then
    match Local.collisions t.local a b with
    | [] -> ()
    | moves -> t.colliding <- Pairs.add (pair t i j) moves t.colliding

(* To sort all boxes costs about as much as to go through all of them for so many. *)
let few_moved = 12

let see_who_waits t =
  t.whole <- false;
  List.iter (part t) t.waiting;
  let moved = List.filter (fun i -> has_moved t.seen.(i) t.alone.(i)) t.waiting in
  List.iter (set_hull t) moved;
  if List.compare_length_with moved few_moved <= 0 then List.iter (find_again t) moved else find_all t;
  List.iter (fun i -> List.iter (meet t i) t.near.(i)) t.waiting;
  let seen i =
    t.seen.(i) <- t.alone.(i);
    t.unseen.(i) <- false
  in
  List.iter seen t.waiting;
  t.waiting <- [];
  t.whole <- true

(* {1 What is there} *)

let present t =
  let rec from i acc =
    if i < 0 then Array.of_list acc
    else from (i - 1) (if t.numbers.(i) = Catalogue.nobody then acc else t.alone.(i) :: acc)
  in
  from (slots t - 1) []

let last_first moves t =
  let rec from i acc =
    match Bytes.index_from_opt t.acts i '\001' with
    | None -> acc
    | Some i -> from (i + 1) (List.rev_append (moves t.alone.(i)) acc)
  in
  from 0 []

let urgent t = last_first (fun (a : Local.alone) -> a.urgent) t
let weak t = last_first (fun (a : Local.alone) -> a.weak) t

let in_relative_motion t =
  let rec from i velocity =
    i < slots t
    &&
    let mine = Array.unsafe_get t.velocities i in
    if mine < 0 then from (i + 1) velocity else (velocity >= 0 && mine <> velocity) || from (i + 1) mine
  in
  from 0 (-1)

(* Where nobody moves relative to anybody else, it does not matter who is near whom. *)
let collisions t =
  if not (in_relative_motion t) then []
  else begin
    see_who_waits t;
    Pairs.fold (fun _ moves acc -> List.rev_append moves acc) t.colliding []
  end
