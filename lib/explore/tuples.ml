type changes = int array

(* Nodes of the tree are numbered from the slots, 0 to width - 1, upwards; the root is the last. Node k has the
   children [left.(k)] and [right.(k)], of smaller numbers. *)
type t = {
  width : int;
  left : int array;
  right : int array;
  parent : int array;  (** -1 for none *)
  inner : Pairs.t;
  roots : Pairs.t;
  work : int array;  (** of the tuple that is looked for: the nodes that differ from those of the one near it *)
  stamp : int array;  (** the round in which a node of [work] was written *)
  mutable round : int;
  pending : int array;  (** nodes a child of which differs, increasing *)
  mutable keys : int array;  (** of several tuples: the pairs of their roots *)
  mutable ids : int array;  (** and their numbers, -1 for those that were not known *)
}

type spread = { count : int; node : int array }

(* Halves of halves: few different parts, and so few to look up, are on the way from a slot to the root. *)
let shape width =
  let left = Array.make ((2 * width) - 1) (-1) and right = Array.make ((2 * width) - 1) (-1) in
  (* The node of the slots from [low] on, below [high], and the next number that is free: children come first. *)
  let rec build next low high =
    if high - low = 1 then (low, next)
    else begin
      let middle = (low + high) / 2 in
      let l, next = build next low middle in
      let r, next = build next middle high in
      left.(next) <- l;
      right.(next) <- r;
      (next, next + 1)
    end
  in
  ignore (build width 0 width);
  (left, right)

let create ~width =
  if width < 1 then Scc_base.Bug.fail __POS__ "a tuple of no numbers";
  let left, right = shape width in
  let nodes = (2 * width) - 1 in
  let parent = Array.make nodes (-1) in
  for k = width to nodes - 1 do
    parent.(left.(k)) <- k;
    parent.(right.(k)) <- k
  done;
  {
    width; left; right; parent;
    inner = Pairs.create ~in_files:true;
    roots = Pairs.create ~in_files:true;
    work = Array.make nodes 0;
    stamp = Array.make nodes 0;
    round = 0;
    pending = Array.make nodes 0;
    keys = [||];
    ids = [||];
  }

let width t = t.width
let size t = Pairs.size t.roots
let spread t = { count = t.width; node = Array.make ((2 * t.width) - 1) (-1) }
let slots s = Array.sub s.node 0 s.count

(* The root is the pair of its children; of a single slot, the slot and nothing. *)
let load_key t s key =
  let node = s.node in
  if t.width = 1 then node.(0) <- Pairs.unpack_left key
  else begin
    let root = (2 * t.width) - 2 in
    node.(t.left.(root)) <- Pairs.unpack_left key;
    node.(t.right.(root)) <- Pairs.unpack_right key;
    for k = root - 1 downto t.width do
      node.(t.left.(k)) <- Pairs.left t.inner node.(k);
      node.(t.right.(k)) <- Pairs.right t.inner node.(k)
    done
  end

let load t s id = load_key t s (Pairs.key t.roots id)

(** {2 Changes} *)

let apply changes tuple =
  let copy = Array.copy tuple in
  for i = 0 to (Array.length changes / 2) - 1 do
    copy.(changes.(2 * i)) <- changes.((2 * i) + 1)
  done;
  copy

let difference a b =
  let rec from i acc =
    if i < 0 then Array.of_list acc
    else from (i - 1) (if a.(i) = b.(i) then acc else i :: b.(i) :: acc)
  in
  from (Array.length a - 1) []

(** {2 Looking up} *)

let write t k v =
  Array.unsafe_set t.work k v;
  Array.unsafe_set t.stamp k t.round

let[@inline] value t near k =
  if Array.unsafe_get t.stamp k = t.round then Array.unsafe_get t.work k else Array.unsafe_get near.node k

(* Puts a node among the pending ones from [first] on, of which there are [count] with those before; it may be
   there already. The new count. *)
let rec put t first count k =
  if count = first || Array.unsafe_get t.pending (count - 1) < k then begin
    Array.unsafe_set t.pending count k;
    count + 1
  end
  else
    let last = Array.unsafe_get t.pending (count - 1) in
    if last = k then count
    else begin
      let n = put t first (count - 1) k in
      Array.unsafe_set t.pending n last;
      n + 1
    end

(* The pair of the root. Nodes are taken from the lowest up, so that children come before their parents; the
   last is the root. Of a part that [look] does not know, -1. *)
let rec climb t near look first count =
  let k = Array.unsafe_get t.pending first in
  let l = value t near (Array.unsafe_get t.left k) and r = value t near (Array.unsafe_get t.right k) in
  let above = Array.unsafe_get t.parent k in
  if above < 0 then Pairs.pack l r
  else
    let id = look t.inner l r in
    if id < 0 then -1
    else begin
      write t k id;
      climb t near look (first + 1) (put t (first + 1) count above)
    end

let unchanged t near =
  let root = (2 * t.width) - 2 in
  Pairs.pack near.node.(t.left.(root)) near.node.(t.right.(root))

let root_key t ~near changes look =
  if t.width = 1 then Pairs.pack (if Array.length changes = 0 then near.node.(0) else changes.(1)) 0
  else begin
    t.round <- t.round + 1;
    let rec enter i count =
      if i >= Array.length changes then count
      else
        let slot = changes.(i) and v = Array.unsafe_get changes (i + 1) in
        if near.node.(slot) = v then enter (i + 2) count
        else begin
          write t slot v;
          enter (i + 2) (put t 0 count t.parent.(slot))
        end
    in
    match enter 0 0 with
    | 0 -> unchanged t near
    | count -> climb t near look 0 count
  end

let key t ~near changes = root_key t ~near changes Pairs.intern
let intern t ~near changes = Pairs.intern_key t.roots (root_key t ~near changes Pairs.intern)

let find t ~near changes =
  match root_key t ~near changes Pairs.find with
  | -1 -> -1
  | k -> Pairs.find_key t.roots k

let prepare t ~near changes n =
  if n >= Array.length t.keys then begin
    let longer a = Array.append a (Array.make (n + 16) 0) in
    t.keys <- longer t.keys;
    t.ids <- longer t.ids
  end;
  t.keys.(n) <- root_key t ~near changes Pairs.intern

let fetch t count = Pairs.find_keys t.roots t.keys t.ids count

(* One that was not known may be the same as one before it. *)
let intern_prepared t n =
  let id = t.ids.(n) in
  if id >= 0 then id else Pairs.intern_key t.roots t.keys.(n)

let bytes t = Pairs.bytes t.inner + Pairs.bytes t.roots
