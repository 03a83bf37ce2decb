open Scc_base
open Scc_codec
open Scc_graph_search

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
  module Served = Served.Make (L) (E)
  module Wire = Served.Wire

  (** {2 This process} *)

  (* The answers of a reply are read when it is the turn of their states: then they are short-lived. *)
  type request = {
    worker : worker;
    bytes : int;
    mutable unread : int list;  (** its states whose answers have not been read, in order *)
    mutable reply : Packed.source option;
  }

  and worker = {
    number : int;
    channel : Channel.t;
    there : Wire.t;
    back : Wire.t;
    under_way : request Queue.t;
    replies : request Queue.t;  (** the answered ones, in order *)
    mutable words : int;  (** of memory that it takes, as it last told *)
    mutable owing : int;  (** states that it has been told of, and whose answers have not been read *)
    mutable place : int;  (** of the next of its answers that is read *)
    mutable room : int;  (** of the last one *)
  }

  (* What another process has told of the state that is expanded: the steps that were taken, and the places of the
     answer and of the first of them. *)
  type source = { from : worker; answer : int; first : int; steps : Lts.step list }

  type t = {
    graph : Graph.t;
    balance : Balance.t;
    waits : int -> bool;
    mutable now : int;  (** the state that is expanded *)
    mutable next : int;  (** the first that has not been looked at: whether it is found here or not *)
    ready : int Queue.t;  (** those that are not, and have not been sent *)
    sent : request States.t;  (** of states that have not had their turn *)
    early : (Served.answer * int) States.t;
    (** with their places, those that had to be read before the turn of their states *)
    origins : Origins.t;
    mutable source : source option;
    mutable known : int;  (** states, before this one was expanded *)
    mutable workers : worker list;
    mutable made : int;  (** workers, so far *)
    mutable deaths : int;
  }

  let width c = L.width (Graph.context c.graph)
  let told c = Memory.set_beside (List.fold_left (fun n w -> n + Memory.bytes_of_words w.words) 0 c.workers)

  let add_worker c channel =
    let context = Graph.context c.graph in
    let there = Wire.make context and back = Wire.make context in
    let under_way = Queue.create () and replies = Queue.create () in
    let number = c.made and words = 0 and owing = 0 and place = 0 and room = 0 in
    c.workers <- { number; channel; there; back; under_way; replies; words; owing; place; room } :: c.workers;
    c.made <- c.made + 1

  (* Where the system gives no process there are fewer. *)
  let new_worker c = Option.iter (add_worker c) (Channel.fork (Served.serve (Graph.context c.graph)))

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

  (* What will have been answered until this is read takes about as much room as the last answer. *)
  let put_state c w b i =
    let back answer = w.place + (w.owing * w.room) - answer in
    w.owing <- w.owing + 1;
    let state =
      match Origins.find c.origins i ~worker:w.number with
      | Some (answer, step) when back answer <= Answered.surely -> Served.Place { answer; step }
      | Some _ | None -> Tuple (Graph.tuple c.graph i)
    in
    Served.put_state w.there b state

  (* As many of them as are let through; a large state goes alone. *)
  let request c w states =
    let b = Buffer.create 4096 in
    let rec fill sent = function
      | i :: rest when Buffer.length b < most_bytes / 4 ->
        put_state c w b i;
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
      let { Served.waited; worked; words } = Served.read_heading source in
      w.words <- words;
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
    let request = Queue.peek w.replies in
    match request.reply, request.unread with
    | Some source, next :: rest ->
      let answer = Served.read_answer w.back source in
      let place = w.place in
      w.owing <- w.owing - 1;
      (match (answer : Served.answer) with
       | Look -> ()
       | Steps { some; all } ->
         w.room <- Answered.room ~width:(width c) (Served.kept ~some ~all);
         w.place <- w.place + w.room);
      request.unread <- rest;
      if next = i then (answer, place)
      else begin
        States.replace c.early next (answer, place);
        read_on c w i
      end
    | None, _ | _, [] ->
      ignore (Queue.pop w.replies);
      read_on c w i

  (* Those that may do are kept before all. *)
  let source c from ~some ~place (found : Graph.steps) =
    let width = width c in
    let first =
      match some with
      | Some some when not found.reduced -> place + Answered.room ~width some
      | Some _ | None -> place + Answered.first_step ~width
    in
    { from; answer = place; first; steps = found.steps }

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
        | Look, _ -> None
        | Steps { some; all }, place ->
          let found = Graph.all_or_some c.graph ~some ~all:(fun () -> Ok all) in
          Result.iter (fun found -> c.source <- Some (source c request.worker ~some ~place found)) found;
          Some found)

  (* Of the states that are new, in the order of their numbers, where each came up. *)
  let note_origins c { from; answer; first; steps } arrows =
    let rec go number step steps (arrows : Graph.arrow list) =
      match (steps, arrows) with
      | _, [] | [], _ -> ()
      | _, Known _ :: arrows -> go number step steps arrows
      | s :: steps, New new_one :: rest ->
        let next = step + Answered.room_of_step s in
        if s == new_one then begin
          Origins.put c.origins number ~worker:from.number ~answer ~step;
          go (number + 1) next steps rest
        end
        else go number next steps arrows
    in
    go c.known first steps arrows

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
        origins = Origins.create ();
        source = None;
        known = 0;
        workers = [];
        made = 0;
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
            c.source <- None;
            c.known <- Graph.size g;
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
      let asked c source =
        { Graph.asks = (fun _ -> false); tell = (fun _ noted -> note_origins c source noted.arrows) }
      in
      let expanded () = Option.bind !crew (fun c -> Option.map (asked c) c.source) in
      { expand; expanded; finish }
    end
end
