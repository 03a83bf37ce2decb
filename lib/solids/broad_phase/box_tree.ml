open Scc_geometry
open Box_nodes

(* Boxes of very different sizes in one tree would spoil it: a wall makes every node above it as long as
   itself. So there is one tree for each range of sizes, a factor of 16 wide. *)
type t = {
  pool : Box_nodes.t;
  mutable used : int;  (** a bit for each head with a root *)
  mutable moves : int;
  mutable count : int;
  mutable batch : int;  (** the number of the last batch of moves, from 1: the mark of what it has moved *)
  mutable moved : int list;  (** its keys *)
  mutable last : int array;  (** of each key: the head under which it was last, and a node near by, or -1 twice *)
}

let bug where what = Scc_base.Bug.fail where what
let create () = { pool = Box_nodes.create (); used = 0; moves = 0; count = 0; batch = 0; moved = []; last = [||] }

let head_of_box box =
  let e = Float_box.extent box in
  if e < greatest_length then
    let _, exponent = Float.frexp e in
    Int.max 0 (Int.min (heads - 2) ((exponent + 64) asr 2))
  else heads - 1

let is_used t head = t.used land (1 lsl head) <> 0

let iter_used t f =
  let rec from used head =
    if used <> 0 then begin
      if used land 1 <> 0 then f head;
      from (used lsr 1) (head + 1)
    end
  in
  from t.used 0

(* {1 The set} *)

let mem t key = leaf_parent t.pool key >= 0

let make_room t key =
  Box_nodes.make_room t.pool key;
  let n = Array.length t.last in
  if 2 * key >= n then begin
    let last = Array.make (2 * Int.max (key + 1) n) (-1) in
    Array.blit t.last 0 last 0 n;
    t.last <- last
  end

(* A box that is put back is as a rule near to where it was: its place is looked for from there. The node near by
   may have become another one since. *)
let start t key head k =
  let near = t.last.((2 * key) + 1) in
  if t.last.(2 * key) = head && near >= 0 && not (is_free t.pool near) then place_above t.pool near k
  else k head 0

let insert t key box =
  if key < 0 || mem t key then bug __POS__ "a box is inserted twice";
  make_room t key;
  set_box t.pool new_box box;
  let head = head_of_box box in
  if is_used t head then
    start t key head (fun i side -> find_place t.pool i side (fun i side -> Box_nodes.insert t.pool key i side))
  else begin
    put t.pool head 0 (-1 - key) ~from:new_box;
    t.used <- t.used lor (1 lsl head)
  end;
  t.last.(2 * key) <- head;
  t.count <- t.count + 1

let remove t key =
  if not (mem t key) then bug __POS__ "a box that is not there is removed";
  let p = leaf_parent t.pool key in
  let near =
    if is_head p then begin
      t.used <- t.used land lnot (1 lsl p);
      cut_off t.pool key;
      -1
    end
    else
      let above = Box_nodes.remove t.pool key in
      if is_head above then -1 else above
  in
  t.last.((2 * key) + 1) <- near;
  t.count <- t.count - 1

(* {1 Batches of moves} *)

(* How often a place is looked for anew, so that the tree goes on to fit: once in so many moves. *)
let moves_between = 8

(* Gives a box new bounds in its place, if it is to keep that: then it meets the box that it was. *)
let keeps_place t key box =
  if not (mem t key) then bug __POS__ "a box that is not there is moved";
  let p = leaf_parent t.pool key in
  let own = bounds p (side_of t.pool p (-1 - key)) in
  set_box t.pool new_box box;
  t.moves <- t.moves + 1;
  let keeps =
    t.moves mod moves_between <> 0
    && (not (is_head p))
    && head_of_box box = t.last.(2 * key)
    && meet t.pool own new_box
  in
  if keeps then copy_box t.pool ~from:new_box own;
  keeps

let is_moved t c = has_mark t.pool t.batch c

(* A batch is large if it has more than this part of all boxes. Then it is quicker to go once through all nodes
   above its boxes than from each box to the root, or from the roots to each box. *)
let large_part = 16
let is_large t = List.compare_length_with t.moved (t.count / large_part) > 0

(* Those that keep their places come first, and the nodes above them are refitted once. *)
let move t moves =
  t.batch <- t.batch + 1;
  t.moved <- List.rev_map fst moves;
  let is_large = is_large t in
  let moves_on (key, box) =
    let keeps = keeps_place t key box in
    if keeps then begin
      set_mark t.pool t.batch key;
      if not is_large then refit t.pool (leaf_parent t.pool key)
    end;
    not keeps
  in
  let anew = List.filter moves_on moves in
  if is_large then iter_used t (fun head -> if is_moved t head then refit_marked t.pool t.batch head);
  let place_anew (key, box) =
    remove t key;
    insert t key box;
    set_mark t.pool t.batch key
  in
  List.iter place_anew anew

(* Pairs of a box in or below [c] and one in or below [d], whose bounds, at [i] and [j], meet. *)
let rec pairs_across t f i c j d =
  if is_moved t c || is_moved t d then
    if c < 0 && d < 0 then f (-1 - c) (-1 - d)
    else if c < 0 then
      for side = 0 to 1 do
        let j = bounds d side in
        if meet t.pool i j then pairs_across t f i c j (child t.pool d side)
      done
    else if d < 0 then
      for side = 0 to 1 do
        let i = bounds c side in
        if meet t.pool i j then pairs_across t f i (child t.pool c side) j d
      done
    else
      for k = 0 to 3 do
        let i = bounds c (k lsr 1) and j = bounds d (k land 1) in
        if meet t.pool i j then pairs_across t f i (child t.pool c (k lsr 1)) j (child t.pool d (k land 1))
      done

let rec pairs_below t f c =
  if c >= 0 && is_moved t c then begin
    let first = child t.pool c 0 and second = child t.pool c 1 in
    pairs_below t f first;
    pairs_below t f second;
    if meet t.pool (bounds c 0) (bounds c 1) then pairs_across t f (bounds c 0) first (bounds c 1) second
  end

let iter_pairs_below_marks t f =
  let root head = child t.pool head 0 in
  let pairs head =
    pairs_below t f (root head);
    iter_used t (fun other ->
        let i = bounds head 0 and j = bounds other 0 in
        if other > head && meet t.pool i j then pairs_across t f i (root head) j (root other))
  in
  iter_used t pairs

(* {1 Queries} *)

(* The leaves with a box of which [test] is true, as it is of the boxes of all nodes above them. *)
let iter_where t test f =
  let rec visit i =
    for side = 0 to 1 do
      if test (bounds i side) then
        let c = child t.pool i side in
        if c < 0 then f (-1 - c) else visit c
    done
  in
  iter_used t visit

let iter_meeting t box f = iter_where t (fun at -> meets t.pool at box) f

let iter_moved_pairs t f =
  if is_large t then iter_pairs_below_marks t f
  else
    let pairs key =
      let p = leaf_parent t.pool key in
      let own = bounds p (side_of t.pool p (-1 - key)) in
      let others other = if other > key || (other < key && not (is_moved t (-1 - other))) then f key other in
      iter_where t (meet t.pool own) others
    in
    List.iter pairs t.moved

let is_sound t =
  let sound = ref true in
  iter_used t (fun head -> sound := !sound && Box_nodes.is_sound t.pool head);
  !sound

let height t =
  let highest = ref 0 in
  iter_used t (fun head -> highest := Int.max !highest (height t.pool (child t.pool head 0)));
  !highest
