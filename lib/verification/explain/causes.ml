open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_motion
open Scc_property
module Ints = Set.Make (Int)

type run = { declared : State.t; course : Course.t; over : int list option }

type aspect = Motion | Structure | Behaviour | Clock | Itself
type reason = { cause : int; aspect : aspect; leaf : int }
type happening = Discrete of Transition.label | Expiry of int

type event = {
  step : int;
  time : Rat.t;
  happening : happening;
  leaves : int list;
  reasons : reason list;
}

(* By leaf: the event that last changed it, -1 for none. *)
type last = { motion : int array; structure : int array; behaviour : int array; clock : int array }

type t = { run : run; events : event array; last : last; duration : Rat.t }
type basis = { reasons : reason list; leaves : int list }

let run t = t.run
let events t = t.events
let duration t = t.duration

(* {1 Reasons} *)

let order a b =
  Int.compare a.cause b.cause <?> fun () ->
    compare a.aspect b.aspect <?> fun () -> Int.compare a.leaf b.leaf

let changed table aspect leaf = if table.(leaf) < 0 then [] else [ { cause = table.(leaf); aspect; leaf } ]

(* The leaves of a process share what is its own: the same change is told once, of its first leaf. *)
let of_process table aspect leaves =
  let add (seen, found) leaf =
    match changed table aspect leaf with
    | [ r ] when not (Ints.mem r.cause seen) -> (Ints.add r.cause seen, r :: found)
    | _ -> (seen, found)
  in
  snd (List.fold_left add (Ints.empty, []) leaves)

let motion_of last = of_process last.motion Motion
let structure_of last = of_process last.structure Structure
let clock_of last = of_process last.clock Clock
let behaviour_of last leaves = List.concat_map (changed last.behaviour Behaviour) leaves

(* {1 The events of a run} *)

let home s leaf = Option.fold ~none:[] ~some:State.members (State.home s leaf)

(* The leaf that takes part itself stands for its process. *)
let first (leaf : int) leaves = leaf :: List.filter (fun l -> l <> leaf) leaves

type telling = {
  semantics : Semantics.t;
  model : Model.t;
  at : last;
  mutable told : event list;
  mutable count : int;
}

let tell_event w ~step ~time happening leaves reasons =
  let leaves = List.sort_uniq Int.compare leaves and reasons = List.sort_uniq order reasons in
  w.told <- { step; time; happening; leaves; reasons } :: w.told;
  w.count <- w.count + 1;
  w.count - 1

let set table event leaves = List.iter (fun l -> table.(l) <- event) leaves

let expires (m : Model.t) d (l : State.leaf) =
  match Behaviours.horizon m.definitions l.behaviour with
  | Some h -> Rat.compare h d <= 0
  | None -> false

(* What expires at the end of a passing of time. All at once: none is a reason for another. *)
let expiries w ~step ~time d (source : State.t) =
  let of_one (p : State.process) =
    let expiring = List.filter (expires w.model d) (Array.to_list p.leaves) in
    List.map (fun (l : State.leaf) -> (l.leaf, State.members p)) expiring
  in
  let all = List.concat_map of_one (Array.to_list source.processes) in
  let tell (leaf, process) =
    let reasons = behaviour_of w.at [ leaf ] in
    (tell_event w ~step ~time (Expiry leaf) [ leaf ] reasons, leaf, process)
  in
  List.iter
    (fun (event, leaf, process) ->
       set w.at.behaviour event [ leaf ];
       set w.at.clock event process)
    (List.map tell all)

(* The leaves at which two processes touch that collide: that they offer no bond makes it a bounce. *)
let touching semantics (source : State.t) firsts =
  let of_meeting (m : Kinematics.meeting) =
    List.concat_map (fun ((a : Part.t), (b : Part.t)) -> [ a.leaf.leaf; b.leaf.leaf ]) m.touching
  in
  let processes = Array.of_list (List.filter_map (State.home source) firsts) in
  List.concat_map of_meeting (Collisions.meetings semantics processes)

let same_motion (p : State.process) (q : State.process) =
  Vec.equal p.velocity q.velocity && Vec.equal p.spin q.spin

let set_motion w event source target leaves =
  let moves_on l =
    match (State.home source l, State.home target l) with
    | Some before, Some after -> same_motion before after
    | None, _ | _, None -> false
  in
  set w.at.motion event (List.filter (fun l -> not (moves_on l)) leaves)

(* That processes collide: of each, its leaves, and those that offer no bond, or one. *)
let reasons_to_collide at processes ~behaving =
  List.concat_map (fun leaves -> motion_of at leaves @ structure_of at leaves) processes
  @ behaviour_of at behaving

let collision w ~step ~time label source target some ~behaving =
  let processes = List.map (fun p -> first p (home source p)) some in
  let all = List.concat processes in
  let reasons = reasons_to_collide w.at processes ~behaving in
  let event = tell_event w ~step ~time (Discrete label) all reasons in
  set_motion w event source target all;
  set w.at.clock event all;
  (event, all)

(* What a process does by itself to bonds of its own. *)
let by_itself w ~step ~time label source target ~clocked =
  let bonds = Transition.bonds label in
  let ends = List.concat_map (fun (b : State.bond) -> [ b.one.at; b.two.at ]) bonds in
  let ends = List.sort_uniq Int.compare ends in
  let leaves = match ends with [] -> [] | leaf :: _ -> first leaf (home source leaf) in
  let reasons =
    structure_of w.at leaves @ behaviour_of w.at ends @ if clocked then clock_of w.at leaves else []
  in
  let event = tell_event w ~step ~time (Discrete label) leaves reasons in
  (* a push changes where the pieces go *)
  set_motion w event source target leaves;
  set w.at.structure event leaves;
  set w.at.clock event leaves;
  set w.at.behaviour event ends

let transition w ~step ~time (label : Transition.label) source target =
  match label with
  | Time d -> expiries w ~step ~time d source
  | Bind b ->
    let p = b.one.at and q = b.two.at in
    let event, both = collision w ~step ~time label source target [ p; q ] ~behaving:[ p; q ] in
    set w.at.structure event both;
    set w.at.behaviour event [ p; q ]
  | Bounce { firsts; _ } ->
    let behaving = touching w.semantics source firsts in
    ignore (collision w ~step ~time label source target firsts ~behaving)
  | Absorb { first; absorber } ->
    let event, all = collision w ~step ~time label source target [ first; absorber ] ~behaving:[] in
    let gone = List.filter (fun l -> l <> absorber) all in
    set w.at.structure event gone;
    set w.at.behaviour event gone
  | Draw { first = leaf; _ } ->
    (* what it draws is how it goes on, also where it goes on as before *)
    let leaves = first leaf (home source leaf) in
    let reasons = motion_of w.at leaves @ structure_of w.at leaves in
    let event = tell_event w ~step ~time (Discrete label) leaves reasons in
    set w.at.motion event leaves
  | Lot { bond = b; _ } ->
    (* what is to be released is what its two leaves may do next *)
    let ends = [ b.one.at; b.two.at ] in
    let reasons = structure_of w.at ends @ behaviour_of w.at ends in
    let event = tell_event w ~step ~time (Discrete label) ends reasons in
    set w.at.behaviour event ends
  | Close _ -> by_itself w ~step ~time label source target ~clocked:false
  | Weak_split _ -> by_itself w ~step ~time label source target ~clocked:true
  | Strong_split _ -> by_itself w ~step ~time label source target ~clocked:false

let tell (run : run) =
  let semantics = Course.semantics run.course in
  let model = Semantics.model semantics in
  let none () = Array.make (Array.length model.leaves) (-1) in
  let at = { motion = none (); structure = none (); behaviour = none (); clock = none () } in
  let w = { semantics; model; at; told = []; count = 0 } in
  Array.iteri
    (fun step (leg : Course.leg) ->
       let time = Rat.add leg.start (Transition.duration_of leg.label) in
       transition w ~step ~time leg.label leg.before leg.after)
    (Course.legs run.course);
  { run; events = Array.of_list (List.rev w.told); last = at; duration = Course.duration run.course }

(* {1 Facts} *)

let model t = Semantics.model (Course.semantics t.run.course)
let everyone t = List.init (Array.length (model t).leaves) Fun.id
let movable t = List.filter (fun l -> not (model t).leaves.(l).fixed) (everyone t)

let joins (p, q) (b : State.bond) = (b.one.at = p && b.two.at = q) || (b.one.at = q && b.two.at = p)

(* The events that made or released bonds of a kind, and the leaves that have such a bond. *)
let bonds t wanted =
  let of_event cause (e : event) =
    match e.happening with
    | Expiry _ -> []
    | Discrete label ->
      let made = List.filter wanted (Transition.bonds label) in
      List.map (fun (b : State.bond) -> { cause; aspect = Structure; leaf = b.one.at }) made
  in
  let of_process (p : State.process) =
    List.concat_map
      (fun (b : State.bond) -> if wanted b then [ b.one.at; b.two.at ] else [])
      (Array.to_list p.bonds)
  in
  {
    reasons = List.(concat (mapi of_event (Array.to_list t.events)));
    leaves = List.concat_map of_process (Array.to_list (Course.initial t.run.course).processes);
  }

let of_everyone table aspect leaves = { reasons = of_process table aspect leaves; leaves }
let of_table table aspect leaves = { reasons = List.concat_map (changed table aspect) leaves; leaves }

let union bases =
  {
    reasons = List.sort_uniq order (List.concat_map (fun (b : basis) -> b.reasons) bases);
    leaves = List.sort_uniq Int.compare (List.concat_map (fun (b : basis) -> b.leaves) bases);
  }

let nothing = { reasons = []; leaves = [] }

let discrete_events t =
  let discrete (_, (e : event)) = match e.happening with Discrete _ -> true | Expiry _ -> false in
  List.filter discrete (List.mapi (fun i e -> (i, e)) (Array.to_list t.events))

let last_event t =
  match List.rev (discrete_events t) with
  | [] -> None
  | (cause, e) :: _ -> Some (cause, e)

let of_last_event t =
  match last_event t with
  | None -> nothing
  | Some (cause, e) ->
    let leaf = match e.leaves with l :: _ -> l | [] -> 0 in
    { reasons = [ { cause; aspect = Itself; leaf } ]; leaves = e.leaves }

(* The last transition, when the fact is about the instant right after it. *)
let arrival t =
  let course = t.run.course in
  match last_event t with
  | Some (_, e) when e.step = Array.length (Course.legs course) - 1 && Rat.sign (Course.rest course) = 0 ->
    of_last_event t
  | _ -> nothing

(* The bonds of the name, and between the leaves, that are the arguments of an atom. *)
let is_of (atom : Atom.t) (b : State.bond) =
  let fits_name : Atom.argument -> bool = function
    | Channel (_, a) -> String.equal a b.name
    | Leaf _ | Part _ | Definition _ | Parameter _ -> true
  in
  List.for_all fits_name atom.arguments
  &&
  match Atom.leaves atom with
  | [ p; q ] -> joins (p, q) b
  | _ -> true

let of_aspect t (atom : Atom.t) (aspect : Atom.aspect) =
  let of_leaves table aspect whose =
    match atom.scope with
    | Named -> of_table table aspect (Atom.leaves atom)
    | Whole -> of_everyone table aspect (whose t)
  in
  match aspect with
  | Absolute_time | Absolute_place | Speed -> nothing
  | Motion -> of_leaves t.last.motion Motion movable
  | Structure -> of_leaves t.last.structure Structure everyone
  | Split_clock -> of_leaves t.last.clock Clock everyone
  | Bonding -> bonds t (is_of atom)
  | Term -> (
      match atom.scope with
      | Named -> of_table t.last.behaviour Behaviour (Atom.leaves atom)
      | Whole -> of_table t.last.behaviour Behaviour (everyone t))

let of_atom t (atom : Atom.t) =
  let just_now = if Option.is_some atom.event then arrival t else nothing in
  union ({ nothing with leaves = Atom.leaves atom } :: just_now :: List.map (of_aspect t atom) atom.aspects)

let of_formula t f = union (List.rev_map (of_atom t) (Formula.atoms f))

let of_dead_end t =
  match t.run.over with
  | None -> nothing
  | Some firsts ->
    let s = Course.last t.run.course in
    let processes = List.map (fun leaf -> first leaf (home s leaf)) firsts in
    let behaving = touching (Course.semantics t.run.course) s firsts in
    {
      reasons = List.sort_uniq order (reasons_to_collide t.last processes ~behaving);
      leaves = List.sort_uniq Int.compare (List.concat processes);
    }

let closure t given =
  let marks = Array.make (Array.length t.events) false in
  List.iter (fun i -> marks.(i) <- true) given;
  for i = Array.length t.events - 1 downto 0 do
    if marks.(i) then List.iter (fun r -> marks.(r.cause) <- true) t.events.(i).reasons
  done;
  marks
