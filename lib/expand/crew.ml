open Scc_base
open Scc_codec
open Scc_explore

type start = At_once | When_it_pays

(* A request of no more bytes than this, with those that are under way, does not fill the channel: then nobody
   waits for anybody who waits. *)
let most_bytes = 48 * 1024

(* Others are called in after so many seconds, and while there are so few states: a process that is forked keeps
   what its parent has had, and what the parent writes to comes to be there twice. *)
let grace = 0.5
let few = 1 lsl 19

(* So often is a process replaced that has died; what is left is found here. *)
let most_deaths = 20

module States = Hashtbl.Make (struct
    type t = int

    let equal = Int.equal
    let hash = Fun.id
  end)

module Make
    (L : Lts.S)
    (E : Lts.Exchange with type context = L.context)
    (Graph : module type of Explore.Make (L)) = struct
  module Wire = Wire.Make (E)

  (** {2 Messages}

      A request is a number of states and their tuples. A reply is, of each of them, 0 where its transitions have
      to be looked at here; 1 and all of them; or 2, those that may do ({!Lts.S.reduced}), and all of them. Before
      that are the microseconds that the other process has waited for the request, those that the answers took, and
      the words of its heap. *)

  type answer = Look | Steps of { some : Lts.step list option; all : Lts.step list }

  let put_steps wire b steps =
    Packed.put_nat b (List.length steps);
    List.iter (Wire.put_recent wire b) steps

  let read_steps wire source = Packed.list source (Wire.read_recent wire)

  let read_answer wire source =
    match Packed.nat source with
    | 0 -> Look
    | 1 -> Steps { some = None; all = read_steps wire source }
    | _ ->
      let some = read_steps wire source in
      Steps { some = Some some; all = read_steps wire source }

  (** {2 Another process} *)

  let answer context wire b tuple =
    match (L.reduced context tuple, L.successors context tuple) with
    | _, (Error _ | Ok []) -> Packed.put_nat b 0
    | None, Ok all ->
      Packed.put_nat b 1;
      put_steps wire b all
    | Some some, Ok all ->
      Packed.put_nat b 2;
      put_steps wire b some;
      put_steps wire b all

  let serve context channel =
    let from = Wire.make context and back = Wire.make context in
    let answers = Buffer.create 65536 and reply = Buffer.create 65536 in
    let put_seconds seconds = Packed.put_nat reply (int_of_float (1e6 *. Float.max 0. seconds)) in
    let rec go since =
      let source = Packed.source (Channel.get channel) in
      let start = Unix.gettimeofday () in
      Buffer.clear answers;
      for _ = 1 to Packed.nat source do
        answer context back answers (Wire.read_tuple from source)
      done;
      Buffer.clear reply;
      put_seconds (start -. since);
      put_seconds (Unix.gettimeofday () -. start);
      Packed.put_nat reply (Memory.heap_words ());
      Buffer.add_buffer reply answers;
      Channel.put channel reply;
      go (Unix.gettimeofday ())
    in
    go (Unix.gettimeofday ())

  (** {2 This process} *)

  (* The answers of a reply are read when it is the turn of their states: then they are short-lived. *)
  type request = {
    worker : worker;
    bytes : int;
    mutable unread : int list;  (** its states whose answers have not been read, in order *)
    mutable reply : Packed.source option;
  }

  and worker = {
    channel : Channel.t;
    there : Wire.t;
    back : Wire.t;
    under_way : request Queue.t;
    replies : request Queue.t;  (** the answered ones, in order *)
    mutable words : int;  (** of its heap, as it last told *)
  }

  type t = {
    graph : Graph.t;
    balance : Balance.t;
    waits : int -> bool;
    mutable now : int;  (** the state that is expanded *)
    mutable next : int;  (** the first that has not been looked at: whether it is found here or not *)
    ready : int Queue.t;  (** those that are not, and have not been sent *)
    sent : request States.t;  (** of states that have not had their turn *)
    early : answer States.t;  (** that had to be read before the turn of their states *)
    mutable workers : worker list;
    mutable deaths : int;
  }

  let told c = Memory.set_beside (List.fold_left (fun n w -> n + Memory.bytes_of_words w.words) 0 c.workers)

  let new_worker c =
    let context = Graph.context c.graph in
    let channel = Channel.fork (serve context) in
    let there = Wire.make context and back = Wire.make context in
    c.workers <-
      { channel; there; back; under_way = Queue.create (); replies = Queue.create (); words = 0 } :: c.workers

  (* What it was to find is found by others, or here. *)
  let bury c w =
    Channel.close w.channel;
    Queue.iter (fun request -> List.iter (States.remove c.sent) request.unread) w.under_way;
    c.workers <- List.filter (fun other -> other != w) c.workers;
    c.deaths <- c.deaths + 1;
    if c.deaths <= most_deaths then new_worker c;
    told c

  let bytes_under_way w = Queue.fold (fun n request -> n + request.bytes) 0 w.under_way

  (* In the order of their numbers, which is about that in which they are expanded. *)
  let see_who_is_ready c =
    while c.next < Graph.size c.graph && Queue.length c.ready < 2 * Balance.batch c.balance do
      if not (Balance.is_here c.balance c.next) then Queue.push c.next c.ready;
      c.next <- c.next + 1
    done

  (* States for a request: some may have been expanded meanwhile. *)
  let next_states c =
    let rec from count chosen =
      match if count < Balance.batch c.balance then Queue.take_opt c.ready else None with
      | None -> List.rev chosen
      | Some i -> if i <> c.now && c.waits i then from (count + 1) (i :: chosen) else from count chosen
    in
    from 0 []

  (* As many of them as are let through; a large state goes alone. *)
  let request c w states =
    let b = Buffer.create 4096 in
    let rec fill sent = function
      | i :: rest when Buffer.length b < most_bytes / 4 ->
        Wire.put_tuple w.there b (Graph.tuple c.graph i);
        fill (i :: sent) rest
      | _ -> List.rev sent
    in
    let sent = Balance.telling c.balance (fun () -> fill [] states) in
    let whole = Buffer.create (Buffer.length b + 4) in
    Packed.put_nat whole (List.length sent);
    Buffer.add_buffer whole b;
    let request = { worker = w; bytes = Buffer.length whole; unread = sent; reply = None } in
    List.iter (fun i -> States.replace c.sent i request) sent;
    Queue.push request w.under_way;
    match Channel.put w.channel whole with () -> () | exception Channel.Closed -> bury c w

  (* Two requests each, so that nobody waits for the next one; but only who has none gets one of few states. *)
  let has_room c w =
    Queue.is_empty w.under_way
    || Queue.length w.under_way < 2
       && bytes_under_way w <= most_bytes / 2
       && Queue.length c.ready >= Balance.least_ahead c.balance

  (* What is found is of no use before its turn: nobody runs far ahead of the process that has the graph. *)
  let is_far_ahead c = States.length c.sent > 3 * Balance.batch c.balance * List.length c.workers

  let rec send c =
    see_who_is_ready c;
    match List.filter (has_room c) c.workers with
    | [] -> ()
    | free when Queue.length c.ready >= Balance.least c.balance && not (is_far_ahead c) -> (
        let busy w = Queue.length w.under_way in
        let w = List.hd (List.stable_sort (fun a b -> Int.compare (busy a) (busy b)) free) in
        match Balance.telling c.balance (fun () -> next_states c) with
        | [] -> ()
        | states ->
          request c w states;
          send c)
    | _ :: _ -> ()

  let receive c w =
    match Channel.get w.channel with
    | exception Channel.Closed -> bury c w
    | message ->
      let source = Packed.source message in
      let request = Queue.pop w.under_way in
      let seconds () = 1e-6 *. float_of_int (Packed.nat source) in
      let waited = seconds () in
      let worked = seconds () in
      w.words <- Packed.nat source;
      told c;
      Balance.answered c.balance ~states:(List.length request.unread) ~waited ~worked;
      request.reply <- Some source;
      Queue.push request w.replies

  let exchange c channels =
    Critical.run (fun () ->
        List.iter (fun w -> if List.memq w.channel channels then receive c w) c.workers;
        send c)

  let channels c = List.filter_map (fun w -> if Queue.is_empty w.under_way then None else Some w.channel) c.workers

  (* Of a state whose request has been answered. What one process tells can only be read in order. *)
  let rec read_on c w i =
    match Queue.peek w.replies with
    | { reply = Some source; unread = next :: rest; _ } as request ->
      let answer = read_answer w.back source in
      request.unread <- rest;
      if next = i then answer
      else begin
        States.replace c.early next answer;
        read_on c w i
      end
    | { reply = None; _ } | { unread = []; _ } ->
      ignore (Queue.pop w.replies);
      read_on c w i

  let answer_of c request i =
    match States.find_opt c.early i with
    | None -> read_on c request.worker i
    | Some answer ->
      States.remove c.early i;
      answer

  (* None: it is to be found here. *)
  let rec found c i =
    match States.find_opt c.sent i with
    | None -> None
    | Some { reply = None; _ } ->
      Balance.waited c.balance;
      exchange c (Channel.ready (channels c));
      found c i
    | Some request -> (
        let answer = Balance.hearing c.balance i (fun () -> answer_of c request i) in
        States.remove c.sent i;
        match answer with
        | Look -> None
        | Steps { some; all } -> Some (Graph.all_or_some c.graph ~some ~all:(fun () -> Ok all)))

  let steps result = Result.map (fun found -> Graph.Found found) result

  let begun g balance jobs waits =
    let c =
      {
        graph = g; balance; waits;
        now = -1;
        next = 0;
        ready = Queue.create ();
        sent = States.create 1024;
        early = States.create 16;
        workers = [];
        deaths = 0;
      }
    in
    for _ = 1 to jobs - 1 do
      new_worker c
    done;
    c

  (* Whether it pays is asked once the first states have been found here. *)
  let expanding ~jobs ~start : Graph.expanding =
    fun g ~all_edges ~waits ->
    if jobs < 2 then Graph.here g ~all_edges ~waits
    else begin
      let crew = ref None and turns = ref 0 in
      let first = Unix.gettimeofday () and balance = Balance.create ~now:Unix.gettimeofday in
      let find_here tuple = steps (Balance.finding balance (fun () -> Graph.successors g tuple)) in
      let pays () =
        match start with
        | At_once -> true
        | When_it_pays ->
          Graph.size g <= few && Unix.gettimeofday () -. first > grace && Balance.pays balance
      in
      let call_in () =
        if Option.is_none !crew && pays () then
          Critical.run (fun () -> crew := Some (begun g balance jobs waits))
      in
      let expand i tuple =
        incr turns;
        call_in ();
        match !crew with
        | None -> find_here tuple
        | Some c -> (
            c.now <- i;
            if !turns mod Balance.between_looks balance = 0 then
              exchange c (List.filter Channel.has_message (channels c));
            match found c i with Some result -> steps result | None -> find_here tuple)
      in
      let finish () =
        Option.iter
          (fun c ->
             Critical.run (fun () -> List.iter (fun w -> Channel.close w.channel) c.workers);
             Memory.set_beside 0)
          !crew
      in
      { expand; expanded = (fun () -> None); finish }
    end
end
