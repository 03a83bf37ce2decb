open Scc_base
open Scc_codec
open Scc_explore

type start = At_once | When_it_pays

(* Seconds that a message is to be worth, and how many states are in one at most. *)
let batch_seconds = 0.002
let most_states = 512

(* A request of no more bytes than this, with those that are under way, does not fill the channel: then nobody
   waits for anybody who waits. *)
let most_bytes = 48 * 1024

(* Seconds after which others may be called in, and those that a state is to take for it. *)
let grace = 0.5
let worth = 20e-6

(* So often is a process replaced that has died; what is left is found here. *)
let most_deaths = 20

(* Of so many states with numbers one after the other, a power of two, the first few are found by this process. *)
let stretch = 64
let most_here = 60

module Make
    (L : Lts.S)
    (E : Lts.Exchange with type context = L.context)
    (Graph : module type of Explore.Make (L)) = struct
  module Wire = Wire.Make (E)

  (** {2 Messages}

      A request is a number of states and their tuples. A reply is, of each of them, 0 where its transitions have
      to be looked at here; 1 and all of them; or 2, those that may do ({!Lts.S.reduced}), and all of them; after
      that the microseconds that it took, and the words of the heap. *)

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
    let b = Buffer.create 65536 in
    let rec go () =
      let source = Packed.source (Channel.get channel) in
      let start = Unix.gettimeofday () in
      Buffer.clear b;
      for _ = 1 to Packed.nat source do
        answer context back b (Wire.read_tuple from source)
      done;
      Packed.put_nat b (int_of_float (1e6 *. Float.max 0. (Unix.gettimeofday () -. start)));
      Packed.put_nat b (Memory.heap_words ());
      Channel.put channel b;
      go ()
    in
    go ()

  (** {2 This process} *)

  type worker = {
    channel : Channel.t;
    there : Wire.t;
    back : Wire.t;
    requests : (int list * int) Queue.t;  (** under way: their states, in order, and their bytes *)
    mutable words : int;  (** of its heap, as it last told *)
  }

  type place = Under_way | Found of answer

  type t = {
    graph : Graph.t;
    waiting : (int -> bool) -> bool;
    states : (int, place) Hashtbl.t;  (** that were sent, and have not had their turn *)
    mutable workers : worker list;
    mutable deaths : int;
    mutable batch : int;  (** states of the next request *)
    mutable here : int;  (** how many of each {!stretch} of states are found by this process *)
  }

  let told c = Memory.set_beside (List.fold_left (fun n w -> n + Memory.bytes_of_words w.words) 0 c.workers)

  let new_worker c =
    let context = Graph.context c.graph in
    let channel = Channel.fork (serve context) in
    let there = Wire.make context and back = Wire.make context in
    c.workers <- { channel; there; back; requests = Queue.create (); words = 0 } :: c.workers

  (* What it was to find is found by others, or here. *)
  let bury c w =
    Channel.close w.channel;
    Queue.iter (fun (states, _) -> List.iter (Hashtbl.remove c.states) states) w.requests;
    c.workers <- List.filter (fun other -> other != w) c.workers;
    c.deaths <- c.deaths + 1;
    if c.deaths <= most_deaths then new_worker c;
    told c

  let bytes_under_way w = Queue.fold (fun n (_, bytes) -> n + bytes) 0 w.requests

  (* A process that waits for others finds more by itself, and less when they have nothing to do. *)
  let find_more_here c = c.here <- Int.min most_here (c.here + 1)
  let find_less_here c = c.here <- Int.max 0 (c.here - 1)

  (* States for a request, the first ones of those that wait and have not been sent. *)
  let next_states c =
    let chosen = ref [] and count = ref 0 in
    let choose i =
      if i land (stretch - 1) < c.here || Hashtbl.mem c.states i then false
      else begin
        chosen := i :: !chosen;
        incr count;
        !count >= c.batch
      end
    in
    ignore (c.waiting choose);
    List.rev !chosen

  (* As many of them as are let through; a large state goes alone. *)
  let request c w states =
    let b = Buffer.create 4096 in
    let rec fill sent = function
      | i :: rest when Buffer.length b < most_bytes / 4 ->
        Wire.put_tuple w.there b (Graph.tuple c.graph i);
        fill (i :: sent) rest
      | _ -> List.rev sent
    in
    let sent = fill [] states in
    let whole = Buffer.create (Buffer.length b + 4) in
    Packed.put_nat whole (List.length sent);
    Buffer.add_buffer whole b;
    List.iter (fun i -> Hashtbl.replace c.states i Under_way) sent;
    Queue.push (sent, Buffer.length whole) w.requests;
    match Channel.put w.channel whole with () -> () | exception Channel.Closed -> bury c w

  (* Two requests each, so that nobody waits for the next one. *)
  let has_room w =
    Queue.is_empty w.requests || (Queue.length w.requests < 2 && bytes_under_way w <= most_bytes / 2)

  (* What is found is of no use before its turn: nobody runs far ahead of the process that has the graph. *)
  let is_far_ahead c = Hashtbl.length c.states > 3 * c.batch * List.length c.workers

  let rec send c =
    match List.filter has_room c.workers with
    | [] -> ()
    | _ :: _ when is_far_ahead c -> ()
    | free -> (
        let busy w = Queue.length w.requests in
        let w = List.hd (List.stable_sort (fun a b -> Int.compare (busy a) (busy b)) free) in
        if Queue.is_empty w.requests then find_less_here c;
        match next_states c with
        | [] -> ()
        | states ->
          request c w states;
          send c)

  let receive c w =
    match Channel.get w.channel with
    | exception Channel.Closed -> bury c w
    | message ->
      let source = Packed.source message in
      let states, _ = Queue.pop w.requests in
      List.iter (fun i -> Hashtbl.replace c.states i (Found (read_answer w.back source))) states;
      let seconds = 1e-6 *. float_of_int (Packed.nat source) in
      w.words <- Packed.nat source;
      told c;
      let each = Float.max 1e-7 (seconds /. float_of_int (List.length states)) in
      c.batch <- Int.max 1 (Int.min most_states (int_of_float (batch_seconds /. each)))

  let exchange c channels =
    Critical.run (fun () ->
        List.iter (fun w -> if List.memq w.channel channels then receive c w) c.workers;
        send c)

  let all_channels c = List.map (fun w -> w.channel) c.workers

  let take c i answer =
    Hashtbl.remove c.states i;
    match answer with
    | Look -> None
    | Steps { some; all } -> Some (Graph.all_or_some c.graph ~some ~all:(fun () -> Ok all))

  (* None: it is to be found here. *)
  let rec found c i =
    match Hashtbl.find_opt c.states i with
    | None -> None
    | Some (Found answer) -> take c i answer
    | Some Under_way ->
      find_more_here c;
      exchange c (Channel.ready (all_channels c));
      found c i

  let steps result = Result.map (fun steps -> Graph.All steps) result

  (* After so many states one looks whether something has come, and whether somebody has nothing to do. *)
  let between_looks c = Int.max 1 (c.batch / 4)

  let begun g jobs waiting =
    let c = { graph = g; waiting; states = Hashtbl.create 1024; workers = []; deaths = 0; batch = 8; here = 0 } in
    for _ = 1 to jobs - 1 do
      new_worker c
    done;
    c

  (* Whether it pays is asked once the first states have been found here. *)
  let expanding ~jobs ~start : Graph.expanding =
    fun g ~all_edges ~waiting ->
    if jobs < 2 then Graph.here g ~all_edges ~waiting
    else begin
      let crew = ref None and turns = ref 0 in
      let first = Unix.gettimeofday () and spent = ref 0. and here = ref 0 in
      let find_here tuple =
        let before = Unix.gettimeofday () in
        let result = steps (Graph.successors g tuple) in
        spent := !spent +. (Unix.gettimeofday () -. before);
        incr here;
        result
      in
      let pays () =
        match start with
        | At_once -> true
        | When_it_pays ->
          Unix.gettimeofday () -. first > grace && !spent > worth *. float_of_int !here
      in
      let call_in () =
        if Option.is_none !crew && pays () then
          Critical.run (fun () -> crew := Some (begun g jobs waiting))
      in
      let expand i tuple =
        incr turns;
        call_in ();
        match !crew with
        | None -> find_here tuple
        | Some c -> (
            if !turns mod between_looks c = 0 then
              exchange c (List.filter Channel.has_message (all_channels c));
            match found c i with
            | Some result -> steps result
            | None ->
              let result = steps (Graph.successors g tuple) in
              exchange c [];
              result)
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
