type changes = int array

(* Nodes of the tree are numbered from the slots, 0 to width - 1, upwards; the root is the last. Node k has the
   children [left.(k)] and [right.(k)], of smaller numbers, and the slots from [first.(k)] on, before
   [beyond.(k)]. *)
type t = {
  width : int;
  left : int array;
  right : int array;
  first : int array;
  beyond : int array;
  parent : int array;  (** -1 for none *)
  block : int array;  (** of each slot: the node of the block that it is in *)
  inner : Pairs.t;
  roots : Pairs.t;
  blocks : Block_memory.t;
  halves : Block_memory.t;  (** in which one slot changes, and one in the other half *)
  middle : int;  (** the first slot of the half on the right *)
  on_left : Half_memory.t;
  on_right : Half_memory.t;
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
  let nodes = (2 * width) - 1 in
  let left = Array.make nodes (-1) and right = Array.make nodes (-1) in
  let first = Array.init nodes Fun.id and beyond = Array.init nodes succ in
  (* The node of the slots from [low] on, below [high], and the next number that is free: children come first. *)
  let rec build next low high =
    if high - low = 1 then (low, next)
    else begin
      let middle = (low + high) / 2 in
      let l, next = build next low middle in
      let r, next = build next middle high in
      left.(next) <- l;
      right.(next) <- r;
      first.(next) <- low;
      beyond.(next) <- high;
      (next, next + 1)
    end
  in
  ignore (build width 0 width);
  (left, right, first, beyond)

(* What changes within a block is looked up at once. *)
let block_width = 8

let create ~width =
  if width < 1 then Scc_base.Bug.fail __POS__ "a tuple of no numbers";
  let left, right, first, beyond = shape width in
  let nodes = (2 * width) - 1 in
  let parent = Array.make nodes (-1) in
  for k = width to nodes - 1 do
    parent.(left.(k)) <- k;
    parent.(right.(k)) <- k
  done;
  let rec block k =
    let above = parent.(k) in
    if above < 0 || parent.(above) < 0 || beyond.(above) - first.(above) > block_width then k else block above
  in
  {
    width; left; right; first; beyond; parent;
    block = Array.init width block;
    inner = Pairs.create ~in_files:true;
    roots = Pairs.create ~in_files:true;
    blocks = Block_memory.create ();
    halves = Block_memory.create ();
    middle = width / 2;
    on_left = Half_memory.create ();
    on_right = Half_memory.create ();
    work = Array.make nodes 0;
    stamp = Array.make nodes 0;
    round = 0;
    pending = Array.make nodes 0;
    keys = [||];
    ids = [||];
  }

let size t = Pairs.size t.roots
let spread t = { count = t.width; node = Array.make ((2 * t.width) - 1) (-1) }
let slots s = Array.sub s.node 0 s.count

let read_slots s (room : int array) =
  if Array.length room <> s.count then Scc_base.Bug.fail __POS__ "room for another tuple";
  for i = 0 to s.count - 1 do
    Array.unsafe_set room i (Array.unsafe_get s.node i)
  done

(* What is loaded already, below a node that has the same number, is not loaded again. A node has no number while
   what is below it changes: work may be given up anywhere, and then all of that is loaded again. *)
let rec load_node t node k v =
  if Array.unsafe_get node k <> v then
    if k < t.width then Array.unsafe_set node k v
    else begin
      Array.unsafe_set node k (-1);
      let key = Pairs.key t.inner v in
      load_node t node (Array.unsafe_get t.left k) (Pairs.unpack_left key);
      load_node t node (Array.unsafe_get t.right k) (Pairs.unpack_right key);
      Array.unsafe_set node k v
    end

(* The root is the pair of its children; of a single slot, the slot and nothing. *)
let load_key t s key =
  if t.width = 1 then s.node.(0) <- Pairs.unpack_left key
  else begin
    let root = (2 * t.width) - 2 in
    load_node t s.node t.left.(root) (Pairs.unpack_left key);
    load_node t s.node t.right.(root) (Pairs.unpack_right key)
  end

let load t s id = load_key t s (Pairs.key t.roots id)

(** {2 Changes} *)

let apply changes tuple =
  let copy = Array.copy tuple in
  for i = 0 to (Array.length changes / 2) - 1 do
    copy.(changes.(2 * i)) <- changes.((2 * i) + 1)
  done;
  copy

let difference (a : int array) (b : int array) =
  let differ i = Array.unsafe_get a i <> Array.unsafe_get b i in
  let count = ref 0 in
  for i = 0 to Array.length a - 1 do
    if differ i then incr count
  done;
  let changes = Array.make (2 * !count) 0 in
  let next = ref 0 in
  for i = 0 to Array.length a - 1 do
    if differ i then begin
      changes.(!next) <- i;
      changes.(!next + 1) <- b.(i);
      next := !next + 2
    end
  done;
  changes

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

(* {3 Blocks}

   A block that some changes are made in: a function of its number and of them, whatever stands in other blocks. *)

(* Of the changes from [low] on, before [high]: whether one is below the node; and what is in a slot after them. *)
let rec touches t (changes : changes) low high k =
  low < high
  && ((changes.(low) >= t.first.(k) && changes.(low) < t.beyond.(k)) || touches t changes (low + 2) high k)

let rec after changes low high (slot : int) v =
  if low >= high then v
  else after changes (low + 2) high slot (if changes.(low) = slot then changes.(low + 1) else v)

let rec changed t changes low high look k id =
  if not (touches t changes low high k) then id
  else if k < t.width then after changes low high k id
  else begin
    let key = if id < 0 then -1 else Pairs.key t.inner id in
    let l = changed t changes low high look t.left.(k) (if id < 0 then -1 else Pairs.unpack_left key) in
    let r = changed t changes low high look t.right.(k) (if id < 0 then -1 else Pairs.unpack_right key) in
    if l < 0 || r < 0 then -1 else look t.inner l r
  end

let part_after t memory changes low high look k id =
  if high - low > 4 || id < 0 then changed t changes low high look k id
  else begin
    let number i = Array.unsafe_get changes i in
    let change i = if i < high then Pairs.pack (number i) (number (i + 1)) else -1 in
    let one = change low and two = change (low + 2) in
    match Block_memory.find memory id one two with
    | -1 ->
      let after = changed t changes low high look k id in
      if after >= 0 then Block_memory.keep memory id one two after;
      after
    | after -> after
  end

(* The end of the changes from [i] on that are in one block. *)
let rec run t changes block i =
  if i < Array.length changes && t.block.(changes.(i)) = block then run t changes block (i + 2) else i

(* The blocks that changes from [i] on are in, with what is above those that are others now, of which there are
   [count] with those before; -1, if there is a block that [look] does not know. *)
let rec enter t near changes look i count =
  if i >= Array.length changes then count
  else begin
    let k = t.block.(changes.(i)) in
    let until = run t changes k (i + 2) in
    let before = value t near k in
    match part_after t t.blocks changes i until look k before with
    | -1 -> -1
    | id when id = before -> enter t near changes look until count
    | id ->
      write t k id;
      enter t near changes look until (put t 0 count t.parent.(k))
  end

(* {3 Halves}

   A half is a function of what it was before and of the changes that are made in it. *)

let[@inline] left_root t = Array.unsafe_get t.left ((2 * t.width) - 2)
let[@inline] right_root t = Array.unsafe_get t.right ((2 * t.width) - 2)
let[@inline] is_left t (changes : changes) i = Array.unsafe_get changes i < t.middle

(* One slot changes in each of them. *)
let by_halves t near changes look =
  let on_left, on_right = if is_left t changes 0 then (0, 2) else (2, 0) in
  let after k i = part_after t t.halves changes i (i + 2) look k (Array.unsafe_get near.node k) in
  match (after (left_root t) on_left, after (right_root t) on_right) with
  | -1, _ | _, -1 -> -1
  | left, right -> Pairs.pack left right

(* {3 Many changes} *)

let is_written t k = Array.unsafe_get t.stamp k = t.round

(* All nodes above them, children first; the root is the last. *)
let rec from_below t near look k =
  let l = Array.unsafe_get t.left k and r = Array.unsafe_get t.right k in
  if k = (2 * t.width) - 2 then Pairs.pack (value t near l) (value t near r)
  else if is_written t l || is_written t r then begin
    let id = look t.inner (value t near l) (value t near r) in
    if id < 0 then -1
    else begin
      write t k id;
      from_below t near look (k + 1)
    end
  end
  else from_below t near look (k + 1)

let with_all t near (changes : changes) look =
  t.round <- t.round + 1;
  for i = 0 to (Array.length changes / 2) - 1 do
    write t (Array.unsafe_get changes (2 * i)) (Array.unsafe_get changes ((2 * i) + 1))
  done;
  from_below t near look t.width

let root_key t ~near changes look =
  if t.width = 1 then Pairs.pack (if Array.length changes = 0 then near.node.(0) else changes.(1)) 0
  else if Array.length changes = 4 && is_left t changes 0 <> is_left t changes 2 then by_halves t near changes look
  else begin
    t.round <- t.round + 1;
    match enter t near changes look 0 0 with
    | -1 -> -1
    | 0 -> unchanged t near
    | count -> climb t near look 0 count
  end

let key t ~near changes = root_key t ~near changes Pairs.intern
let intern t ~near changes = Pairs.intern_key t.roots (root_key t ~near changes Pairs.intern)

let find t ~near changes =
  match root_key t ~near changes Pairs.find with
  | -1 -> -1
  | k -> Pairs.find_key t.roots k

(* {3 Changes that come again} *)

(* More changes than this come up again too seldom. *)
let few_changes = 3

(* Whether the changes from the i-th on are all in one half. *)
let rec all_on ~left t changes i =
  i >= Array.length changes || (Bool.equal left (is_left t changes i) && all_on ~left t changes (i + 2))

(* Of changes that go on in the other half, what half they leave on the left. *)
let goes_on half = -2 - half

let remember t (changes : changes) key =
  let count = Array.length changes in
  if count > 0 && count <= 2 * few_changes then begin
    let left = is_left t changes 0 in
    if all_on ~left t changes 2 then
      if left then Half_memory.keep t.on_left changes (Pairs.unpack_left key)
      else Half_memory.keep t.on_right changes (Pairs.unpack_right key)
    else if left && count = 4 then Half_memory.keep t.on_left changes (goes_on (Pairs.unpack_left key))
  end

let lasting_key t ~near changes =
  match Half_memory.find t.on_left changes with
  | -1 -> (
      match Half_memory.find t.on_right changes with
      | -1 ->
        let key = root_key t ~near changes Pairs.intern in
        remember t changes key;
        key
      | after -> Pairs.pack (Array.unsafe_get near.node (left_root t)) after)
  | after when after >= 0 -> Pairs.pack after (Array.unsafe_get near.node (right_root t))
  | after ->
    let right = right_root t in
    Pairs.pack (goes_on after)
      (part_after t t.halves changes 2 4 Pairs.intern right (Array.unsafe_get near.node right))

let start_halves t near =
  if t.width > 1 then begin
    Half_memory.start t.on_left near.node.(left_root t);
    Half_memory.start t.on_right near.node.(right_root t)
  end

(* Of one slot in eight: to go through all nodes costs less than to go up from each of them. *)
let are_many t (changes : changes) = 4 * Array.length changes >= t.width

let begin_round t ~near count =
  if count > Array.length t.keys then begin
    t.keys <- Array.make (2 * count) 0;
    t.ids <- Array.make (2 * count) 0
  end;
  start_halves t near

let prepare t ~near ~lasting changes n =
  Array.unsafe_set t.keys n
    (if t.width = 1 then root_key t ~near changes Pairs.intern
     else if lasting then lasting_key t ~near changes
     else if are_many t changes then with_all t near changes Pairs.intern
     else root_key t ~near changes Pairs.intern)

let fetch t count = Pairs.find_keys t.roots t.keys t.ids count

let[@inline] prepared t n = Array.unsafe_get t.ids n

(* One that was not known may be the same as one before it. *)
let intern_prepared t n = Pairs.intern_key t.roots t.keys.(n)

let[@inline] prepared_key t n = Array.unsafe_get t.keys n
let intern_key t key = Pairs.intern_key t.roots key
let find_key t key = Pairs.find_key t.roots key

(** {2 Several processes} *)

let share t = Pairs.share t.inner ~many:true && Pairs.share t.roots ~many:false

let unshare t =
  Pairs.unshare t.inner;
  Pairs.unshare t.roots

let touch_key t key = Pairs.touch t.roots key

let refresh t =
  Pairs.refresh t.inner;
  Pairs.refresh t.roots

let is_room_wanted t = Pairs.is_room_wanted t.inner
let make_room t = Pairs.enlarge_shared t.inner
let set_full t full = Pairs.set_full t.inner full
let go_on_apart t ~full = Pairs.go_on_apart t.inner ~full
let bytes t = Pairs.bytes t.inner + Pairs.bytes t.roots
