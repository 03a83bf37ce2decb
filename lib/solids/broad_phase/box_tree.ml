open Scc_geometry

(* Boxes of very different sizes in one tree would spoil it: a wall makes every node above it as long as
   itself. So there is one tree for each range of sizes, a factor of 16 wide, in one pool of nodes.

   Queries are fast when nodes are small, and that no path is long must hold whatever comes and goes. So trees are
   kept in a loose balance: the heights of two siblings differ by at most [slack]. As for AVL trees, the least
   number of leaves of a tree of height h then grows as N(h) = N(h - 1) + N(h - 1 - slack), here by 1.32 for each
   level: no path is longer than 2.5 log2 of the number of leaves. Within that freedom, new leaves go where nodes
   grow least. (To exchange nodes afterwards where that makes others smaller costs more than it saves.) *)

let slack = 4

(* A node has two children, each a node again (its number) or a leaf (-1 - its key). What a query looks at is
   side by side in memory, sixteen numbers for each node: the bounds x0 y0 z0 x1 y1 z1 of each child, the two
   children, its height (a leaf has 0) and its parent. The first nodes are the heads of the trees: the root is
   their first child, and the bounds of their second one are NaNs, which meet nothing. *)
type t = {
  mutable nodes : float array;
  mutable free : int;  (** the first free node, or -1; the parent of a free node is the next one *)
  mutable moves : int;
  mutable used : int;  (** a bit for each head with a root *)
  mutable parent_of : int array;  (** the parent of each leaf, or -1 *)
  mutable last : int array;  (** of each key: the head under which it was last, and a node near by, or -1 twice *)
}

let bug where what = Scc_base.Bug.fail where what

(* {1 Nodes} *)

let size = 16
let classes = 40

(* The new box, while a place is looked for: the first child of a node of its own. *)
let scratch = classes
let initial_nodes = 64

(* Where the bounds of a child are, for the sides 0 and 1. *)
let bounds i side = (size * i) + (6 * side)
let child t i side = int_of_float t.nodes.((size * i) + 12 + side)
let height_of t i = int_of_float t.nodes.((size * i) + 14)
let height t c = if c < 0 then 0 else height_of t c
let set_height t i h = t.nodes.((size * i) + 14) <- float_of_int h
let parent t i = int_of_float t.nodes.((size * i) + 15)
let set_parent t i p = t.nodes.((size * i) + 15) <- float_of_int p
let is_head i = i < classes

let set_child t i side c =
  t.nodes.((size * i) + 12 + side) <- float_of_int c;
  if c < 0 then t.parent_of.(-1 - c) <- i else set_parent t c i

let side_of t i c = if child t i 0 = c then 0 else 1

(* Of a node that is free. *)
let free_height = -1

(* Chains the nodes from [first] to the end as free ones. *)
let chain t first =
  let n = Array.length t.nodes / size in
  for i = first to n - 1 do
    set_height t i free_height;
    set_parent t i (if i = n - 1 then -1 else i + 1)
  done;
  t.free <- first

let create () =
  let nodes = Array.make (size * initial_nodes) Float.nan in
  let t = { nodes; free = -1; moves = 0; used = 0; parent_of = [||]; last = [||] } in
  chain t (scratch + 1);
  t

let extended a length fill =
  let b = Array.make length fill in
  Array.blit a 0 b 0 (Array.length a);
  b

let allocate t =
  if t.free < 0 then begin
    let n = Array.length t.nodes in
    t.nodes <- extended t.nodes (2 * n) Float.nan;
    chain t (n / size)
  end;
  let i = t.free in
  t.free <- parent t i;
  i

let release t i =
  set_height t i free_height;
  set_parent t i t.free;
  t.free <- i

(* {1 Sizes} *)

(* Infinite lengths count as this one, which is great, and whose cube is finite. *)
let greatest_length = 1e100
let length d = if d < greatest_length then d else greatest_length

let class_of_box box =
  let e = Float_box.extent box in
  if e < greatest_length then
    let _, exponent = Float.frexp e in
    Int.max 0 (Int.min (classes - 2) ((exponent + 64) asr 2))
  else classes - 1

let least (x : float) y = if x < y then x else y
let most (x : float) y = if x > y then x else y

(* The lengths of a box at a place, and of the least one that holds two. *)
let long (b : float array) i axis = length (b.(i + axis + 3) -. b.(i + axis))

let joint (b : float array) i j axis =
  length (most b.(i + axis + 3) b.(j + axis + 3) -. least b.(i + axis) b.(j + axis))

(* Of how many places a box as large as the one at [own] meets the one at [i], or the least that holds both. *)
let reach b own i =
  (long b i 0 +. long b own 0) *. (long b i 1 +. long b own 1) *. (long b i 2 +. long b own 2)

let joint_reach b own i =
  (joint b i own 0 +. long b own 0) *. (joint b i own 1 +. long b own 1) *. (joint b i own 2 +. long b own 2)

(* {1 Shape of the trees} *)

let in_balance a b = Int.abs (a - b) <= slack
let above a b = 1 + Int.max a b

(* Brings the height of a node and its bounds, which its parent has, up to date; whether they change. *)
let fit t i =
  let p = parent t i in
  let b = t.nodes in
  let j = bounds i 0 and k = bounds i 1 and at = bounds p (side_of t p i) in
  let changed = ref false in
  for c = 0 to 2 do
    let low = least b.(j + c) b.(k + c) and high = most b.(j + c + 3) b.(k + c + 3) in
    if low <> b.(at + c) || high <> b.(at + c + 3) then begin
      b.(at + c) <- low;
      b.(at + c + 3) <- high;
      changed := true
    end
  done;
  let h = above (height t (child t i 0)) (height t (child t i 1)) in
  if h <> height_of t i then begin
    set_height t i h;
    changed := true
  end;
  !changed

(* Puts a child, whose bounds are at [from], to a side of a node. *)
let put t i side c ~from =
  Array.blit t.nodes from t.nodes (bounds i side) 6;
  set_child t i side c

(* [up], the child of [i] on a side, is higher than the other one by more than [slack]; it takes the place of
   [i]. Its higher child stays with it; the other one becomes a child of [i]; either may when they are as high.
   When [up] was too high by one (and more cannot be: below, heights have changed by one), then both are in balance
   again. *)
let rotate t i side =
  let up = child t i side and p = parent t i in
  let other = bounds i (1 - side) in
  let down_side =
    let d = height t (child t up 0) - height t (child t up 1) in
    if d < 0 then 0
    else if d > 0 then 1
    else if joint_reach t.nodes other (bounds up 0) <= joint_reach t.nodes other (bounds up 1) then 0
    else 1
  in
  set_child t p (side_of t p i) up;
  put t i side (child t up down_side) ~from:(bounds up down_side);
  set_child t up down_side i;
  ignore (fit t i);
  ignore (fit t up)

(* From a node upwards, after the bounds or the height of a child have changed, as far as that changes anything. *)
let rec refit t i =
  if not (is_head i) then begin
    let l = height t (child t i 0) and r = height t (child t i 1) in
    let p = parent t i in
    if in_balance l r then begin
      if fit t i then refit t p
    end
    else begin
      rotate t i (if l > r then 0 else 1);
      refit t p
    end
  end

(* Where to put a new leaf, whose bounds are in [scratch]: down from a child of a node, wherever nodes grow
   least. It becomes the sibling of what is there, which is not much higher, and [k] is told whose child that
   is. *)
let rec find_place t i side k =
  let c = child t i side in
  if c < 0 then k i side
  else
    let b = t.nodes and leaf = bounds scratch 0 in
    let here = joint_reach b leaf (bounds i side) in
    let grown = here -. reach b leaf (bounds i side) in
    let growth side =
      let at = bounds c side in
      let joint = joint_reach b leaf at in
      if child t c side < 0 then grown +. joint else grown +. joint -. reach b leaf at
    in
    let first = growth 0 and second = growth 1 in
    if here < first && here < second && height_of t c <= slack then k i side
    else find_place t c (if first <= second then 0 else 1) k

(* {1 The set} *)

let mem t key = key < Array.length t.parent_of && t.parent_of.(key) >= 0

let make_room t key =
  let n = Array.length t.parent_of in
  if key >= n then begin
    let length = Int.max (key + 1) (2 * n) in
    t.parent_of <- extended t.parent_of length (-1);
    t.last <- extended t.last (2 * length) (-1)
  end

let is_used t head = t.used land (1 lsl head) <> 0

let contains (b : float array) at own =
  b.(at) <= b.(own) && b.(own + 3) <= b.(at + 3)
  && b.(at + 1) <= b.(own + 1) && b.(own + 4) <= b.(at + 4)
  && b.(at + 2) <= b.(own + 2) && b.(own + 5) <= b.(at + 5)

(* Upwards from a node to one that contains the new box, or to a root: its parent and side. *)
let rec place_above t i k =
  let p = parent t i in
  let side = side_of t p i in
  if is_head p || contains t.nodes (bounds p side) (bounds scratch 0) then k p side else place_above t p k

(* A box that is put back is as a rule near to where it was: its place is looked for from there. The node near by
   may have become another one since. *)
let start t key head k =
  let near = t.last.((2 * key) + 1) in
  if t.last.(2 * key) = head && near >= 0 && height_of t near > free_height then place_above t near k
  else k head 0

let set_bounds t at box =
  for c = 0 to 2 do
    t.nodes.(at + c) <- Float_box.low box c;
    t.nodes.(at + c + 3) <- Float_box.high box c
  done

let insert t key box =
  if key < 0 || mem t key then bug __POS__ "a box is inserted twice";
  make_room t key;
  let new_box = bounds scratch 0 and leaf = -1 - key in
  set_bounds t new_box box;
  let head = class_of_box box in
  let beside i side =
    let joint = allocate t in
    put t joint 0 (child t i side) ~from:(bounds i side);
    put t joint 1 leaf ~from:new_box;
    set_child t i side joint;
    ignore (fit t joint);
    refit t i
  in
  if not (is_used t head) then begin
    put t head 0 leaf ~from:new_box;
    t.used <- t.used lor (1 lsl head)
  end
  else start t key head (fun i side -> find_place t i side beside);
  t.last.(2 * key) <- head

let remove t key =
  if not (mem t key) then bug __POS__ "a box that is not there is removed";
  let p = t.parent_of.(key) in
  t.parent_of.(key) <- -1;
  let side = side_of t p (-1 - key) in
  if is_head p then begin
    t.used <- t.used land lnot (1 lsl p);
    t.last.((2 * key) + 1) <- -1
  end
  else begin
    let above = parent t p in
    put t above (side_of t above p) (child t p (1 - side)) ~from:(bounds p (1 - side));
    release t p;
    t.last.((2 * key) + 1) <- (if is_head above then -1 else above);
    refit t above
  end

let meets (b : float array) i j =
  b.(i) <= b.(j + 3) && b.(j) <= b.(i + 3)
  && b.(i + 1) <= b.(j + 4) && b.(j + 1) <= b.(i + 4)
  && b.(i + 2) <= b.(j + 5) && b.(j + 2) <= b.(i + 5)

(* How often a place is looked for anew, so that the tree goes on to fit: once in so many moves. *)
let moves_between = 8

(* A box that meets the one that it was keeps its place, and the nodes above it are refitted. *)
let move t key box =
  if not (mem t key) then bug __POS__ "a box that is not there is moved";
  let p = t.parent_of.(key) in
  let own = bounds p (side_of t p (-1 - key)) and place = bounds scratch 0 in
  set_bounds t place box;
  t.moves <- t.moves + 1;
  if
    t.moves mod moves_between <> 0
    && (not (is_head p))
    && class_of_box box = t.last.(2 * key)
    && meets t.nodes own place
  then begin
    Array.blit t.nodes place t.nodes own 6;
    refit t p
  end
  else begin
    remove t key;
    insert t key box
  end

(* The boxes that meet the one whose bounds are at [own] in [box]. *)
let rec visit t (b : float array) (box : float array) own f i =
  for side = 0 to 1 do
    let at = bounds i side in
    if
      b.(at) <= box.(own + 3) && box.(own) <= b.(at + 3)
      && b.(at + 1) <= box.(own + 4) && box.(own + 1) <= b.(at + 4)
      && b.(at + 2) <= box.(own + 5) && box.(own + 2) <= b.(at + 5)
    then
      let c = child t i side in
      if c < 0 then f (-1 - c) else visit t b box own f c
  done

let iter_around t box own f =
  let rec from used head =
    if used <> 0 then begin
      if used land 1 <> 0 then visit t t.nodes box own f head;
      from (used lsr 1) (head + 1)
    end
  in
  from t.used 0

let iter_meeting t box f =
  let bounds c = if c < 3 then Float_box.low box c else Float_box.high box (c - 3) in
  iter_around t (Array.init 6 bounds) 0 f

let iter_meeting_own t key f =
  if not (mem t key) then bug __POS__ "neighbours of a box that is not there";
  let p = t.parent_of.(key) in
  iter_around t t.nodes (bounds p (side_of t p (-1 - key))) f

let is_sound t =
  let rec sound i =
    List.for_all
      (fun side ->
         let c = child t i side in
         if c < 0 then t.parent_of.(-1 - c) = i
         else
           let at = bounds i side and j = bounds c 0 and k = bounds c 1 in
           let first = height t (child t c 0) and second = height t (child t c 1) in
           let tight c =
             t.nodes.(at + c) = least t.nodes.(j + c) t.nodes.(k + c)
             && t.nodes.(at + c + 3) = most t.nodes.(j + c + 3) t.nodes.(k + c + 3)
           in
           parent t c = i && List.for_all tight [ 0; 1; 2 ] && in_balance first second
           && height_of t c = above first second && sound c)
      (if is_head i then [ 0 ] else [ 0; 1 ])
  in
  List.for_all (fun head -> (not (is_used t head)) || sound head) (List.init classes Fun.id)

let height t =
  let highest = ref 0 in
  for head = 0 to classes - 1 do
    if is_used t head then highest := Int.max !highest (height t (child t head 0))
  done;
  !highest
