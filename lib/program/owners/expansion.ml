open Scc_exact
open Scc_graph_search
open Scc_successors

type note = Fault of string | End of string | Ahead of { goal : int; sure : bool }

type t = {
  part : Part.t;
  mesh : Mesh.t;
  records : Records.t array;  (** by owner *)
  sent : Sent.t;
  near : Tuples.spread;
  mutable homes : int array;  (** of the targets of a state, by choice; of those that are the state itself, any *)
  mutable prints : Keys.fingerprint array;  (** of those of others, one after the other *)
  mutable touched : int;  (** of no meaning *)
}

let make part mesh records ~sent =
  { part; mesh; records; sent; near = Tuples.spread (Part.table part); homes = [||]; prints = [||]; touched = 0 }

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

(* Where the targets belong: their owners, and the fingerprints of those of others. *)
let find_homes e tuple changed steps =
  let keys = Filter.keys (Part.filter e.part) and count = Mesh.count e.mesh and me = Mesh.number e.mesh in
  let from = Keys.fingerprint keys tuple in
  let one (n, others) (s : Lts.step) =
    if s.changes = [||] then (n + 1, others)
    else begin
      change changed s.changes;
      let print = e.prints.(others) in
      Keys.move keys ~into:print from tuple s.changes changed;
      change_back changed s.changes tuple;
      let home = print.(0) mod count in
      e.homes.(n) <- home;
      if home = me then (n + 1, others)
      else begin
        e.touched <- e.touched lxor Sent.near e.sent print;
        (n + 1, others + 1)
      end
    end
  in
  ignore (List.fold_left one (0, 0) steps)

let prepare e steps =
  let table = Part.table e.part and me = Mesh.number e.mesh and context = Filter.context (Part.filter e.part) in
  let takes_time label = Rat.sign (Scc_state_space.Network_lts.duration context label) > 0 in
  let rec each n prepared = function
    | [] -> prepared
    | (s : Lts.step) :: rest ->
      if s.changes <> [||] && e.homes.(n) = me then begin
        Tuples.prepare table ~near:e.near ~lasting:(not (takes_time s.label)) s.changes prepared;
        each (n + 1) (prepared + 1) rest
      end
      else each (n + 1) prepared rest
  in
  Tuples.begin_round table ~near:e.near (List.length steps);
  Tuples.fetch table (each 0 0 steps)

(* Own targets are entered, and others sent unless they have been. Each is the source, changed for a moment. *)
let enter_all e tuple changed ~before steps =
  let table = Part.table e.part and me = Mesh.number e.mesh in
  let rec each choice prepared others = function
    | [] -> choice
    | { Lts.changes = [||]; _ } :: rest -> each (choice + 1) prepared others rest
    | { Lts.changes; _ } :: rest when e.homes.(choice) = me ->
      let known = Tuples.prepared table prepared in
      if known >= 0 then Part.again e.part known ~sender:me ~before ~choice
      else begin
        change changed changes;
        Part.enter_prepared e.part prepared changed ~sender:me ~before ~choice;
        change_back changed changes tuple
      end;
      each (choice + 1) (prepared + 1) others rest
    | { Lts.changes; _ } :: rest ->
      if Sent.add e.sent e.prints.(others) then begin
        change changed changes;
        Records.put e.records.(e.homes.(choice)) ~before ~choice changed;
        change_back changed changes tuple
      end;
      each (choice + 1) prepared (others + 1) rest
  in
  each 0 0 0 steps

let targets e tuple ~before steps =
  make_room e (List.length steps + 1);
  let changed = Array.copy tuple in
  if Mesh.count e.mesh > 1 then find_homes e tuple changed steps;
  prepare e steps;
  enter_all e tuple changed ~before steps

let look_ahead note goal (ahead : Filter.ahead option) =
  match ahead with
  | Some { met = Some _; _ } -> note (Ahead { goal; sure = true })
  | Some { met = None; doubt = Some _ } -> note (Ahead { goal; sure = false })
  | Some { met = None; doubt = None } | None -> ()

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
      | Moves steps -> targets e tuple ~before steps
      | Fault d ->
        note (Fault d.message);
        0
      | Ends d ->
        note (End d.message);
        0
      | Rests | Stops -> 0)
