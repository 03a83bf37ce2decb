open Scc_geometry

(* Queries are fast when nodes are small, and that no path is long must hold whatever comes and goes. So trees are
   kept in a loose balance: the heights of two siblings differ by at most [slack]. As for AVL trees, the least
   number of leaves of a tree of height h then grows as N(h) = N(h - 1) + N(h - 1 - slack), here by 1.32 for each
   level: no path is longer than 2.5 log2 of the number of leaves. Within that freedom, new leaves go where nodes
   grow least. (To exchange nodes afterwards where that makes others smaller costs more than it saves.) *)

let slack = 4

(* What a query looks at is side by side in memory, sixteen numbers for each node: the bounds x0 y0 z0 x1 y1 z1 of
   each child, the two children, its height and its parent. The bounds of the second child of a head are NaNs,
   which meet nothing. *)
type t = {
  mutable nodes : float array;
  mutable free : int;  (** the first free node, or -1; the parent of a free node is the next one *)
  mutable node_marks : int array;
  mutable leaf_marks : int array;  (** by key *)
  mutable parent_of : int array;  (** the parent of each leaf, or -1 *)
}

let width = 16
let heads = 40

let initial_nodes = 64

let bounds i side = (width * i) + (6 * side)
let child t i side = int_of_float t.nodes.((width * i) + 12 + side)
let height_of t i = int_of_float t.nodes.((width * i) + 14)
let height t c = if c < 0 then 0 else height_of t c
let set_height t i h = t.nodes.((width * i) + 14) <- float_of_int h

(* The first child of a node of its own. *)
let new_box = bounds heads 0
let parent t i = int_of_float t.nodes.((width * i) + 15)
let set_parent t i p = t.nodes.((width * i) + 15) <- float_of_int p
let is_head i = i < heads

let set_child t i side c =
  t.nodes.((width * i) + 12 + side) <- float_of_int c;
  if c < 0 then t.parent_of.(-1 - c) <- i else set_parent t c i

let side_of t i c = if child t i 0 = c then 0 else 1

(* Of a node that is free. *)
let free_height = -1

(* Chains the nodes from [first] to the end as free ones. *)
let chain t first =
  let n = Array.length t.nodes / width in
  for i = first to n - 1 do
    set_height t i free_height;
    set_parent t i (if i = n - 1 then -1 else i + 1)
  done;
  t.free <- first

let create () =
  let nodes = Array.make (width * initial_nodes) Float.nan in
  let t = { nodes; free = -1; node_marks = Array.make initial_nodes 0; leaf_marks = [||]; parent_of = [||] } in
  chain t (heads + 1);
  t

let extended a length fill =
  let b = Array.make length fill in
  Array.blit a 0 b 0 (Array.length a);
  b

let allocate t =
  if t.free < 0 then begin
    let n = Array.length t.nodes in
    t.nodes <- extended t.nodes (2 * n) Float.nan;
    t.node_marks <- extended t.node_marks (2 * n / width) 0;
    chain t (n / width)
  end;
  let i = t.free in
  t.free <- parent t i;
  t.node_marks.(i) <- 0;
  i

let release t i =
  set_height t i free_height;
  set_parent t i t.free;
  t.free <- i

let is_free t i = height_of t i = free_height
let leaf_parent t key = if key < Array.length t.parent_of then t.parent_of.(key) else -1

let make_room t key =
  let n = Array.length t.parent_of in
  if key >= n then begin
    let length = Int.max (key + 1) (2 * n) in
    t.parent_of <- extended t.parent_of length (-1);
    t.leaf_marks <- extended t.leaf_marks length 0
  end

let cut_off t key = t.parent_of.(key) <- -1

(* {1 Boxes} *)

let set_box t at box =
  for c = 0 to 2 do
    t.nodes.(at + c) <- Float_box.low box c;
    t.nodes.(at + c + 3) <- Float_box.high box c
  done

let copy_box t ~from at = Array.blit t.nodes from t.nodes at 6

let meet t i j =
  let b = t.nodes in
  b.(i) <= b.(j + 3) && b.(j) <= b.(i + 3)
  && b.(i + 1) <= b.(j + 4) && b.(j + 1) <= b.(i + 4)
  && b.(i + 2) <= b.(j + 5) && b.(j + 2) <= b.(i + 5)

let meets t at box =
  let b = t.nodes and low = Float_box.low box and high = Float_box.high box in
  b.(at) <= high 0 && low 0 <= b.(at + 3)
  && b.(at + 1) <= high 1 && low 1 <= b.(at + 4)
  && b.(at + 2) <= high 2 && low 2 <= b.(at + 5)

let contains t at own =
  let b = t.nodes in
  b.(at) <= b.(own) && b.(own + 3) <= b.(at + 3)
  && b.(at + 1) <= b.(own + 1) && b.(own + 4) <= b.(at + 4)
  && b.(at + 2) <= b.(own + 2) && b.(own + 5) <= b.(at + 5)

(* {1 Marks} *)

(* If a leaf has a mark, then so have all nodes above it. *)
let has_mark t mark c = (if c < 0 then t.leaf_marks.(-1 - c) else t.node_marks.(c)) = mark

let set_mark t mark key =
  let rec up i =
    if t.node_marks.(i) <> mark then begin
      t.node_marks.(i) <- mark;
      if not (is_head i) then up (parent t i)
    end
  in
  t.leaf_marks.(key) <- mark;
  up t.parent_of.(key)

(* {1 Sizes} *)

(* Infinite lengths count as this one, which is great, and whose cube is finite. *)
let greatest_length = 1e100
let length d = if d < greatest_length then d else greatest_length

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

(* Brings the height of a node and its bounds, which its parent has, up to date. It is true if they change. *)
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

let put t i side c ~from =
  copy_box t ~from (bounds i side);
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
  t.node_marks.(up) <- Int.max t.node_marks.(up) t.node_marks.(i);
  put t i side (child t up down_side) ~from:(bounds up down_side);
  set_child t up down_side i;
  ignore (fit t i);
  ignore (fit t up)

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

let rec find_place t i side k =
  let c = child t i side in
  if c < 0 then k i side
  else
    let b = t.nodes and leaf = new_box in
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

let rec place_above t i k =
  let p = parent t i in
  let side = side_of t p i in
  if is_head p || contains t (bounds p side) new_box then k p side else place_above t p k

let insert t key i side =
  let joint = allocate t in
  put t joint 0 (child t i side) ~from:(bounds i side);
  put t joint 1 (-1 - key) ~from:new_box;
  set_child t i side joint;
  ignore (fit t joint);
  refit t i

let remove t key =
  let p = t.parent_of.(key) in
  let other = 1 - side_of t p (-1 - key) and above = parent t p in
  t.parent_of.(key) <- -1;
  put t above (side_of t above p) (child t p other) ~from:(bounds p other);
  release t p;
  refit t above;
  above

(* Each after those below it. *)
let rec refit_marked t mark i =
  for side = 0 to if is_head i then 0 else 1 do
    let c = child t i side in
    if c >= 0 && has_mark t mark c then refit_marked t mark c
  done;
  if not (is_head i) then ignore (fit t i)

let rec is_sound t i =
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
         && height_of t c = above first second && is_sound t c)
    (if is_head i then [ 0 ] else [ 0; 1 ])
