open Scc_data
open Scc_exact

(* Small numbers, a byte each, and the few great ones beside. *)
module Choices = struct
  type t = { mutable small : Bytes.t; great : (int, int) Hashtbl.t; mutable length : int }

  let create () = { small = Bytes.create 1024; great = Hashtbl.create 8; length = 0 }
  let length c = c.length

  let push c x =
    if c.length = Bytes.length c.small then c.small <- Bytes.extend c.small 0 (c.length / 4);
    if x < 255 then Bytes.set c.small c.length (Char.chr x)
    else begin
      Bytes.set c.small c.length '\255';
      Hashtbl.replace c.great c.length x
    end;
    c.length <- c.length + 1

  let get c i =
    match Bytes.get c.small i with
    | '\255' -> Hashtbl.find c.great i
    | x -> Char.code x

  let bytes c = Bytes.length c.small
end

module Make (L : Lts.S) = struct
  type visitor = {
    found : int -> int array -> unit;
    opened : int -> int array -> Lts.step list -> unit;
    enough : unit -> bool;
  }

  type expander = {
    expand : int -> int array -> (Lts.step list, L.fault) Stdlib.result;
    finish : unit -> unit;
  }

  type expanding = L.context -> expander

  let here context = { expand = (fun _ tuple -> L.successors context tuple); finish = Fun.id }

  type result = {
    size : int;
    transitions : int;
    depth : int;
    arrival : Rat.t;
    left : L.fault Explore.reason list;
    omission : float;
    path : int -> int list;
    bytes : int;
  }

  type search = {
    context : L.context;
    limits : Limits.t;
    room : int;
    tuples : Tuples.t;  (** only for the parts of tuples *)
    near : Tuples.spread;
    appearances : Appearances.t;  (** keys are of numbers by appearance *)
    seen : Fingerprints.t;
    paths : Distances.t;  (** of the paths on which states were found *)
    choices : Choices.t;  (** the last one of each of them *)
    frontier : Int_queue.t;
    (** the pairs of the roots of states that wait; they are expanded in the order of numbers *)
    mutable transitions : int;
    mutable left : L.fault Explore.reason list;
    mutable full : bool;
  }

  let size s = Choices.length s.choices

  (* Each bound once: bounds are constant constructors. Faults may be many. *)
  let leave s (reason : L.fault Explore.reason) =
    match reason with
    | Fault _ -> s.left <- reason :: s.left
    | Depth | Time | Instant | States | Bits | Seconds | Memory | Interrupted | Stopped ->
      if not (List.memq reason s.left) then s.left <- reason :: s.left

  (* States are expanded in the order of their numbers, so that each waits, whether or not it is to be expanded. *)
  let add s key label changes ~choice =
    L.entered s.context changes;
    Distances.push s.paths label;
    Choices.push s.choices choice;
    Int_queue.push s.frontier key

  let beyond value = function None -> false | Some bound -> value > (bound : int)

  let out_of_bounds s i =
    if beyond (Distances.depth s.paths i) s.limits.depth then Some Explore.Depth
    else if beyond (Distances.instant s.paths i) s.limits.instant then Some Explore.Instant
    else None

  let bytes s =
    Tuples.bytes s.tuples + Appearances.bytes s.appearances + Fingerprints.bytes s.seen + Distances.bytes s.paths
    + Choices.bytes s.choices

  let after s i (step : Lts.step) =
    let d = L.duration s.context step.label in
    let transitions = L.transitions s.context step.label in
    Distances.after s.paths i ~transitions (if Rat.sign d > 0 then Some d else None)

  (* The last states may not fit any more. *)
  let follow s around visitor i tuple choice (step : Lts.step) =
    s.transitions <- s.transitions + 1;
    let changes = Appearances.changes s.appearances step.changes in
    let key = Tuples.key s.tuples ~near:s.near changes in
    if s.full then ()
    else if size s >= s.room then begin
      leave s Explore.States;
      s.full <- true
    end
    else if Fingerprints.add s.seen key then begin
      let number = size s in
      add s key (after s i step) step.changes ~choice;
      Limits.within around (fun () -> visitor.found number (Tuples.apply step.changes tuple))
    end

  let expand s around visitor expander i key =
    Tuples.load_key s.tuples s.near key;
    let tuple = Appearances.tuple s.appearances (Tuples.slots s.near) in
    let bits () = L.bits s.context tuple in
    if Limits.too_long s.limits ~longest:(L.longest s.context) ~bits then leave s Explore.Bits
    else
      match Limits.within around (fun () -> expander.expand i tuple) with
      | Error fault -> leave s (Explore.Fault fault)
      | Ok steps ->
        Limits.within around (fun () -> visitor.opened i tuple steps);
        List.iteri (follow s around visitor i tuple) steps

  let path s i =
    let rec go i choices =
      match Distances.before_nearest s.paths i with
      | -1 -> choices
      | before -> go before (Choices.get s.choices i :: choices)
    in
    go i []

  let start (limits : Limits.t) capacity ~family context =
    let tuples = Tuples.create ~width:(L.width context) in
    let room = match limits.states with None -> capacity | Some n -> Int.min n capacity in
    let near = Tuples.spread tuples in
    let first = L.initial context in
    let whole = Tuples.difference (Array.map (fun _ -> -1) first) first in
    let appearances = Appearances.create ~width:(L.width context) ~family in
    let key = Tuples.key tuples ~near (Appearances.changes appearances whole) in
    let s =
      {
        context; limits; room; tuples; near; appearances;
        seen = Fingerprints.create ~capacity:room;
        paths = Distances.create ();
        choices = Choices.create ();
        frontier = Int_queue.create ();
        transitions = 0;
        left = [];
        full = false;
      }
    in
    ignore (Fingerprints.add s.seen key);
    add s key Distances.origin whole ~choice:0;
    (s, first)

  let progress s i : Limits.progress =
    Explored {
      states = size s;
      transitions = s.transitions;
      waiting = Int_queue.length s.frontier;
      depth = Distances.depth s.paths i;
      model_time = Lazy.from_val (Some (Distances.arrival s.paths i));
    }

  let run ?(expanding = here) visitor ~capacity ~family limits (around : Limits.surroundings) context =
    let s, first = start limits capacity ~family context in
    let expander = expanding context in
    (* States are taken as they were found. *)
    let rec loop i =
      match Int_queue.take s.frontier with
      | None -> ()
      | Some _ when visitor.enough () -> leave s Explore.Stopped
      | Some _ when s.full -> ()
      | Some key -> (
          if i land 255 = 0 then around.progress (progress s i);
          match around.stop () with
          | Some stop -> leave s (Explore.of_stop stop)
          | None ->
            (match out_of_bounds s i with
             | Some reason -> leave s reason
             | None -> expand s around visitor expander i key);
            loop (i + 1))
    in
    let explore () =
      match
        Limits.within around (fun () -> visitor.found 0 first);
        loop 0
      with
      | () -> ()
      | exception Limits.Over stop -> leave s (Explore.of_stop stop)
    in
    Fun.protect explore ~finally:expander.finish;
    {
      size = size s;
      transitions = s.transitions;
      depth = Distances.greatest_depth s.paths;
      arrival = Distances.greatest_arrival s.paths;
      left = List.rev s.left;
      omission = Fingerprints.omission s.seen;
      path = path s;
      bytes = bytes s;
    }
end
