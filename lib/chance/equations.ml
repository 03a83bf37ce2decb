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
  node : int array;
  probability : Rat.t array;
  near : float array;
  leaks : Bits.t;
  choice : int array;
  node_of : int array;
}

type status = Known of Rat.t | Open | Elsewhere

type source = {
  mdp : Mdp.t;
  status : int -> status;
  allowed : int -> bool;
  merged : Components.ends;
  rewards : bool;
}

let is_open src s = match src.status s with Open -> true | Known _ | Elsewhere -> false

(* The choices of a state that make rows. *)
let iter_rows src s f =
  for c = Mdp.first_choice src.mdp s to Mdp.first_choice src.mdp (s + 1) - 1 do
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
let reached src ~each ~leader ~asked =
  let n = Mdp.states src.mdp in
  let found = Worklist.create n in
  for s = 0 to n - 1 do
    if asked s && is_open src s then Worklist.add found (leader s)
  done;
  Worklist.run found (fun s ->
      each s (fun s ->
          iter_rows src s (fun c ->
              iter_branches src.mdp c (fun b ->
                  let t = Mdp.target src.mdp b in
                  if is_open src t then Worklist.add found (leader t)))));
  Worklist.mem found

(* Rows being written. *)
type rows = {
  row_starts : int Growable.t;
  constants : Rat.t Growable.t;
  nodes : int Growable.t;
  probabilities : Rat.t Growable.t;
  nears : float Growable.t;
  origins : int Growable.t;
  leaking : int Growable.t;
  slot : int array;  (** where a node stands in the row that is being written, from its beginning; else -1 *)
}

let positive x = if x > 0. then x else Float.succ 0.

(* Adds the row of a choice, unless it leads to nothing but its own node. *)
let add_row src rows ~node_of ~same_part v c =
  let m = src.mdp and near = Mdp.near src.mdp in
  let base = Growable.length rows.nodes in
  let constant = ref (if src.rewards then Mdp.reward m c else Rat.zero) in
  let own = ref Rat.zero and outside = ref false and plain = ref true in
  iter_branches m c (fun b ->
      let t = Mdp.target m b and p = Mdp.probability m b in
      match src.status t with
      | Elsewhere -> Scc_base.Bug.fail __POS__ "an open state leads to one that has no place in the equations"
      | Known x ->
        outside := true;
        if Rat.equal x Rat.one then constant := Rat.add !constant p
        else if Rat.sign x > 0 then constant := Rat.add !constant (Rat.mul p x)
      | Open ->
        let w = node_of t in
        if Int.equal w v then own := Rat.add !own p
        else begin
          if not (same_part w) then outside := true;
          if rows.slot.(w) < 0 then begin
            rows.slot.(w) <- Growable.length rows.nodes;
            Growable.push rows.nodes w;
            Growable.push rows.probabilities p;
            Growable.push rows.nears near.(b)
          end
          else begin
            plain := false;
            let i = rows.slot.(w) in
            Growable.set rows.probabilities i (Rat.add (Growable.get rows.probabilities i) p)
          end
        end);
  let last = Growable.length rows.nodes - 1 in
  for i = base to last do
    rows.slot.(Growable.get rows.nodes i) <- -1
  done;
  let rest = Rat.sub Rat.one !own in
  if Rat.sign rest > 0 then begin
    let divided = Rat.sign !own > 0 in
    if divided then begin
      constant := Rat.div !constant rest;
      for i = base to last do
        Growable.set rows.probabilities i (Rat.div (Growable.get rows.probabilities i) rest)
      done
    end;
    for i = base to last do
      let x =
        if divided || not !plain then Rat.to_float (Growable.get rows.probabilities i)
        else Growable.get rows.nears i
      in
      Growable.set rows.nears i (positive x)
    done;
    if !outside then Growable.push rows.leaking (Growable.length rows.origins);
    Growable.push rows.row_starts base;
    Growable.push rows.constants !constant;
    Growable.push rows.origins c
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
  let src = { mdp = Backwards.mdp back; status; allowed; merged; rewards } in
  let m = src.mdp in
  let n = Mdp.states m in
  let each = members src and leader = leaders src in
  let reached = reached src ~each ~leader ~asked in
  let successors s =
    let found = Int_array.buffer () in
    each s (fun s ->
        iter_rows src s (fun c ->
            iter_branches m c (fun b ->
                let t = Mdp.target m b in
                if is_open src t then Int_array.push found (leader t))));
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
  let rows =
    {
      row_starts = Growable.create ();
      constants = Growable.create ();
      nodes = Growable.create ();
      probabilities = Growable.create ();
      nears = Growable.create ();
      origins = Growable.create ();
      leaking = Growable.create ();
      slot = Array.make size (-1);
    }
  in
  let first_row = Array.make (size + 1) 0 in
  for v = 0 to size - 1 do
    let same_part w = Int.equal part_of.(w) part_of.(v) in
    each order.(v) (fun s -> iter_rows src s (add_row src rows ~node_of:(Array.get node_of) ~same_part v));
    first_row.(v + 1) <- Growable.length rows.origins;
    if first_row.(v + 1) = first_row.(v) then Scc_base.Bug.fail __POS__ "an open state that nothing leaves"
  done;
  let count = Growable.length rows.origins in
  let leaks = Bits.create count in
  for i = 0 to Growable.length rows.leaking - 1 do
    Bits.add leaks (Growable.get rows.leaking i)
  done;
  {
    direction;
    size;
    parts;
    first_row;
    first_entry =
      Array.init (count + 1) (fun r ->
          if r = count then Growable.length rows.nodes else Growable.get rows.row_starts r);
    constant = of_growable rows.constants;
    node = of_growable rows.nodes;
    probability = of_growable rows.probabilities;
    near = of_growable rows.nears;
    leaks;
    choice = of_growable rows.origins;
    node_of;
  }

let row_sum e value r =
  let sum = ref e.constant.(r) in
  for i = e.first_entry.(r) to e.first_entry.(r + 1) - 1 do
    sum := Rat.add !sum (Rat.mul e.probability.(i) (value e.node.(i)))
  done;
  !sum
