open Scc_base
open Scc_codec
open Scc_graph_search

exception Unfit of string

module Make
    (L : Lts.S)
    (E : Lts.Exchange with type context = L.context)
    (Graph : module type of Explore.Make (L)) = struct
  module Wire = Wire.Make (E)

  type note = { state : int; noted : Graph.noted }

  type t = {
    log : Log.t;
    wire : Wire.t;
    all_edges : bool;
    mutable source : Packed.source option;  (** of the block that is read; [None]: all has been *)
    mutable ahead : note option;  (** the next note *)
    mutable followed : bool;  (** the state that is being expanded was noted before *)
    mutable last : int;  (** the state of the last note *)
    blocks : Blocks.t;
  }

  (** {2 Notes as bytes}

      The state, as a difference from the one after that of the note before; twice the number of its edges, and
      one more if further transitions are postponed; and those that are told. An edge is its label and 0, with
      what is different in the new state, or 1 + the number of a state. *)

  let zigzag n = if n >= 0 then 2 * n else (-2 * n) - 1
  let unzigzag n = if n land 1 = 0 then n / 2 else -((n + 1) / 2)

  let put_arrow j buffer (arrow : Graph.arrow) =
    match arrow with
    | New s ->
      Wire.put_label j.wire buffer s.label;
      Packed.put_nat buffer 0;
      Wire.put_changes j.wire buffer s.changes
    | Known e ->
      Wire.put_label j.wire buffer e.label;
      Packed.put_nat buffer (e.target + 1)

  (* Each block begins with whether all edges are told. *)
  let put j note buffer =
    if Buffer.length buffer = 0 then Packed.put_nat buffer (Bool.to_int j.all_edges);
    Packed.put_nat buffer (zigzag (note.state - j.last - 1));
    Packed.put_nat buffer ((2 * note.noted.count) + Bool.to_int note.noted.reduced);
    Packed.put_nat buffer (List.length note.noted.arrows);
    List.iter (put_arrow j buffer) note.noted.arrows;
    j.last <- note.state

  let arrow j source : Graph.arrow =
    let label = Wire.read_label j.wire source in
    match Packed.nat source with
    | 0 -> New { label; changes = Wire.read_changes j.wire source }
    | n -> Known { label; target = n - 1 }

  let read j source =
    let state = j.last + 1 + unzigzag (Packed.nat source) in
    let count = Packed.nat source in
    j.last <- state;
    let arrows = Packed.list source (arrow j) in
    { state; noted = { arrows; count = count / 2; reduced = count land 1 = 1 } }

  (** {2 Blocks} *)

  let unfit what = raise (Unfit what)

  let open_block j block =
    let source = Packed.source block in
    let told = Packed.nat source in
    if told <> Bool.to_int j.all_edges then unfit "it was written for other questions";
    source

  let rec advance j =
    match j.source with
    | None -> j.ahead <- None
    | Some source when Packed.at_end source ->
      j.source <- Option.map (open_block j) (j.log.next ());
      advance j
    | Some source -> j.ahead <- Some (read j source)

  let advance j =
    match advance j with
    | () -> ()
    | exception (Packed.Malformed what | Failure what) -> unfit what

  (** {2 Following and noting} *)

  (* Of edges that change nothing the number will do, unless all are told. A label is told when it first comes
     up, so that all are known of the edges of a graph. *)
  let asks j label = j.all_edges || not (Wire.knows_label j.wire label)

  let tell j state (noted : Graph.noted) =
    if noted.count > 0 then Critical.run (fun () -> Blocks.add j.blocks (put j { state; noted }))

  let follow j =
    Critical.run (fun () ->
        let note = j.ahead in
        advance j;
        note)

  let expanding ?block log (after : Graph.expanding) : Graph.expanding =
    fun g ~all_edges ~waits ~room ~dull ->
    let j =
      {
        log;
        wire = Wire.make (Graph.context g);
        all_edges;
        source = Some (Packed.source "");
        ahead = None;
        followed = false;
        last = -1;
        blocks = Blocks.make ?full:block log;
      }
    in
    advance j;
    let after = lazy (after g ~all_edges ~waits ~room ~dull) in
    let afresh state tuple = (Lazy.force after).Graph.expand state tuple in
    let ready state =
      match j.ahead with
      | Some _ -> None
      | None ->
        j.followed <- false;
        (Lazy.force after).Graph.ready state
    in
    let expand state tuple =
      match j.ahead with
      | Some n when n.state = state ->
        j.followed <- true;
        let n = Option.get (follow j) in
        Ok (Graph.Noted n.noted)
      | Some _ -> (
          (* What is not noted has no transitions. *)
          match afresh state tuple with
          | (Ok (Found { steps = []; _ }) | Error _) as none -> none
          | Ok _ -> unfit (Printf.sprintf "there is nothing of state %d" state))
      | None ->
        j.followed <- false;
        afresh state tuple
    in
    let told =
      Some { Graph.asks = (fun label -> asks j label); tell = (fun i noted -> tell j i noted) }
    in
    (* Others may want to know as well. *)
    let expanded () =
      if j.followed then None
      else
        match (Lazy.force after).expanded () with
        | None -> told
        | Some t ->
          let tell i noted =
            tell j i noted;
            t.tell i noted
          in
          Some { asks = (fun label -> asks j label || t.asks label); tell }
    in
    let finish () =
      Critical.run (fun () -> Blocks.write j.blocks);
      if Lazy.is_val after then (Lazy.force after).finish ()
    in
    { ready; expand; expanded; finish }
end
