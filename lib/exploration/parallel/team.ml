open Scc_base
open Scc_codec
open Scc_graph_search

(* So often is a process replaced that has died; what is left is found here. *)
let most_deaths = 20

(* Requests of a worker whose answers are not all used yet. *)
let slots_of_worker = 8

(* A state may have very many transitions. Memory is taken only where it is written to. *)
let slot_length = 1 lsl 20

(* To sleep and to be woken takes as long as some quick states. *)
let looks_before_sleep = 4000

module Make (L : Lts.S) (Graph : module type of Explore.Make (L)) = struct
  module Service = Served.Make (L) (Graph)

  type worker = {
    channel : Channel.t;
    bells : Served.bells;
    slots : Served.slot array;
    live : request Queue.t;  (** those that have a slot, in order *)
    mutable beyond : int;  (** the number of the next request; it has the slot of this number, by turns *)
    mutable under_way : request list;  (** in order *)
    mutable words : int;  (** of memory that it takes, as it last told *)
  }

  and request = {
    worker : worker option;  (** [None]: it is this process *)
    slot : Served.slot;
    mutable states : int array;  (** increasing *)
    mutable answered : int;  (** the first ones, which have been seen to; -1 while it is under way *)
    mutable next : int;  (** of those before it, the answers are of no use any more *)
  }

  type t = {
    shared : Service.shared;
    balance : Balance.t;
    jobs : int;
    waits : int -> bool;
    room : unit -> int;  (** how many states there may come to be *)
    requests : request Queue.t;  (** whose answers may be of use, in the order of their states *)
    mutable own_slots : Served.slot list;  (** those of no request *)
    mutable now : int;  (** the state whose turn it is *)
    mutable unasked : int;  (** the first state that is in no request so far *)
    mutable size : int;  (** of the graph, at the turn before *)
    mutable fresh : float;  (** how many states are new to a turn: a mean of the last ones *)
    mutable patience : float;  (** seconds to wait before it finds more ahead *)
    mutable is_ahead : bool;  (** this process finds what may be of use later *)
    mutable workers : worker list;
    mutable deaths : int;
  }

  let told c = Memory.set_beside (List.fold_left (fun n w -> n + Memory.bytes_of_words w.words) 0 c.workers)

  (** {2 Workers} *)

  (* One piece of memory: the system copies what it knows of each piece for each process. *)
  let make_slots count =
    let slots memory = List.init count (fun k -> Bigarray.Array1.sub memory (k * slot_length) slot_length) in
    Option.map slots (Scc_shared.Shared_memory.numbers (count * slot_length))

  (* Where the system gives no memory or no process there are fewer. *)
  let new_worker c =
    match (make_slots slots_of_worker, Served.bells ()) with
    | Some slots, Some bells ->
      let slots = Array.of_list slots in
      let add channel =
        let live = Queue.create () in
        c.workers <- { channel; bells; slots; live; beyond = 0; under_way = []; words = 0 } :: c.workers
      in
      Option.iter add (Channel.fork (Service.serve c.shared slots bells))
    | _ -> ()

  (* What it was to find is found here. *)
  let end_worker c w =
    Channel.close w.channel;
    List.iter (fun r -> r.answered <- 0) w.under_way;
    c.workers <- List.filter (fun other -> other != w) c.workers;
    told c

  let bury c w =
    end_worker c w;
    c.deaths <- c.deaths + 1;
    if c.deaths <= most_deaths then new_worker c

  let wake c w =
    if Served.is_waiting w.bells Served.worker then
      match Channel.put w.channel (Buffer.create 1) with () -> () | exception Channel.Closed -> bury c w

  let rec collect_from c w =
    match w.under_way with
    | r :: rest when Served.answered r.slot >= 0 ->
      r.answered <- Served.answered r.slot;
      w.under_way <- rest;
      Balance.answered c.balance ~states:r.answered ~worked:(Served.seconds r.slot);
      collect_from c w
    | _ -> ()

  let collect c = List.iter (collect_from c) c.workers

  let receive c w =
    match Channel.get w.channel with
    | exception Channel.Closed -> bury c w
    | message ->
      w.words <- Packed.nat (Packed.source message);
      told c

  let is_under_way w = match w.under_way with [] -> false | r :: _ -> Served.answered r.slot < 0

  (* Until somebody has told something, or died, if [goes_on ()] once all know of it. *)
  let wait_while ?seconds c goes_on =
    let busy = List.filter (fun w -> w.under_way <> []) c.workers in
    List.iter (fun w -> Served.say_waiting w.bells Served.main) busy;
    if List.for_all is_under_way busy && goes_on () then begin
      let ready = Channel.ready ?seconds (List.map (fun w -> w.channel) busy) in
      Critical.run (fun () -> List.iter (fun w -> if List.memq w.channel ready then receive c w) busy)
    end;
    Critical.run (fun () -> collect c)

  (* For the answer about one state. *)
  let wait ?seconds c r k =
    let is_taken () = Served.progress r.slot k = Taken in
    let rec look n = is_taken () && (n = 0 || look (n - 1)) in
    let nobody_pauses () = not (List.exists (fun w -> Served.is_paused w.bells) c.workers) in
    if look looks_before_sleep then wait_while ?seconds c (fun () -> is_taken () && nobody_pauses ())
    else Critical.run (fun () -> collect c)
end
