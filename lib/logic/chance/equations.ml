open Scc_exact
open Scc_data

type direction = Min | Max

type t = {
  direction : direction;
  size : int;
  parts : int array;
  first_row : Int_array.t;
  first_entry : Int_array.t;
  constant : Rat.t array;
  near_constant : float array;
  node : Int_array.t;
  near : float array;
  mdp : Mdp.t;
  branch : Int_array.t;
  worked_out : Rat.t array;
  leaks : Bits.t;
  choice : Int_array.t;
  node_of : Int_array.t;
}

let first_row e v = Int_array.get e.first_row v
let first_entry e r = Int_array.get e.first_entry r
let node e i = Int_array.get e.node i
let choice e r = Int_array.get e.choice r
let node_of e s = Int_array.get e.node_of s

let probability e i =
  let b = Int_array.get e.branch i in
  if b >= 0 then Mdp.probability e.mdp b else e.worked_out.(-1 - b)

type status = Known of Rat.t | Open | Elsewhere

type source = {
  m : Mdp.t;
  status : int -> status;
  open_ : Bits.t;
  allowed : int -> bool;
  merged : Components.ends;
  rewards : bool;
}

let is_open src s = Bits.mem src.open_ s

(* The choices of a state that make rows. *)
let iter_rows src s f =
  for c = Mdp.first_choice src.m s to Mdp.first_choice src.m (s + 1) - 1 do
    if src.allowed c && not (Bits.mem src.merged.internal c) then f c
  done

let iter_branches m c f =
  for b = Mdp.first_branch m c to Mdp.first_branch m (c + 1) - 1 do
    f b
  done

(* The states of each merged component, one after the other: those of component k from starts.(k) on. *)
let members src =
  if src.merged.count = 0 then fun s f -> f s
  else
    let starts = Array.make (src.merged.count + 1) 0 in
    Array.iter (fun k -> if k >= 0 then starts.(k + 1) <- starts.(k + 1) + 1) src.merged.number;
    for k = 1 to src.merged.count do
      starts.(k) <- starts.(k) + starts.(k - 1)
    done;
    let next = Array.copy starts and all = Array.make starts.(src.merged.count) 0 in
    Array.iteri
      (fun s k ->
         if k >= 0 then begin
           all.(next.(k)) <- s;
           next.(k) <- next.(k) + 1
         end)
      src.merged.number;
    fun s f ->
      let k = src.merged.number.(s) in
      if k < 0 then f s
      else
        for i = starts.(k) to starts.(k + 1) - 1 do
          f all.(i)
        done

(* One state for each group: the first of a component. *)
let leaders src =
  if src.merged.count = 0 then Fun.id
  else
    let first = Array.make src.merged.count (-1) in
    Array.iteri (fun s k -> if k >= 0 && first.(k) < 0 then first.(k) <- s) src.merged.number;
    fun s ->
      let k = src.merged.number.(s) in
      if k < 0 then s else first.(k)

(* The leaders of groups that can be reached from what is asked for. *)
let reached src ~each ~leader = function
  | None -> fun s -> is_open src s && Int.equal (leader s) s
  | Some asked ->
    let n = Mdp.states src.m in
    let found = Worklist.create n in
    for s = 0 to n - 1 do
      if asked s && is_open src s then Worklist.add found (leader s)
    done;
    Worklist.run found (fun s ->
        each s (fun s ->
            iter_rows src s (fun c ->
                iter_branches src.m c (fun b ->
                    let t = Mdp.target src.m b in
                    if is_open src t then Worklist.add found (leader t)))));
    Worklist.mem found

(* Rows being written, into arrays that are long enough. *)
type rows = {
  mutable rows : int;
  mutable entries : int;
  starts : Int_array.t;  (** of rows *)
  constants : Rat.t array;
  near_constants : float array;
  origins : Int_array.t;
  leaking : Bits.t;
  nodes : Int_array.t;
  nears : float array;
  branches : Int_array.t;
  others : Rat.t Growable.t;
  slot : Int_array.t;
  (** where a node stands in the row that is being written, from its beginning; else -1. Nothing where none is
      merged: then no two targets are one node. *)
}

let room ~rows ~entries ~slots =
  {
    rows = 0;
    entries = 0;
    starts = Int_array.make (rows + 1) 0;
    constants = Array.make rows Rat.zero;
    near_constants = Array.make rows 0.;
    origins = Int_array.make rows 0;
    leaking = Bits.create rows;
    nodes = Int_array.make entries 0;
    nears = Array.make entries 0.;
    branches = Int_array.make entries 0;
    others = Growable.create ();
    slot = Int_array.make slots (-1);
  }

let positive x = if x > 0. then x else Next_float.succ 0.

(* The probability of an entry, and a new one. *)
let entry src rows i =
  let b = Int_array.get rows.branches i in
  if b >= 0 then Mdp.probability src.m b else Growable.get rows.others (-1 - b)

let put rows i p =
  Growable.push rows.others p;
  Int_array.set rows.branches i (-Growable.length rows.others);
  rows.nears.(i) <- positive (Rat.to_float p)

(* An entry of the row that is being written; of a node that has one, what it is more. *)
let add_entry src rows b w =
  let place = Int_array.length rows.slot > 0 in
  let i = if place then Int_array.get rows.slot w else -1 in
  if i < 0 then begin
    let i = rows.entries in
    if place then Int_array.set rows.slot w i;
    rows.entries <- i + 1;
    Int_array.set rows.nodes i w;
    Int_array.set rows.branches i b;
    rows.nears.(i) <- positive (Mdp.near src.m).(b)
  end
  else put rows i (Rat.add (entry src rows i) (Mdp.probability src.m b))

(* Adds the row of a choice, unless it leads to nothing but its own node. The nodes of its component are those from
   first to last. *)
let add_row src rows ~node_of ~first ~last v c =
  let m = src.m in
  let base = rows.entries in
  let constant = ref (if src.rewards then Mdp.reward m c else Rat.zero) in
  (* The branch that the constant is the probability of, or -1. *)
  let same = ref (-1) in
  let own = ref Rat.zero and outside = ref false in
  let add ~branch x =
    same := if !constant == Rat.zero then branch else -1;
    constant := if !constant == Rat.zero then x else Rat.add !constant x
  in
  for b = Mdp.first_branch m c to Mdp.first_branch m (c + 1) - 1 do
    let t = Mdp.target m b in
    if is_open src t then begin
      let w = Int_array.get node_of t in
      if Int.equal w v then own := Rat.add !own (Mdp.probability m b)
      else begin
        if w < first || w > last then outside := true;
        add_entry src rows b w
      end
    end
    else
      match src.status t with
      | Open | Elsewhere ->
        Scc_base.Bug.fail __POS__ "an open state leads to one that has no place in the equations"
      | Known x ->
        outside := true;
        if x == Rat.one then add ~branch:b (Mdp.probability m b)
        else if Rat.sign x > 0 then add ~branch:(-1) (Rat.mul (Mdp.probability m b) x)
  done;
  if Int_array.length rows.slot > 0 then
    for i = base to rows.entries - 1 do
      Int_array.set rows.slot (Int_array.get rows.nodes i) (-1)
    done;
  let own = !own in
  if own != Rat.zero && Rat.equal own Rat.one then rows.entries <- base
  else begin
    if own != Rat.zero then begin
      let rest = Rat.sub Rat.one own in
      constant := Rat.div !constant rest;
      same := -1;
      for i = base to rows.entries - 1 do
        put rows i (Rat.div (entry src rows i) rest)
      done
    end;
    let r = rows.rows in
    if !outside then Bits.add rows.leaking r;
    Int_array.set rows.starts r base;
    if !constant != Rat.zero then begin
      rows.constants.(r) <- !constant;
      rows.near_constants.(r) <- (if !same >= 0 then (Mdp.near m).(!same) else Rat.to_float !constant)
    end;
    Int_array.set rows.origins r c;
    rows.rows <- r + 1
  end

(* The groups numbered component by component, within one by increasing leaders; where components begin; and the
   node of each state. *)
let arranged src ~each ~reached components =
  let n = Mdp.states src.m in
  let count = Strong_components.count components in
  let number = Strong_components.number components in
  let parts = Array.make (count + 1) 0 in
  for s = 0 to n - 1 do
    let k = number s in
    if k >= 0 then parts.(k + 1) <- parts.(k + 1) + 1
  done;
  for k = 1 to count do
    parts.(k) <- parts.(k) + parts.(k - 1)
  done;
  let next = Array.copy parts and order = Int_array.make parts.(count) 0 in
  let node_of = Int_array.make n (-1) in
  for s = 0 to n - 1 do
    if reached s then begin
      let k = number s in
      let v = next.(k) in
      Int_array.set order v s;
      each s (fun s -> Int_array.set node_of s v);
      next.(k) <- v + 1
    end
  done;
  (parts, order, node_of)

(* The graph of groups, as far as it is reached; and how many choices make rows. *)
let graph src ~each ~leader ~reached =
  let m = src.m in
  let n = Mdp.states m in
  let first = Int_array.make n 0 and targets = Int_array.make (Mdp.branches m + n) (-1) in
  let used = ref 0 and rows = ref 0 in
  let follow c =
    incr rows;
    for b = Mdp.first_branch m c to Mdp.first_branch m (c + 1) - 1 do
      let t = Mdp.target m b in
      if is_open src t then begin
        Int_array.set targets !used (leader t);
        incr used
      end
    done
  in
  for s = 0 to n - 1 do
    if reached s then begin
      Int_array.set first s !used;
      each s (fun s -> iter_rows src s follow);
      incr used
    end
  done;
  (first, targets, !used, !rows)

let make back direction ~status ~allowed ~merged ~rewards ~asked =
  let m = Backwards.mdp back in
  let n = Mdp.states m in
  let open_ = Bits.init n (fun s -> match status s with Open -> true | Known _ | Elsewhere -> false) in
  let src = { m; status; open_; allowed; merged; rewards } in
  let each = members src and leader = leaders src in
  let reached = reached src ~each ~leader asked in
  let parts, order, node_of, rows =
    let first, targets, entries, rows = graph src ~each ~leader ~reached in
    let components = Strong_components.of_graph ~size:n ~inside:reached ~first ~targets in
    let parts, order, node_of = arranged src ~each ~reached components in
    let slots = if merged.count = 0 then 0 else Int_array.length order in
    (parts, order, node_of, room ~rows ~entries ~slots)
  in
  let size = Int_array.length order in
  let first_row = Int_array.make (size + 1) 0 in
  for k = 0 to Array.length parts - 2 do
    let first = parts.(k) and last = parts.(k + 1) - 1 in
    for v = first to last do
      each (Int_array.get order v) (fun s -> iter_rows src s (add_row src rows ~node_of ~first ~last v));
      if rows.rows = Int_array.get first_row v then
        Scc_base.Bug.fail __POS__ "an open state that nothing leaves";
      Int_array.set first_row (v + 1) rows.rows
    done
  done;
  Int_array.set rows.starts rows.rows rows.entries;
  {
    direction;
    size;
    parts;
    first_row;
    first_entry = rows.starts;
    constant = rows.constants;
    near_constant = rows.near_constants;
    node = rows.nodes;
    near = rows.nears;
    mdp = m;
    branch = rows.branches;
    worked_out = Array.init (Growable.length rows.others) (Growable.get rows.others);
    leaks = rows.leaking;
    choice = rows.origins;
    node_of;
  }

let row_sum e value r =
  let sum = ref e.constant.(r) in
  for i = Int_array.get e.first_entry r to Int_array.get e.first_entry (r + 1) - 1 do
    sum := Rat.add !sum (Rat.mul (probability e i) (value (Int_array.get e.node i)))
  done;
  !sum
