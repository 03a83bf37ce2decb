open Scc_base
open Scc_codec
open Scc_graph_search

module Make
    (L : Lts.S)
    (E : Lts.Exchange with type context = L.context)
    (Compact : module type of Compacted.Make (L)) = struct
  module Wire = Wire.Make (E)

  type note = { state : int; steps : Lts.step list }

  type t = {
    log : Log.t;
    wire : Wire.t;
    blocks : Blocks.t;
    mutable source : Packed.source option;  (** of the block that is read; [None]: all has been *)
    mutable ahead : note option;  (** the next note *)
    mutable last : int;  (** the state of the last note *)
  }

  let unfit what = raise (Journal.Unfit what)

  (* The state, as a difference from the one after that of the note before, and its transitions. *)
  let put j note buffer =
    Packed.put_nat buffer (note.state - j.last - 1);
    Packed.put_list buffer (Wire.put_step j.wire) note.steps;
    j.last <- note.state

  let read j source =
    let state = j.last + 1 + Packed.nat source in
    j.last <- state;
    { state; steps = Packed.list source (Wire.read_step j.wire) }

  let rec advance j =
    match j.source with
    | None -> j.ahead <- None
    | Some source when Packed.at_end source ->
      j.source <- Option.map Packed.source (j.log.next ());
      advance j
    | Some source -> j.ahead <- Some (read j source)

  let advance j =
    match advance j with
    | () -> ()
    | exception (Packed.Malformed what | Failure what) -> unfit what

  let expand j context state tuple =
    let afresh () = L.successors context tuple in
    match j.ahead with
    | Some note when note.state = state ->
      Critical.run (fun () -> advance j);
      Ok note.steps
    | Some _ -> (
        match afresh () with
        | (Ok [] | Error _) as none -> none
        | Ok _ -> unfit (Printf.sprintf "there is nothing of state %d" state))
    | None ->
      let found = afresh () in
      (match found with
       | Ok [] | Error _ -> ()
       | Ok steps -> Critical.run (fun () -> Blocks.add j.blocks (put j { state; steps })));
      found

  let expanding ?block log context =
    let j =
      {
        log;
        wire = Wire.make context;
        blocks = Blocks.make ?full:block log;
        source = Some (Packed.source "");
        ahead = None;
        last = -1;
      }
    in
    advance j;
    { Compact.expand = expand j context; finish = (fun () -> Critical.run (fun () -> Blocks.write j.blocks)) }
end
