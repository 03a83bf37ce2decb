open Scc_data
open Scc_exact
open Scc_ctl
open Scc_graph_search
open Scc_successors

type note =
  | Fault of string
  | End of string
  | Ahead of { goal : int; met : Timeline.moment option; doubtful : Timeline.moment option }

type t = {
  part : Part.t;
  mesh : Mesh.t;
  records : Records.t array;  (** by owner *)
  sent : Sent.t;
  near : Tuples.spread;
  mutable homes : int array;  (** of the targets of a state, by choice; of those that are the state itself, any *)
  mutable prints : Keys.fingerprint array;  (** of those of others, one after the other *)
  mutable touched : int;  (** of no meaning *)
  mutable round : int;
  timed : Timed_labels.t;
  marks : (int * int) Growable.t;  (** of times, by their numbers: two words of a digest *)
}

let make part mesh records ~sent =
  let context = Filter.context (Part.filter part) in
  let duration = Scc_state_space.Network_lts.duration context in
  let timed = Timed_labels.create ~duration ~transitions:(Scc_state_space.Network_lts.transitions context) in
  {
    part; mesh; records; sent; timed;
    near = Tuples.spread (Part.table part);
    homes = [||]; prints = [||]; touched = 0; round = 0;
    marks = Growable.create ();
  }

let state = 'R'

(* So much is sent at once. *)
let enough = 16384

let flush_one e peer =
  if Records.size e.records.(peer) > 0 then begin
    Mesh.send e.mesh peer state (Records.take e.records.(peer));
    1
  end
  else 0

let flush e = List.fold_left (fun n peer -> n + flush_one e peer) 0 (Mesh.others e.mesh)

let flush_full e =
  let each n peer = if Records.size e.records.(peer) > enough then n + flush_one e peer else n in
  List.fold_left each 0 (Mesh.others e.mesh)

let make_room e count =
  if count > Array.length e.homes then begin
    let size = 2 * count in
    e.homes <- Array.make size 0;
    e.prints <- Array.init size (fun _ -> Keys.no_fingerprint ())
  end

let change into (changes : Tuples.changes) =
  for i = 0 to (Array.length changes / 2) - 1 do
    into.(changes.(2 * i)) <- changes.((2 * i) + 1)
  done

let change_back into (changes : Tuples.changes) tuple =
  for i = 0 to (Array.length changes / 2) - 1 do
    let slot = changes.(2 * i) in
    into.(slot) <- tuple.(slot)
  done

(* {1 Times} *)

let takes_time e = Timed_labels.takes_time e.timed

let duration e label = Scc_state_space.Network_lts.duration (Filter.context (Part.filter e.part)) label

(* When a transition ends, of a state that is reached at the time [now]. *)
let time_after e ~now label =
  match Part.clock e.part with
  | None -> 0
  | Some clock ->
    if takes_time e label then Clock.number clock (Rat.add (Clock.time clock now) (duration e label)) else now

let mark e clock time =
  for k = Growable.length e.marks to time do
    let digest = Digest.string (Rat.to_string (Clock.time clock k)) in
    let word at = Int32.to_int (String.get_int32_le digest at) land 0xFFFF_FFFF in
    Growable.push e.marks (word 0, word 4)
  done;
  Growable.get e.marks time

(* A state that is reached at another time is another one to send. *)
let add_time e (print : Keys.fingerprint) time =
  match Part.clock e.part with
  | None -> ()
  | Some clock ->
    let a, b = mark e clock time in
    print.(1) <- print.(1) lxor a;
    print.(3) <- print.(3) lxor b

let next_round e = e.round <- e.round + 1

(* A transition without duration that leads back may close a cycle. Its target is sent in each round, to be seen
   there; it was found in an earlier one. Products of an odd number differ modulo 2^32. *)
let add_round e (print : Keys.fingerprint) label =
  if not (takes_time e label) then print.(2) <- print.(2) lxor ((e.round * 0x9E3779B1) land 0xFFFF_FFFF)

(* {1 Targets} *)

(* Where the targets belong: their owners, and the fingerprints of those of others. *)
let find_homes e tuple ~now changed steps =
  let keys = Filter.keys (Part.filter e.part) and count = Mesh.count e.mesh and me = Mesh.number e.mesh in
  let from = Keys.fingerprint keys tuple in
  let one (n, others) (s : Lts.step) =
    if Array.length s.changes = 0 then (n + 1, others)
    else begin
      change changed s.changes;
      let print = e.prints.(others) in
      Keys.move keys ~into:print from tuple s.changes changed;
      change_back changed s.changes tuple;
      let home = print.(0) mod count in
      e.homes.(n) <- home;
      if home = me then (n + 1, others)
      else begin
        add_time e print (time_after e ~now s.label);
        add_round e print s.label;
        e.touched <- e.touched lxor Sent.near e.sent print;
        (n + 1, others + 1)
      end
    end
  in
  ignore (List.fold_left one (0, 0) steps)

let prepare e steps =
  let table = Part.table e.part and me = Mesh.number e.mesh in
  let rec each n prepared = function
    | [] -> prepared
    | (s : Lts.step) :: rest ->
      if Array.length s.changes > 0 && e.homes.(n) = me then begin
        Tuples.prepare table ~near:e.near ~lasting:(not (takes_time e s.label)) s.changes prepared;
        each (n + 1) (prepared + 1) rest
      end
      else each (n + 1) prepared rest
  in
  Tuples.begin_round table ~near:e.near (List.length steps);
  Tuples.fetch table (each 0 0 steps)

(* Own targets are entered, and others sent unless they have been. Each is the source, changed for a moment. *)
let enter_all e id tuple ~now changed ~before steps =
  let table = Part.table e.part and me = Mesh.number e.mesh and instant = Part.instant e.part id in
  let rec each choice prepared others = function
    | [] -> choice
    | { Lts.changes = [||]; label } :: rest ->
      if not (takes_time e label) then Part.turns_at e.part id;
      each (choice + 1) prepared others rest
    | { Lts.changes; label } :: rest when e.homes.(choice) = me ->
      let known = Tuples.prepared table prepared in
      let time = time_after e ~now label and instant = if takes_time e label then 0 else instant + 1 in
      if known >= 0 then Part.again e.part known ~time ~instant ~sender:me ~before ~choice
      else begin
        change changed changes;
        Part.enter_prepared e.part prepared changed ~time ~instant ~sender:me ~before ~choice;
        change_back changed changes tuple
      end;
      each (choice + 1) (prepared + 1) others rest
    | { Lts.changes; label } :: rest ->
      if Sent.add e.sent e.prints.(others) then begin
        change changed changes;
        let time = time_after e ~now label and instant = if takes_time e label then 0 else instant + 1 in
        Records.put e.records.(e.homes.(choice)) ~time ~instant ~before ~choice changed;
        change_back changed changes tuple
      end;
      each (choice + 1) prepared (others + 1) rest
  in
  each 0 0 0 steps

let targets e id tuple ~now ~before steps =
  make_room e (List.length steps + 1);
  let changed = Array.copy tuple in
  if Mesh.count e.mesh > 1 then find_homes e tuple ~now changed steps;
  prepare e steps;
  enter_all e id tuple ~now changed ~before steps

let look_ahead note goal (ahead : Filter.ahead option) =
  match ahead with
  | None | Some { met = None; doubtful = None; _ } -> ()
  | Some { met; doubtful; _ } ->
    note (Ahead { goal; met = Option.map (fun (m : Filter.met) -> m.moment) met; doubtful })

let expand e id ~before ~note =
  Tuples.load (Part.table e.part) e.near id;
  let tuple = Tuples.slots e.near in
  match Filter.look (Part.filter e.part) tuple with
  | Error d ->
    note (Fault d.message);
    0
  | Ok (bare, ahead) -> (
      Array.iteri (look_ahead note) ahead;
      match bare with
      | Moves steps ->
        let now = Option.fold ~none:0 ~some:(fun clock -> Clock.arrival clock id) (Part.clock e.part) in
        targets e id tuple ~now ~before steps
      | Fault d ->
        note (Fault d.message);
        0
      | Ends d ->
        note (End d.message);
        0
      | Rests | Stops -> 0)
