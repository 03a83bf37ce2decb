open Scc_graph_search
open Scc_successors

type note = Fault of string | End of string | Ahead of { goal : int; sure : bool }

type t = {
  part : Part.t;
  mesh : Mesh.t;
  records : Records.t array;  (** by owner *)
  sent : Sent.t;
  near : Tuples.spread;
  print : Keys.fingerprint;  (** to work with *)
}

let make part mesh records ~sent =
  { part; mesh; records; sent; near = Tuples.spread (Part.table part); print = Keys.no_fingerprint () }

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

let home e = e.print.(0) mod Mesh.count e.mesh

let target e tuple ~from target ~before choice (changes : Tuples.changes) =
  let me = Mesh.number e.mesh in
  let here () = ignore (Part.enter e.part ~near:e.near changes target ~sender:me ~before ~choice) in
  if Mesh.count e.mesh = 1 then here ()
  else begin
    Keys.move (Filter.keys (Part.filter e.part)) ~into:e.print from tuple changes target;
    let home = home e in
    if home = me then here ()
    else if Sent.add e.sent e.print then Records.put e.records.(home) ~before ~choice target
  end

(* Each target is the source, changed for a moment. *)
let targets e tuple ~before steps =
  let changed = Array.copy tuple in
  let from =
    if Mesh.count e.mesh = 1 then e.print else Keys.fingerprint (Filter.keys (Part.filter e.part)) tuple
  in
  let one choice (s : Lts.step) =
    let changes = s.changes in
    if Array.length changes > 0 then begin
      for i = 0 to (Array.length changes / 2) - 1 do
        changed.(changes.(2 * i)) <- changes.((2 * i) + 1)
      done;
      target e tuple ~from changed ~before choice changes;
      for i = 0 to (Array.length changes / 2) - 1 do
        let slot = changes.(2 * i) in
        changed.(slot) <- tuple.(slot)
      done
    end;
    choice + 1
  in
  List.fold_left one 0 steps

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
