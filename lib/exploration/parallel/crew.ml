open Scc_base
open Scc_data
open Scc_codec
open Scc_graph_search

type start = At_once | When_it_pays

(* Others are called in after so many seconds, and while there are so few states: a process that is forked keeps
   what its parent has had, and what the parent writes to comes to be there twice. *)
let grace = 0.5
let few = 1 lsl 19

(* So often is a process replaced that has died; what is left is found here. *)
let most_deaths = 20

(* Requests of a worker whose answers are not all used yet, and those under way: the next one is there before it has
   answered one. *)
let slots_of_worker = 8
let most_under_way = 4

(* Of what this process finds ahead. *)
let own_slots = 16
let slot_length = 1 lsl 14

(* Of so many answers one after the other, a power of two, what they ask for is fetched at once. *)
let fetched_at_once = 16

(* After so many states this process looks whether others have answered. *)
let between_looks = 16

(* And after so many, how much memory is shared. *)
let between_sizes = 1 lsl 12

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
    states : int array;  (** increasing *)
    mutable answered : int;  (** the first ones; -1 while it is under way *)
    mutable next : int;  (** of those before it, the answers are of no use any more *)
  }

  type t = {
    shared : Service.shared;
    balance : Balance.t;
    jobs : int;
    waits : int -> bool;
    requests : request Queue.t;  (** whose answers may be of use, in the order of their states *)
    mutable own_slots : Served.slot list;  (** those of no request *)
    mutable now : int;  (** the state whose turn it is *)
    mutable unasked : int;  (** the first state that is in no request so far *)
    mutable workers : worker list;
    mutable deaths : int;
  }

  let told c = Memory.set_beside (List.fold_left (fun n w -> n + Memory.bytes_of_words w.words) 0 c.workers)

  (** {2 Workers} *)

  let all_or_none list = if List.for_all Option.is_some list then Some (List.filter_map Fun.id list) else None
  let make_slots count length = all_or_none (List.init count (fun _ -> Scc_shared.Shared_memory.numbers length))

  (* Where the system gives no memory or no process there are fewer. *)
  let new_worker c =
    match (make_slots slots_of_worker slot_length, Served.bells ()) with
    | Some slots, Some bells ->
      let slots = Array.of_list slots in
      let add channel =
        c.workers <- { channel; bells; slots; live = Queue.create (); beyond = 0; under_way = []; words = 0 } :: c.workers
      in
      Option.iter add (Channel.fork (Service.serve c.shared slots bells))
    | _ -> ()

  (* What it was to find is found here. *)
  let bury c w =
    Channel.close w.channel;
    List.iter (fun r -> r.answered <- 0) w.under_way;
    c.workers <- List.filter (fun other -> other != w) c.workers;
    c.deaths <- c.deaths + 1;
    if c.deaths <= most_deaths then new_worker c;
    told c

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

  (* Until somebody has answered, or died. *)
  let wait c =
    let busy = List.filter (fun w -> w.under_way <> []) c.workers in
    let is_under_way w = match w.under_way with [] -> false | r :: _ -> Served.answered r.slot < 0 in
    List.iter (fun w -> Served.say_waiting w.bells Served.main) busy;
    if List.for_all is_under_way busy then begin
      let ready = Channel.ready (List.map (fun w -> w.channel) busy) in
      Critical.run (fun () -> List.iter (fun w -> if List.memq w.channel ready then receive c w) busy)
    end;
    Critical.run (fun () -> collect c)

  (** {2 Requests} *)

  (* A state that has been expanded does not wait any more. *)
  let rec pass_over c r =
    if r.next < r.answered && not (c.waits r.states.(r.next)) then begin
      r.next <- r.next + 1;
      pass_over c r
    end

  let is_used_up r = r.answered >= 0 && r.next >= r.answered

  (* A worker has its slots back in the order of its requests. *)
  let give_back c r =
    let rec drop live =
      match Queue.peek_opt live with
      | Some r when is_used_up r ->
        ignore (Queue.pop live);
        drop live
      | Some _ | None -> ()
    in
    match r.worker with
    | Some w -> drop w.live
    | None -> c.own_slots <- r.slot :: c.own_slots

  (* Those that are used up give their slots back: the first ones always, others once slots are wanted. *)
  let rec drop_first c =
    match Queue.peek_opt c.requests with
    | Some r when is_used_up r ->
      give_back c (Queue.pop c.requests);
      drop_first c
    | Some _ | None -> ()

  let drop_all c =
    let kept = Queue.create () in
    let look r =
      pass_over c r;
      if is_used_up r then give_back c r else Queue.push r kept
    in
    Queue.iter look c.requests;
    Queue.clear c.requests;
    Queue.transfer kept c.requests

  let waiting c = Graph.size c.shared.graph - c.unasked

  (* So many that wait, but for the one whose turn it is. *)
  let take c count =
    let rec from found chosen =
      if found = count || waiting c = 0 then Array.of_list (List.rev chosen)
      else begin
        let i = c.unasked in
        c.unasked <- i + 1;
        if i <> c.now && c.waits i then from (found + 1) (i :: chosen) else from found chosen
      end
    in
    from 0 []

  let ask c w =
    match take c (Balance.request c.balance ~waiting:(waiting c) ~jobs:c.jobs) with
    | [||] -> ()
    | states ->
      let slot = w.slots.(w.beyond mod Array.length w.slots) in
      Served.request slot states;
      let r = { worker = Some w; slot; states; answered = -1; next = 0 } in
      w.beyond <- w.beyond + 1;
      w.under_way <- w.under_way @ [ r ];
      Queue.push r w.live;
      Queue.push r c.requests;
      if Served.is_waiting w.bells Served.worker then
        match Channel.put w.channel (Buffer.create 1) with () -> () | exception Channel.Closed -> bury c w

  let is_full w = Queue.length w.live >= Array.length w.slots

  (* Those with fewer requests are asked first. *)
  let send c =
    for under_way = 0 to most_under_way - 1 do
      let ask_one w =
        if waiting c > 1 && List.length w.under_way = under_way && not (is_full w) then ask c w
      in
      List.iter ask_one c.workers
    done

  (** {2 Room in the tables} *)

  (* Workers stop where room is wanted, and are not asked for more until they all have. *)
  let make_room c =
    while List.exists (fun w -> w.under_way <> []) c.workers do
      wait c
    done;
    Critical.run (fun () -> Graph.make_room c.shared.graph c.shared.common)

  let exchange c =
    Critical.run (fun () ->
        collect c;
        drop_first c);
    if Graph.is_room_wanted c.shared.graph c.shared.common then make_room c;
    Critical.run (fun () ->
        if List.exists is_full c.workers || c.own_slots = [] then drop_all c;
        send c)

  (** {2 Answers} *)

  (* Some of what waits is found here; nothing, where there is none or no room for it. *)
  let works_ahead c =
    match c.own_slots with
    | [] -> false
    | slot :: rest -> (
        match take c (Balance.request c.balance ~waiting:(waiting c) ~jobs:c.jobs) with
        | [||] -> false
        | states ->
          c.own_slots <- rest;
          Served.request slot states;
          let r = { worker = None; slot; states; answered = 0; next = 0 } in
          Queue.push r c.requests;
          Service.find c.shared slot;
          r.answered <- Served.answered slot;
          true)

  (* The place of a state among increasing ones from [low] on, before [high]. *)
  let rec position (states : int array) i low high =
    if low >= high then None
    else
      let middle = (low + high) / 2 in
      let there = states.(middle) in
      if there = i then Some middle
      else if there < i then position states i (middle + 1) high
      else position states i low middle

  let find c i =
    let look found r =
      match found with
      | Some _ -> found
      | None -> Option.map (fun k -> (r, k)) (position r.states i r.next (Array.length r.states))
    in
    match Queue.peek_opt c.requests with
    | Some r when r.next < Array.length r.states && r.states.(r.next) = i -> Some (r, r.next)
    | Some _ | None -> Queue.fold look None c.requests

  let answer r k = { Graph.words = r.slot; at = Served.place r.slot k }

  let rec ready c i =
    match find c i with
    | None -> None
    | Some (r, k) when r.answered >= 0 ->
      if k >= r.answered then None
      else begin
        if k = r.next then r.next <- k + 1;
        if k land (fetched_at_once - 1) = 0 then
          for k = k to Int.min (k + fetched_at_once) r.answered - 1 do
            Graph.fetch c.shared.graph (answer r k)
          done;
        Some (answer r k)
      end
    | Some _ ->
      if not (works_ahead c) then wait c;
      exchange c;
      ready c i

  let begun shared balance jobs waits =
    let own_slots = List.init own_slots (fun _ -> Bigarray.(Array1.create int c_layout slot_length)) in
    let rec first_waiting i = if i < Graph.size shared.Service.graph && not (waits i) then first_waiting (i + 1) else i in
    let unasked = first_waiting 0 and requests = Queue.create () in
    let c = { shared; balance; jobs; waits; requests; own_slots; now = -1; unasked; workers = []; deaths = 0 } in
    Graph.set_full shared.graph shared.common (fun () -> make_room c);
    for _ = 1 to jobs - 1 do
      new_worker c
    done;
    c

  let ended c =
    List.iter (fun w -> Channel.close w.channel) c.workers;
    c.workers <- [];
    Memory.set_beside 0

  (* Whether it pays is asked once the first states have been found here. *)
  let expanding ~jobs ~start : Graph.expanding =
    fun g ~all_edges ~waits ~dull ->
    if jobs < 2 then Graph.here g ~all_edges ~waits ~dull
    else begin
      let crew = ref None and tried = ref false and turns = ref 0 in
      let first = Unix.gettimeofday () and balance = Balance.create ~now:Unix.gettimeofday in
      let pays () =
        match start with
        | At_once -> true
        | When_it_pays ->
          Graph.size g <= few && Unix.gettimeofday () -. first > grace && Balance.pays balance
      in
      let call_in () =
        if (not !tried) && pays () then begin
          tried := true;
          let begin_with common = crew := Some (begun { graph = g; common; all_edges; dull } balance jobs waits) in
          Critical.run (fun () -> Option.iter begin_with (Graph.share g))
        end
      in
      let ready i =
        match !crew with
        | None -> None
        | Some c ->
          c.now <- i;
          incr turns;
          if !turns land (between_looks - 1) = 0 then exchange c;
          (* What is shared cannot be in files. *)
          if !turns land (between_sizes - 1) = 0 && Spill.takes (Graph.shared_bytes g) then begin
            Critical.run (fun () -> ended c; Graph.unshare g; crew := None);
            None
          end
          else ready c i
      in
      let expand _ tuple =
        call_in ();
        Result.map (fun found -> Graph.Found found) (Balance.finding balance (fun () -> Graph.successors g tuple))
      in
      let finish () = Option.iter (fun c -> Critical.run (fun () -> ended c)) !crew in
      { ready; expand; expanded = (fun () -> None); finish }
    end
end
