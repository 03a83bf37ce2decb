(* Boxes of very different sizes in one tree would spoil it: a wall makes every node above it as long as
   itself. So there is one tree for each range of sizes, a factor of 16 wide, in one pool of nodes. Each tree is
   kept in balance as AVL trees are: the heights of two siblings differ by at most one. As there is no order to
   keep, one rotation is enough to restore that, and siblings are chosen so that nodes stay small. *)

type t = {
  mutable bounds : float array;  (** six for each node: x0 y0 z0 x1 y1 z1 *)
  mutable parent : int array;  (** -1 at a root; the next free node for a free one *)
  mutable left : int array;  (** -1 in a leaf *)
  mutable right : int array;  (** the key in a leaf *)
  mutable height : int array;  (** 0 for a leaf *)
  mutable free : int;  (** the first free node, or -1 *)
  mutable leaf_of : int array;  (** the node of each key, or -1 *)
  mutable class_of : int array;  (** the tree of each key *)
  roots : int array;
}

let bug where what = Scc_base.Bug.fail where what

(* {1 Nodes} *)

let initial_nodes = 64
let classes = 40

(* Chains the nodes from [first] to the end as free ones. *)
let chain parent first =
  let n = Array.length parent in
  for i = first to n - 1 do
    parent.(i) <- (if i = n - 1 then -1 else i + 1)
  done

let create () =
  let n = initial_nodes in
  let parent = Array.make n (-1) in
  chain parent 0;
  {
    bounds = Array.make (6 * n) 0.;
    parent;
    left = Array.make n (-1);
    right = Array.make n (-1);
    height = Array.make n 0;
    free = 0;
    leaf_of = [||];
    class_of = [||];
    roots = Array.make classes (-1);
  }

let extended a length fill =
  let b = Array.make length fill in
  Array.blit a 0 b 0 (Array.length a);
  b

let grow t =
  let n = Array.length t.parent in
  t.bounds <- extended t.bounds (12 * n) 0.;
  t.parent <- extended t.parent (2 * n) (-1);
  t.left <- extended t.left (2 * n) (-1);
  t.right <- extended t.right (2 * n) (-1);
  t.height <- extended t.height (2 * n) 0;
  chain t.parent n;
  t.free <- n

let allocate t =
  if t.free < 0 then grow t;
  let i = t.free in
  t.free <- t.parent.(i);
  i

let release t i =
  t.parent.(i) <- t.free;
  t.free <- i

(* {1 Sizes} *)

(* Infinite lengths count as this one, which is great, and whose square is finite. *)
let greatest_length = 1e100
let length d = if d < greatest_length then d else greatest_length

let class_of_box box =
  let e = Float_box.extent box in
  if e < greatest_length then
    let _, exponent = Float.frexp e in
    Int.max 0 (Int.min (classes - 2) ((exponent + 64) asr 2))
  else classes - 1

let area x y z = (x *. y) +. (y *. z) +. (z *. x)

(* Half the surface of a node, and of the least box that holds two. *)
let surface (b : float array) i =
  let i = 6 * i in
  area (length (b.(i + 3) -. b.(i))) (length (b.(i + 4) -. b.(i + 1))) (length (b.(i + 5) -. b.(i + 2)))

let least (x : float) y = if x < y then x else y
let most (x : float) y = if x > y then x else y

let joint_surface (b : float array) i j =
  let i = 6 * i and j = 6 * j in
  area
    (length (most b.(i + 3) b.(j + 3) -. least b.(i) b.(j)))
    (length (most b.(i + 4) b.(j + 4) -. least b.(i + 1) b.(j + 1)))
    (length (most b.(i + 5) b.(j + 5) -. least b.(i + 2) b.(j + 2)))

(* {1 Shape of the trees} *)

(* The bounds and the height of an inner node from its children. *)
let fit t i =
  let l = t.left.(i) and r = t.right.(i) in
  let b = t.bounds in
  let at = 6 * i and j = 6 * l and k = 6 * r in
  for c = 0 to 2 do
    b.(at + c) <- least b.(j + c) b.(k + c);
    b.(at + c + 3) <- most b.(j + c + 3) b.(k + c + 3)
  done;
  t.height.(i) <- 1 + Int.max t.height.(l) t.height.(r)

(* [j] takes the place of [i] below the parent of [i]. *)
let replace t tree i j =
  let p = t.parent.(i) in
  t.parent.(j) <- p;
  if p < 0 then t.roots.(tree) <- j
  else if t.left.(p) = i then t.left.(p) <- j
  else t.right.(p) <- j

(* [up], a child of [i] that is higher than the other one by two, takes the place of [i]. Its higher child stays
   with it; the other one becomes a child of [i]. Either may when they are as high. *)
let rotate t tree i up =
  let other = if t.left.(i) = up then t.right.(i) else t.left.(i) in
  let f = t.left.(up) and g = t.right.(up) in
  let down, stays =
    let d = t.height.(f) - t.height.(g) in
    if d < 0 || (d = 0 && joint_surface t.bounds other f <= joint_surface t.bounds other g) then (f, g)
    else (g, f)
  in
  replace t tree i up;
  t.left.(i) <- other;
  t.right.(i) <- down;
  t.parent.(down) <- i;
  t.left.(up) <- i;
  t.right.(up) <- stays;
  t.parent.(i) <- up;
  fit t i;
  fit t up

(* From a node upwards, after something changed below it. *)
let rec refit t tree i =
  if i >= 0 then begin
    let l = t.left.(i) and r = t.right.(i) in
    let d = t.height.(l) - t.height.(r) in
    if d > 1 then rotate t tree i l
    else if d < -1 then rotate t tree i r
    else fit t i;
    refit t tree t.parent.(i)
  end

(* The leaf to become the sibling of a new one: down from the root, wherever surfaces grow least. Were it an inner
   node, the two would differ in height by more than one. *)
let rec sibling t leaf i =
  if t.left.(i) < 0 then i
  else
    let b = t.bounds in
    let l = t.left.(i) and r = t.right.(i) in
    let growth child =
      let joint = joint_surface b child leaf in
      if t.left.(child) < 0 then joint else joint -. surface b child
    in
    sibling t leaf (if growth l <= growth r then l else r)

(* {1 The set} *)

let mem t key = key < Array.length t.leaf_of && t.leaf_of.(key) >= 0

let make_room t key =
  let n = Array.length t.leaf_of in
  if key >= n then begin
    let n = Int.max (key + 1) (2 * n) in
    t.leaf_of <- extended t.leaf_of n (-1);
    t.class_of <- extended t.class_of n 0
  end

let insert t key box =
  if key < 0 || mem t key then bug __POS__ "a box is inserted twice";
  make_room t key;
  let leaf = allocate t in
  for c = 0 to 2 do
    t.bounds.((6 * leaf) + c) <- Float_box.low box c;
    t.bounds.((6 * leaf) + c + 3) <- Float_box.high box c
  done;
  t.left.(leaf) <- -1;
  t.right.(leaf) <- key;
  t.height.(leaf) <- 0;
  let tree = class_of_box box in
  t.leaf_of.(key) <- leaf;
  t.class_of.(key) <- tree;
  let root = t.roots.(tree) in
  if root < 0 then begin
    t.roots.(tree) <- leaf;
    t.parent.(leaf) <- -1
  end
  else begin
    let beside = sibling t leaf root in
    let joint = allocate t in
    replace t tree beside joint;
    t.left.(joint) <- beside;
    t.right.(joint) <- leaf;
    t.parent.(beside) <- joint;
    t.parent.(leaf) <- joint;
    refit t tree joint
  end

let remove t key =
  if not (mem t key) then bug __POS__ "a box that is not there is removed";
  let leaf = t.leaf_of.(key) and tree = t.class_of.(key) in
  t.leaf_of.(key) <- -1;
  let p = t.parent.(leaf) in
  if p < 0 then t.roots.(tree) <- -1
  else begin
    let other = if t.left.(p) = leaf then t.right.(p) else t.left.(p) in
    replace t tree p other;
    release t p;
    refit t tree t.parent.(other)
  end;
  release t leaf

let iter_meeting t box f =
  let b = t.bounds in
  let x0 = Float_box.low box 0 and y0 = Float_box.low box 1 and z0 = Float_box.low box 2 in
  let x1 = Float_box.high box 0 and y1 = Float_box.high box 1 and z1 = Float_box.high box 2 in
  let rec visit i =
    let at = 6 * i in
    if
      b.(at) <= x1 && x0 <= b.(at + 3)
      && b.(at + 1) <= y1 && y0 <= b.(at + 4)
      && b.(at + 2) <= z1 && z0 <= b.(at + 5)
    then
      if t.left.(i) < 0 then f t.right.(i)
      else begin
        visit t.left.(i);
        visit t.right.(i)
      end
  in
  Array.iter (fun root -> if root >= 0 then visit root) t.roots

let height t = Array.fold_left (fun h root -> if root < 0 then h else Int.max h t.height.(root)) 0 t.roots
