open Scc_exact
open Scc_data

type direction = Min | Max

type t = {
  direction : direction;
  size : int;
  parts : int array;
  first_row : int array;
  first_entry : int array;
  constant : Rat.t array;
  near_constant : float array;
  node : int array;
  near : float array;
  mdp : Mdp.t;
  branch : int array;
  worked_out : Rat.t array;
  leaks : Bits.t;
  choice : int array;
  node_of : int array;
}

let probability e i =
  let b = e.branch.(i) in
  if b >= 0 then Mdp.probability e.mdp b else e.worked_out.(-1 - b)

type status = Known of Rat.t | Open | Elsewhere

type source = {
  m : Mdp.t;
  status : int -> status;
  allowed : int -> bool;
  merged : Components.ends;
  rewards : bool;
}

let is_open src s = match src.status s with Open -> true | Known _ | Elsewhere -> false

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
  starts : int array;  (** of rows *)
  constants : Rat.t array;
  near_constants : float array;
  origins : int array;
  leaking : Bits.t;
  nodes : int array;
  nears : float array;
  branches : int array;
  others : Rat.t Growable.t;
  slot : int array;  (** where a node stands in the row that is being written, from its beginning; else -1 *)
}

let room src ~each order size =
  let rows = ref 0 and entries = ref 0 in
  Array.iter
    (fun s ->
       each s (fun s ->
           iter_rows src s (fun c ->
               incr rows;
               entries := !entries + Mdp.first_branch src.m (c + 1) - Mdp.first_branch src.m c)))
    order;
  {
    rows = 0;
    entries = 0;
    starts = Array.make (!rows + 1) 0;
    constants = Array.make !rows Rat.zero;
    near_constants = Array.make !rows 0.;
    origins = Array.make !rows 0;
    leaking = Bits.create !rows;
    nodes = Array.make !entries 0;
    nears = Array.make !entries 0.;
    branches = Array.make !entries 0;
    others = Growable.create ();
    slot = Array.make size (-1);
  }

let positive x = if x > 0. then x else Float.succ 0.

(* The probability of an entry, and a new one. *)
let entry src rows i =
  let b = rows.branches.(i) in
  if b >= 0 then Mdp.probability src.m b else Growable.get rows.others (-1 - b)

let put rows i p =
  Growable.push rows.others p;
  rows.branches.(i) <- -Growable.length rows.others;
  rows.nears.(i) <- positive (Rat.to_float p)

(* Adds the row of a choice, unless it leads to nothing but its own node. *)
let add_row src rows ~node_of ~same_part v c =
  let m = src.m and near = Mdp.near src.m in
  let base = rows.entries in
  let given = if src.rewards then Mdp.reward m c else Rat.zero in
  let constant = ref given and near_constant = ref (Rat.to_float given) in
  let add x near =
    if Rat.sign !constant = 0 then begin
      constant := x;
      near_constant := near
    end
    else begin
      constant := Rat.add !constant x;
      near_constant := Rat.to_float !constant
    end
  in
  let own = ref Rat.zero and outside = ref false in
  for b = Mdp.first_branch m c to Mdp.first_branch m (c + 1) - 1 do
    let t = Mdp.target m b in
    match src.status t with
    | Elsewhere -> Scc_base.Bug.fail __POS__ "an open state leads to one that has no place in the equations"
    | Known x ->
      outside := true;
      if Rat.sign x > 0 then begin
        let p = Mdp.probability m b in
        if Rat.equal x Rat.one then add p near.(b)
        else
          let x = Rat.mul p x in
          add x (Rat.to_float x)
      end
    | Open ->
      let w = node_of t in
      if Int.equal w v then own := Rat.add !own (Mdp.probability m b)
      else begin
        if not (same_part w) then outside := true;
        let i = rows.slot.(w) in
        if i < 0 then begin
          let i = rows.entries in
          rows.slot.(w) <- i;
          rows.entries <- i + 1;
          rows.nodes.(i) <- w;
          rows.branches.(i) <- b;
          rows.nears.(i) <- positive near.(b)
        end
        else put rows i (Rat.add (entry src rows i) (Mdp.probability m b))
      end
  done;
  let last = rows.entries - 1 in
  for i = base to last do
    rows.slot.(rows.nodes.(i)) <- -1
  done;
  let own = !own in
  if Rat.sign own > 0 && Rat.equal own Rat.one then rows.entries <- base
  else begin
    if Rat.sign own > 0 then begin
      let rest = Rat.sub Rat.one own in
      constant := Rat.div !constant rest;
      near_constant := Rat.to_float !constant;
      for i = base to last do
        put rows i (Rat.div (entry src rows i) rest)
      done
    end;
    let r = rows.rows in
    if !outside then Bits.add rows.leaking r;
    rows.starts.(r) <- base;
    if Rat.sign !constant > 0 then begin
      rows.constants.(r) <- !constant;
      rows.near_constants.(r) <- !near_constant
    end;
    rows.origins.(r) <- c;
    rows.rows <- r + 1
  end

let of_growable g = Array.init (Growable.length g) (Growable.get g)

(* The groups numbered component by component, within one by increasing leaders; and where components begin. *)
let arranged components leaders_ =
  let parts = Array.make (Strong_components.count components + 1) 0 in
  Array.iter
    (fun s ->
       let k = Strong_components.number components s in
       parts.(k + 1) <- parts.(k + 1) + 1)
    leaders_;
  for k = 1 to Array.length parts - 1 do
    parts.(k) <- parts.(k) + parts.(k - 1)
  done;
  let next = Array.copy parts and order = Array.make (Array.length leaders_) 0 in
  Array.iter
    (fun s ->
       let k = Strong_components.number components s in
       order.(next.(k)) <- s;
       next.(k) <- next.(k) + 1)
    leaders_;
  (parts, order)

let make back direction ~status ~allowed ~merged ~rewards ~asked =
  let src = { m = Backwards.mdp back; status; allowed; merged; rewards } in
  let m = src.m in
  let n = Mdp.states m in
  let each = members src and leader = leaders src in
  let reached = reached src ~each ~leader asked in
  let found = Int_array.buffer () in
  let successors s =
    Int_array.clear found;
    each s (fun s ->
        iter_rows src s (fun c ->
            for b = Mdp.first_branch m c to Mdp.first_branch m (c + 1) - 1 do
              let t = Mdp.target m b in
              if is_open src t then Int_array.push found (leader t)
            done));
    Array.init (Int_array.size found) (Int_array.nth found)
  in
  let components = Strong_components.compute ~size:n ~inside:reached ~successors in
  let leaders_ = of_growable (let g = Growable.create () in
                              for s = 0 to n - 1 do
                                if reached s then Growable.push g s
                              done;
                              g)
  in
  let parts, order = arranged components leaders_ in
  let size = Array.length order in
  let node_of = Array.make n (-1) in
  Array.iteri (fun v s -> each s (fun s -> node_of.(s) <- v)) order;
  let part_of = Array.make size 0 in
  for k = 0 to Array.length parts - 2 do
    Array.fill part_of parts.(k) (parts.(k + 1) - parts.(k)) k
  done;
  let rows = room src ~each order size in
  let first_row = Array.make (size + 1) 0 in
  for v = 0 to size - 1 do
    let same_part w = Int.equal part_of.(w) part_of.(v) in
    each order.(v) (fun s -> iter_rows src s (add_row src rows ~node_of:(Array.get node_of) ~same_part v));
    first_row.(v + 1) <- rows.rows;
    if first_row.(v + 1) = first_row.(v) then Scc_base.Bug.fail __POS__ "an open state that nothing leaves"
  done;
  let count = rows.rows in
  rows.starts.(count) <- rows.entries;
  let used n a = if Array.length a = n then a else Array.sub a 0 n in
  {
    direction;
    size;
    parts;
    first_row;
    first_entry = used (count + 1) rows.starts;
    constant = used count rows.constants;
    near_constant = used count rows.near_constants;
    node = used rows.entries rows.nodes;
    near = used rows.entries rows.nears;
    mdp = m;
    branch = used rows.entries rows.branches;
    worked_out = of_growable rows.others;
    leaks = rows.leaking;
    choice = used count rows.origins;
    node_of;
  }

let row_sum e value r =
  let sum = ref e.constant.(r) in
  for i = e.first_entry.(r) to e.first_entry.(r + 1) - 1 do
    sum := Rat.add !sum (Rat.mul (probability e i) (value e.node.(i)))
  done;
  !sum
