open Scc_data
open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_graph_search
open Components

type label = Components.label = One of Transition.label | Tied of Transition.label * Rat.t | Joint of joint
type nonrec joint = joint = { chance : Rat.t; transitions : int }

let hash_label = hash_label

type body = { number : int; form : int; place : int; velocity : int; process : State.process }

(* What things are to other processes. *)
type texts = {
  process : State.process -> string;
  of_process : string -> State.process;
  label : label -> string;
  of_label : string -> label;
  step : State.step -> string;
  of_step : string -> State.step;
  time : Rat.t -> string;
  of_time : string -> Rat.t;
}

type t = {
  model : Model.t;
  time_seen : Scc_property.Time_seen.t;
  marked : bool;
  vectors : Vectors.t;
  forms : Forms.t;
  labels : Labels.t;
  steps : Steps.t;
  times : Rationals.t;
  places : Pairs.t;  (** form and place *)
  processes : Pairs.t;  (** the pair before, and velocity *)
  recent : body Recent.t;
  seen : body array;  (** by slots: those last given out or numbered *)
  mutable bits : int;  (** the length of the longest number *)
  mutable all_bits : Scc_shared.Shared_memory.numbers option;  (** the same, of all processes *)
  mutable texts : texts option;  (** where numbers are shared with other processes *)
  of_processes : Common.numbers;
  of_labels : Common.numbers;
  of_steps : Common.numbers;
  of_times : Common.numbers;
  mutable passed : Rat.t * int;  (** how long time passed last, and the label of that *)
}

(* Numbers of processes begin at 1. *)
let nobody = 0

let no_body =
  let leaf =
    {
      State.leaf = 0;
      position = Vec.zero;
      turned = Quaternion.identity;
      waited = Rat.zero;
      behaviour = Behaviour.fresh Behaviour.nil;
    }
  in
  let process = State.process ~leaves:[ leaf ] ~bonds:[] ~velocity:Vec.zero ~clock:None () in
  { number = nobody; form = 0; place = 0; velocity = 0; process }

let create ~marked ~time_seen ~memory model =
  let vectors = Vectors.create () in
  ignore (Vectors.number vectors Vec.zero);
  {
    model; time_seen; marked; vectors;
    forms = Forms.create ();
    labels = Labels.create ();
    steps = Steps.create ();
    times = Rationals.create ();
    (* Processes that are forked from this one go on with them by themselves. *)
    places = Pairs.create ~in_files:false;
    processes = Pairs.create ~in_files:false;
    recent = Recent.create ~number:(fun b -> b.number) ~none:no_body ~most:memory;
    seen = Array.make (Array.length model.leaves) no_body;
    bits = 0;
    all_bits = None;
    texts = None;
    of_processes = Common.numbers ();
    of_labels = Common.numbers ();
    of_steps = Common.numbers ();
    of_times = Common.numbers ();
    passed = (Rat.zero, -1);
  }

let model c = c.model
let time_seen c = c.time_seen
let leaves c = Array.length c.model.leaves
let option_slot used = if used then 1 else 0
let step_slot = leaves
let time_slot c = leaves c + option_slot (Model.of_all c.model)
let mark_slot c = time_slot c + option_slot c.model.keeps_time

type slot = Process | Step | Time | Mark

let slot c i =
  if i < leaves c then Process
  else if Model.of_all c.model && i = step_slot c then Step
  else if c.model.keeps_time && i = time_slot c then Time
  else if c.marked then Mark
  else Process

(** {2 Numbers}

    Tables have the things by own numbers; whatever leaves this module are common ones ({!Common}). *)

let texts c = match c.texts with Some t -> t | None -> Scc_base.Bug.fail __POS__ "numbers without texts"

let step_number c s =
  Common.common c.of_steps (Steps.number c.steps s) (fun own -> (texts c).step (Steps.get c.steps own))

let step_of_number c i =
  Steps.get c.steps (Common.own c.of_steps i (fun text -> Steps.number c.steps ((texts c).of_step text)))

let common_time c own = Common.common c.of_times own (fun own -> (texts c).time (Rationals.get c.times own))

let rational c i =
  Rationals.get c.times (Common.own c.of_times i (fun text -> Rationals.intern c.times ((texts c).of_time text)))

let label_number c l =
  Common.common c.of_labels (Labels.number c.labels l) (fun own -> (texts c).label (Labels.get c.labels own))

(* A tied label comes with the label itself, as it does where it is made. *)
let own_label c text =
  let label = (texts c).of_label text in
  (match label with Tied (l, _) -> ignore (Labels.number c.labels (One l)) | One _ | Joint _ -> ());
  Labels.number c.labels label

let any_label c i = Labels.get c.labels (Common.own c.of_labels i (own_label c))

(* The tuple of the empty network has a slot all the same. *)
let width c = Int.max 1 (mark_slot c + option_slot c.marked)
let bodies c = Pairs.size c.processes
let resting _ velocity = velocity = 0
let first_leaf (p : State.process) = p.leaves.(0).leaf

let moved by (p : State.process) =
  if Vec.is_zero by then p
  else State.map_leaves (fun l -> { l with position = Vec.add l.position by }) p

(* Only what is new can be longer than all before. *)
let measured c bits =
  if bits > c.bits then begin
    c.bits <- bits;
    Option.iter (fun all -> Scc_shared.Shared_memory.raise_to all 0 bits) c.all_bits
  end

let measure c ~known ~(number : int) bits = if number = known then measured c (bits ())

let vector c v =
  let known = Vectors.size c.vectors in
  let number = Vectors.number c.vectors v in
  measure c ~known ~number (fun () -> Vec.bits v);
  number

let form_of c (p : State.process) =
  let known = Forms.size c.forms in
  let number = Forms.number c.forms p in
  let longest () = List.fold_left (fun most (_, bits) -> Int.max most bits) 0 (Length.of_process p) in
  measure c ~known ~number longest;
  number

(* Own numbers of processes begin at 1, too. *)
let own_number c ~form ~place ~velocity =
  1 + Pairs.intern c.processes (Pairs.intern c.places form place) velocity

let own_process c own =
  let placed = Pairs.left c.processes (own - 1) and velocity = Pairs.right c.processes (own - 1) in
  let form = Pairs.left c.places placed and place = Pairs.right c.places placed in
  let process =
    Forms.get c.forms form
    |> moved (Vectors.get c.vectors place)
    |> State.with_velocity (Vectors.get c.vectors velocity)
  in
  { number = own; form; place; velocity; process }

let numbered c ~form ~place ~velocity =
  Common.common c.of_processes (own_number c ~form ~place ~velocity) (fun own ->
      (texts c).process (own_process c own).process)

let parts c (p : State.process) =
  let place = p.leaves.(0).position in
  let form = form_of c (State.with_velocity Vec.zero (moved (Vec.neg place) p)) in
  (form, vector c place, vector c p.velocity)

let find_number c slot (p : State.process) =
  let form, place, velocity = parts c p in
  let number = numbered c ~form ~place ~velocity in
  c.seen.(slot) <- { number; form; place; velocity; process = p };
  number

(* Most processes are after a transition what they were before it. *)
let process c p =
  let slot = first_leaf p in
  let b = c.seen.(slot) in
  if b.process == p then b.number else find_number c slot p

let made c number =
  let make text =
    let form, place, velocity = parts c ((texts c).of_process text) in
    own_number c ~form ~place ~velocity
  in
  { (own_process c (Common.own c.of_processes number make)) with number }

let body c number =
  let b = Recent.get c.recent number in
  if b.number = number then b
  else begin
    let b = made c number in
    Recent.keep c.recent b;
    b
  end

let memory = 1 lsl 12

let remembered c any f =
  let known = Array.make memory nobody and values = Array.make memory any in
  fun number ->
    let k = number land (memory - 1) in
    if known.(k) = number then values.(k)
    else begin
      let v = f (body c number).process in
      known.(k) <- number;
      values.(k) <- v;
      v
    end

let displaced c d b =
  let velocity = Vectors.get c.vectors b.velocity in
  let place = Vec.axpy d velocity (Vectors.get c.vectors b.place) in
  numbered c ~form:b.form ~place:(vector c place) ~velocity:b.velocity

let shifted c by number =
  let b = body c number in
  numbered c ~form:b.form ~place:(vector c (Vec.add (Vectors.get c.vectors b.place) by)) ~velocity:b.velocity

let form c i = Forms.get c.forms i

let time_number c time =
  let seen = Scc_property.Time_seen.representative c.time_seen time in
  measured c (Rat.bits seen);
  common_time c (Rationals.intern c.times seen)

let rational_number = time_number

let put_rest c tuple ~step ~time =
  Option.iter (fun step -> tuple.(step_slot c) <- step_number c step) step;
  Option.iter (fun time -> tuple.(time_slot c) <- time_number c time) time

let encode c (s : State.t) =
  let tuple = Array.make (width c) nobody in
  Array.iter (fun p -> tuple.(first_leaf p) <- process c p) s.processes;
  put_rest c tuple ~step:s.step ~time:s.time;
  tuple

let step c tuple = if Model.of_all c.model then Some (step_of_number c tuple.(step_slot c)) else None

let same_rest c (a : int array) b =
  let rec from i = i >= width c || (a.(i) = b.(i) && from (i + 1)) in
  from (leaves c)

let time c tuple =
  if c.model.keeps_time then Some (rational c tuple.(time_slot c)) else None

let decode c tuple =
  let n = leaves c in
  let rec processes i acc =
    if i < 0 then acc
    else if tuple.(i) = nobody then processes (i - 1) acc
    else begin
      let b = body c tuple.(i) in
      c.seen.(i) <- b;
      processes (i - 1) (b.process :: acc)
    end
  in
  State.make ~processes:(processes (n - 1) []) ~step:(step c tuple) ~time:(time c tuple)

let time_after c tuple d =
  if c.model.keeps_time then Some (time_number c (Rat.add (rational c tuple.(time_slot c)) d)) else None

let label c l = label_number c (One l)

let tied c l chance =
  ignore (label c l);
  label_number c (Tied (l, chance))

let label_of_transition c (t : Transition.t) =
  match t.chance with
  | Some chance when not (Transition.is_drawn t.label) -> tied c t.label chance
  | Some _ | None -> label c t.label

let joint c j = label_number c (Joint j)

(* Of many states one after the other it is the same. *)
let time_label c d =
  match c.passed with
  | known, label when label >= 0 && Rat.equal known d -> label
  | _ ->
    let label = label c (Transition.Time d) in
    c.passed <- (d, label);
    label

let single c i = match any_label c i with One l | Tied (l, _) -> Some l | Joint _ -> None

let label_of c i =
  match single c i with Some l -> l | None -> Scc_base.Bug.fail __POS__ "several transitions for one"

let chance c i =
  match any_label c i with
  | Joint j -> Some j.chance
  | Tied (_, chance) -> Some chance
  | One l -> if Transition.is_drawn l then Some (Transition.chance l) else None

let transitions c i = match any_label c i with Joint j -> j.transitions | One _ | Tied _ -> 1

let labels c =
  List.filter_map (function One l -> Some l | Tied _ | Joint _ -> None) (Labels.keys c.labels)

let has_events c =
  let is_event = function Joint _ -> true | One l | Tied (l, _) -> not (Transition.is_time l) in
  List.exists is_event (Labels.keys c.labels)

let duration c i = match any_label c i with One l -> Transition.duration_of l | Tied _ | Joint _ -> Rat.zero

let greatest_bits c = match c.all_bits with None -> c.bits | Some all -> Scc_shared.Shared_memory.read all 0

let share c table texts =
  match Scc_shared.Shared_memory.numbers 1 with
  | None -> false
  | Some all ->
    all.{0} <- c.bits;
    c.all_bits <- Some all;
    c.texts <- Some texts;
    Common.share c.of_processes table ~kind:0 ~base:(1 + Pairs.size c.processes);
    Common.share c.of_labels table ~kind:1 ~base:(Labels.size c.labels);
    Common.share c.of_steps table ~kind:2 ~base:(Steps.size c.steps);
    Common.share c.of_times table ~kind:3 ~base:(Rationals.size c.times);
    true

let numbers_so_far c =
  List.fold_left Int.max 0
    [ 1 + Pairs.size c.processes; Labels.size c.labels; Steps.size c.steps; Rationals.size c.times ]

let longest c =
  let greatest count bits =
    let rec from i most = if i = count then most else from (i + 1) (Int.max most (bits i)) in
    from 0 0
  in
  let vector i = Vec.bits (Vectors.get c.vectors i) in
  let in_form of_process i = of_process (Forms.get c.forms i) in
  let turned (p : State.process) =
    Array.fold_left (fun most (l : State.leaf) -> Int.max most (Quaternion.bits l.turned)) 0 p.leaves
  in
  [
    ("positions", greatest (Pairs.size c.places) (fun i -> vector (Pairs.right c.places i)));
    ("velocities", greatest (Pairs.size c.processes) (fun i -> vector (Pairs.right c.processes i)));
  ]
  @
  match c.model.rigid with
  | None -> []
  | Some { dynamics; _ } ->
    let of_forms name bits = (name, greatest (Forms.size c.forms) (in_form bits)) in
    let kept =
      match dynamics with
      | Constant_spin -> []
      | Free_body -> [ of_forms "angular_momenta" (fun p -> Vec.bits p.kept) ]
    in
    [ of_forms "spins" (fun p -> Vec.bits p.spin); of_forms "orientations" turned ] @ kept
