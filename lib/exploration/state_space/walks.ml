open Scc_data
open Scc_exact
open Scc_geometry
open Scc_ctl
open Scc_calculus
open Scc_semantics
open Scc_evaluate

(* A process on its course through one step, by the number that it has when the step begins. *)
type course = {
  number : int;
  calm : bool;  (** by itself it does nothing but move, and it rests or is a walker that draws in the end *)
  walks : bool;  (** it is a walker *)
  rests : bool;
  box : Float_box.t;  (** about its sweep *)
  ended : int;  (** its number at rest where it is in the end, as if it were there from the beginning *)
  next : int;  (** its number in the end, while it waits to draw again *)
  unseen : bool;  (** no unit of its own tells [ended] from it *)
}

(* A walker that waits to draw. *)
type walker = {
  waiting : int;
  kicks : (int * Vec.t * Rat.t) array;  (** numbers when the step begins, velocities and chances *)
  stays : int;  (** when a kick is blocked *)
  able : bool;
}

type pair = { key : int; how : Blocked.together }

(* Two processes but for where they are as a whole: forms and velocities by their numbers, and the offset. *)
module Apart = struct
  type t = { forms : int * int; velocities : int * int; offset : Vec.t }

  let equal a b = a.forms = b.forms && a.velocities = b.velocities && Vec.equal a.offset b.offset

  let hash { forms = f, g; velocities = v, u; offset } =
    ((((((((f * 31) + g) * 31) + v) * 31) + u) * 31) + Vec.hash offset) land max_int
end

module Offsets = Hashtbl.Make (Apart)

type t = {
  local : Local.t;
  model : Model.t;
  own : (Course_units.t * (Trajectory.t -> Truth.t Timeline.t)) list;  (** units of one leaf *)
  shared : (Course_units.t * (Trajectory.t -> Truth.t Timeline.t)) list;  (** of several *)
  courses : course Recent.t;
  walkers : walker Recent.t;
  pairs : pair Recent.t;
  offsets : Blocked.together Offsets.t;
  most : int;
}

let catalogue w = Local.catalogue w.local
let leaves w = Array.length w.model.leaves
let timestep w = w.model.timestep

let no_course =
  {
    number = Catalogue.nobody; calm = false; walks = false; rests = true; ended = 0; next = 0; unseen = false;
    box = Float_box.make ~low:[| 0.; 0.; 0. |] ~high:[| 0.; 0.; 0. |];
  }

let no_walker = { waiting = Catalogue.nobody; kicks = [||]; stays = Catalogue.nobody; able = false }
let apart = { Blocked.blocks = false; sweeps = false; undisturbed = true }
let no_pair = { key = 0; how = apart }

(* Consecutive pairs of numbers are in different slots. *)
let spread key = (key * 0x9E3779B97F4A7C1) lsr 20

let make ~units ~most local =
  let semantics = Local.semantics local in
  let m = Semantics.model semantics in
  let waits = match m.blocked with Wait -> true | Bounce | Stop -> false in
  let at_once = Model.binds_on_contact m in
  let fits = waits && Option.is_none m.rigid && Model.of_all m in
  if fits && not (m.lots || at_once || Local.has_events local) then
    let predicate (u : Course_units.t) = (u, Trajectory.predicate semantics u.prop) in
    let is_own (u : Course_units.t) = match u.leaves with [ _ ] -> true | _ -> false in
    let own, shared = List.partition is_own units in
    Some
      {
        local; model = m;
        own = List.map predicate own;
        shared = List.map predicate shared;
        courses = Recent.create ~number:(fun c -> c.number) ~none:no_course ~most;
        walkers = Recent.create ~number:(fun w -> w.waiting) ~none:no_walker ~most;
        most;
        offsets = Offsets.create 64;
        pairs = Recent.create ~number:(fun p -> spread p.key) ~none:no_pair ~most:(16 * most);
      }
  else None

(* {1 One process} *)

let alone_calm (a : Local.alone) = (not a.nature.splits) && Option.is_none a.nature.wait

let timeless_law (m : Model.t) (l : State.leaf) =
  let is_time : Law.variable -> bool = function
    | Time | Dt -> true
    | X | Y | Z | Mass | Vx | Vy | Vz | Wx | Wy | Wz -> false
  in
  not (Law.mentions is_time m.leaves.(l.leaf).law)

let is_walker w (p : State.process) =
  Process.stops w.model p && Quotient.is_lost w.model p && Array.for_all (timeless_law w.model) p.leaves

let equal_timelines (a : Truth.t Timeline.t) (b : Truth.t Timeline.t) =
  let piece (p : Truth.t Timeline.piece) (q : Truth.t Timeline.piece) =
    Algebraic.compare p.cut q.cut = 0 && Truth.equal p.at q.at && Truth.equal p.after q.after
  in
  let simple t = Timeline.simplify Truth.equal t in
  let a = simple a and b = simple b in
  Truth.equal a.start b.start && Truth.equal a.first b.first
  && List.compare_lengths a.rest b.rest = 0
  && List.for_all2 piece a.rest b.rest

(* The truth of a unit along a step, for these processes. *)
let along w predicate processes =
  let s = State.make ~processes ~step:None ~time:None in
  predicate (Trajectory.make (Local.semantics w.local) s (Lasts w.model.timestep))

let tells w predicate processes others =
  not (equal_timelines (along w predicate processes) (along w predicate others))

let unseen w p ended =
  let concerns ((u : Course_units.t), _) = List.for_all (State.has_leaf p) u.leaves in
  let same (_, predicate) = not (tells w predicate [ p ] [ ended ]) in
  List.for_all same (List.filter concerns w.own)
  && List.for_all same (List.filter concerns w.shared)

let look w number =
  let a = Local.alone w.local number in
  let p = a.body.process and d = w.model.timestep in
  let walks = is_walker w p in
  let stays = a.rests && not (Process.steers w.model p) in
  let calm = alone_calm a && Option.is_none p.draw && (walks || stays) in
  if not calm then { no_course with number }
  else
    let ended = State.with_velocity Vec.zero (Time.pass_process w.model d p) in
    let next = if walks then State.with_draw (Some Waits) ended else ended in
    let box = Float_box.swept p.velocity ~until:(Float_box.up d) (Float_box.hull a.boxes) in
    {
      number; calm; walks; box;
      rests = a.rests;
      ended = Catalogue.process (catalogue w) ended;
      next = Catalogue.process (catalogue w) next;
      unseen = a.rests || unseen w p ended;
    }

let course w number =
  let c = Recent.get w.courses number in
  if c.number = number then c
  else begin
    let c = look w number in
    Recent.keep w.courses c;
    c
  end

let look_at_walker w number =
  let p = (Catalogue.body (catalogue w) number).process in
  let at velocity = Catalogue.process (catalogue w) (State.with_draw None (State.with_velocity velocity p)) in
  let unable = { no_walker with waiting = number } in
  if not (is_walker w p) then unable
  else
    match Steer.chances (Local.semantics w.local) (State.make ~processes:[ p ] ~step:None ~time:None) p with
    | Error _ -> unable
    | Ok kicks ->
      let kick ((g : Given.t), chance) = (at g.velocity, g.velocity, chance) in
      let kicks = Array.of_list (List.map kick kicks) and stays = at Vec.zero in
      let calm number = (course w number).calm in
      { waiting = number; kicks; stays; able = calm stays && Array.for_all (fun (k, _, _) -> calm k) kicks }

let walker w number =
  let found = Recent.get w.walkers number in
  if found.waiting = number then found
  else begin
    let found = look_at_walker w number in
    Recent.keep w.walkers found;
    found
  end

(* {1 Two processes} *)

let by_offset w one two =
  let one = Catalogue.body (catalogue w) one and two = Catalogue.body (catalogue w) two in
  let place (b : Catalogue.body) = b.process.leaves.(0).position in
  let key =
    {
      Apart.forms = (one.form, two.form); velocities = (one.velocity, two.velocity);
      offset = Vec.sub (place two) (place one);
    }
  in
  match Offsets.find_opt w.offsets key with
  | Some how -> how
  | None ->
    let how = Blocked.together (Local.afresh w.local) one.process two.process in
    if Offsets.length w.offsets >= w.most then Offsets.reset w.offsets;
    Offsets.add w.offsets key how;
    how

let together w a b =
  if not (Float_box.meet a.box b.box) then apart
  else begin
    let one = Int.min a.number b.number and two = Int.max a.number b.number in
    let key = (one lsl 31) lor two in
    let found = Recent.get w.pairs (spread key) in
    if found.key = key then found.how
    else begin
      let how = by_offset w one two in
      Recent.keep w.pairs { key; how };
      how
    end
  end

let rec undisturbed w = function
  | [] -> true
  | a :: rest ->
    let clear b = (a.rests && b.rests) || (together w a b).undisturbed in
    List.for_all clear rest && undisturbed w rest

(* {1 Steps in which nothing is seen} *)


let begins w tuple =
  match Catalogue.step (catalogue w) tuple with
  | Some { phase = Steered; remaining } -> Rat.equal remaining w.model.timestep
  | Some { phase = Moving | Due; _ } | None -> false

(* The courses of a step that begins, if nothing happens before all walkers draw again, and these are several. *)
let courses w tuple =
  let rec from i found walkers =
    if i < 0 then if walkers > 1 then Some found else None
    else if tuple.(i) = Catalogue.nobody then from (i - 1) found walkers
    else
      let c = course w tuple.(i) in
      if c.calm then from (i - 1) (c :: found) (if c.walks then walkers + 1 else walkers) else None
  in
  if not (begins w tuple) then None
  else
    match from (leaves w - 1) [] 0 with
    | Some found when undisturbed w found -> Some found
    | Some _ | None -> None

(* No unit of several processes tells the ends of some courses from the courses. *)
let none_tells w courses ended =
  let process number = (Catalogue.body (catalogue w) number).process in
  let tells_one ((u : Course_units.t), predicate) =
    let has (c, _) = List.exists (State.has_leaf (process c.number)) u.leaves in
    let homes = List.filter has (List.combine courses ended) in
    List.exists (fun (c, e) -> c.number <> e.number) homes
    && tells w predicate
      (List.map (fun (c, _) -> process c.number) homes)
      (List.map (fun (_, e) -> process e.number) homes)
  in
  w.shared = [] || not (List.exists tells_one w.shared)

let exchanged w tuple courses number =
  let copy = Array.copy tuple in
  let exchange c = copy.(Catalogue.first_leaf (Catalogue.body (catalogue w) c.number).process) <- number c in
  List.iter exchange courses;
  copy

(* Those that a unit sees move on, if they do not meet the others where these are in the end. *)
let standing w tuple =
  match courses w tuple with
  | None -> tuple
  | Some found ->
    let ended c = if c.unseen && not c.rests then course w c.ended else c in
    let after = List.map ended found in
    if List.for_all2 (fun c e -> c.number = e.number) found after then tuple
    else if undisturbed w after && none_tells w found after then
      exchanged w tuple found (fun c -> (ended c).number)
    else tuple

let pass w tuple =
  let able c = (not c.walks) || (walker w c.next).able in
  match courses w tuple with
  | Some found when List.for_all able found ->
    let d = w.model.timestep in
    let catalogue = catalogue w in
    let next = exchanged w tuple found (fun c -> c.next) in
    Catalogue.put_rest catalogue next ~step:(Some { State.remaining = Rat.zero; phase = Due }) ~time:None;
    Option.iter (fun n -> next.(Catalogue.time_slot catalogue) <- n) (Catalogue.time_after catalogue tuple d);
    Some (Catalogue.time_label catalogue d, next)
  | Some _ | None -> None
