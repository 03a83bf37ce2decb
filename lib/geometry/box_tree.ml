(* Boxes of very different sizes in one tree would spoil it: a wall makes every node above it as long as
   itself. So there is one tree for each range of sizes, a factor of 16 wide, in one pool of nodes.

   Queries are fast when nodes are small, and that no path is long must hold whatever comes and goes. So trees are
   kept in a loose balance: the heights of two siblings differ by at most [slack]. As for AVL trees, the least
   number of leaves of a tree of height h then grows as N(h) = N(h - 1) + N(h - 1 - slack), here by 1.32 for each
   level: no path is longer than 2.5 log2 of the number of leaves. Within that freedom, new leaves go and
   neighbours are exchanged where surfaces get smaller. *)

let slack = 4

type t = {
  mutable nodes : float array;
  (** eight for each node: bounds x0 y0 z0 x1 y1 z1; the left child, or -1 in a leaf; the right child, or the
      key in a leaf *)
  mutable parent : int array;  (** -1 at a root; the next free node for a free one *)
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
let left t i = int_of_float t.nodes.((8 * i) + 6)
let right t i = int_of_float t.nodes.((8 * i) + 7)
let set_left t i j = t.nodes.((8 * i) + 6) <- float_of_int j
let set_right t i j = t.nodes.((8 * i) + 7) <- float_of_int j
let is_leaf t i = t.nodes.((8 * i) + 6) < 0.

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
    nodes = Array.make (8 * n) 0.;
    parent;
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
  t.nodes <- extended t.nodes (16 * n) 0.;
  t.parent <- extended t.parent (2 * n) (-1);
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
  let i = 8 * i in
  area (length (b.(i + 3) -. b.(i))) (length (b.(i + 4) -. b.(i + 1))) (length (b.(i + 5) -. b.(i + 2)))

let least (x : float) y = if x < y then x else y
let most (x : float) y = if x > y then x else y

let joint_surface (b : float array) i j =
  let i = 8 * i and j = 8 * j in
  area
    (length (most b.(i + 3) b.(j + 3) -. least b.(i) b.(j)))
    (length (most b.(i + 4) b.(j + 4) -. least b.(i + 1) b.(j + 1)))
    (length (most b.(i + 5) b.(j + 5) -. least b.(i + 2) b.(j + 2)))

(* {1 Shape of the trees} *)

let joint_height t i j = 1 + Int.max t.height.(i) t.height.(j)
let in_balance t i j = Int.abs (t.height.(i) - t.height.(j)) <= slack

(* The bounds and the height of an inner node from its children; whether they change. *)
let fit t i =
  let l = left t i and r = right t i in
  let b = t.nodes in
  let at = 8 * i and j = 8 * l and k = 8 * r in
  let changed = ref false in
  for c = 0 to 2 do
    let low = least b.(j + c) b.(k + c) and high = most b.(j + c + 3) b.(k + c + 3) in
    if low <> b.(at + c) || high <> b.(at + c + 3) then begin
      b.(at + c) <- low;
      b.(at + c + 3) <- high;
      changed := true
    end
  done;
  let height = joint_height t l r in
  if height <> t.height.(i) then begin
    t.height.(i) <- height;
    changed := true
  end;
  !changed

let set_child t i ~old child =
  if left t i = old then set_left t i child else set_right t i child;
  t.parent.(child) <- i

(* [j] takes the place of [i] below the parent of [i]. *)
let replace t tree i j =
  let p = t.parent.(i) in
  if p >= 0 then set_child t p ~old:i j
  else begin
    t.parent.(j) <- p;
    t.roots.(tree) <- j
  end

(* [up], a child of [i] that is higher than the other one by more than [slack], takes the place of [i]. Its higher
   child stays with it; the other one becomes a child of [i]; either may when they are as high. When [up] was too
   high by one (and more cannot be: below, heights have changed by one), then both are in balance again. *)
let rotate t tree i up =
  let other = if left t i = up then right t i else left t i in
  let f = left t up and g = right t up in
  let down =
    let d = t.height.(f) - t.height.(g) in
    if d < 0 || (d = 0 && joint_surface t.nodes other f <= joint_surface t.nodes other g) then f else g
  in
  replace t tree i up;
  set_child t i ~old:up down;
  set_child t up ~old:down i;
  ignore (fit t i);
  ignore (fit t up)

(* [i] has a child [a] and another one with the children [moved] and [kept]. Whether [a] and [moved] may change
   places: the balance stays, and so does the height of [i], so that it does not matter to those above. *)
let may_exchange t i a moved kept =
  in_balance t a kept
  &&
  let height = joint_height t a kept in
  Int.abs (height - t.height.(moved)) <= slack && 1 + Int.max height t.height.(moved) = t.height.(i)

let do_exchange t i a b moved =
  set_child t b ~old:moved a;
  set_child t i ~old:a moved;
  ignore (fit t b)

(* A child [a] of [i] and a child of its sibling [b] change places if that makes [b] smaller. *)
let exchange_below t i a b =
  (not (is_leaf t b))
  &&
  let f = left t b and g = right t b in
  let now = surface t.nodes b in
  let for_f = joint_surface t.nodes a g and for_g = joint_surface t.nodes a f in
  if for_f <= for_g then
    for_f < now && may_exchange t i a f g
    && begin
      do_exchange t i a b f;
      true
    end
  else
    for_g < now && may_exchange t i a g f
    && begin
      do_exchange t i a b g;
      true
    end

let exchange t i =
  let l = left t i and r = right t i in
  if not (exchange_below t i l r) then ignore (exchange_below t i r l)

(* From a node upwards, after something changed below it, as far as that changes anything. *)
let rec refit t tree i =
  if i >= 0 then begin
    let l = left t i and r = right t i in
    if in_balance t l r then begin
      let changed = fit t i in
      exchange t i;
      if changed then refit t tree t.parent.(i)
    end
    else begin
      rotate t tree i (if t.height.(l) > t.height.(r) then l else r);
      refit t tree t.parent.(t.parent.(i))
    end
  end

(* The node to become the sibling of a new leaf: down from the root, wherever surfaces grow least. *)
let rec sibling t leaf i =
  if is_leaf t i then i
  else
    let b = t.nodes in
    let l = left t i and r = right t i in
    let here = joint_surface b i leaf in
    let grown = here -. surface b i in
    let growth child =
      let joint = joint_surface b child leaf in
      if is_leaf t child then grown +. joint else grown +. joint -. surface b child
    in
    let at_l = growth l and at_r = growth r in
    if here < at_l && here < at_r && t.height.(i) <= slack then i
    else sibling t leaf (if at_l <= at_r then l else r)

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
    t.nodes.((8 * leaf) + c) <- Float_box.low box c;
    t.nodes.((8 * leaf) + c + 3) <- Float_box.high box c
  done;
  set_left t leaf (-1);
  set_right t leaf key;
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
    set_left t joint beside;
    set_right t joint leaf;
    t.parent.(beside) <- joint;
    t.parent.(leaf) <- joint;
    ignore (fit t joint);
    refit t tree t.parent.(joint)
  end

let remove t key =
  if not (mem t key) then bug __POS__ "a box that is not there is removed";
  let leaf = t.leaf_of.(key) and tree = t.class_of.(key) in
  t.leaf_of.(key) <- -1;
  let p = t.parent.(leaf) in
  if p < 0 then t.roots.(tree) <- -1
  else begin
    let other = if left t p = leaf then right t p else left t p in
    replace t tree p other;
    release t p;
    refit t tree t.parent.(other)
  end;
  release t leaf

let iter_meeting t box f =
  let b = t.nodes in
  let x0 = Float_box.low box 0 and y0 = Float_box.low box 1 and z0 = Float_box.low box 2 in
  let x1 = Float_box.high box 0 and y1 = Float_box.high box 1 and z1 = Float_box.high box 2 in
  let rec visit i =
    let at = 8 * i in
    if
      b.(at) <= x1 && x0 <= b.(at + 3)
      && b.(at + 1) <= y1 && y0 <= b.(at + 4)
      && b.(at + 2) <= z1 && z0 <= b.(at + 5)
    then
      if b.(at + 6) < 0. then f (int_of_float b.(at + 7))
      else begin
        visit (int_of_float b.(at + 6));
        visit (int_of_float b.(at + 7))
      end
  in
  Array.iter (fun root -> if root >= 0 then visit root) t.roots

let height t = Array.fold_left (fun h root -> if root < 0 then h else Int.max h t.height.(root)) 0 t.roots
