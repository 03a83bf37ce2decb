open Scc_base
open Scc_data
open Scc_graph_search

type start = At_once | When_it_pays

(* Others are called in after so many seconds, and while there are so few states: a process that is forked keeps
   what its parent has had, and what the parent writes to comes to be there twice. *)
let grace = 0.5
let few = 1 lsl 19

(* Where this process must have room in the tables, others have so long to stop. *)
let seconds_to_stop = 0.2

(* Requests of a worker that are under way: the next one is there before it has answered one. *)
let most_under_way = 4

(* Of what this process finds ahead. *)
let own_slots = 16

(* Seconds that a state found ahead takes, for this process to wait before it takes another one. *)
let long = 0.005

(* Of so many answers one after the other, a power of two, what they ask for is fetched at once. *)
let fetched_at_once = 16

(* After so many states this process looks whether others have answered. *)
let between_looks = 16

(* And after so many, how much memory is shared. *)
let between_sizes = 1 lsl 12

module Make (L : Lts.S) (Graph : module type of Explore.Make (L)) = struct
  include Team.Make (L) (Graph)

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

  (* With a bound on states there will be so many turns as there is room for what they find. Nobody looks further
     ahead, except that each process has something to do. *)
  let needed c =
    match c.room () with
    | room when room = max_int -> max_int
    | room ->
      let turns = float_of_int (room + 1) /. Float.max 1e-6 c.fresh in
      if turns > 1e9 then max_int else Int.max c.jobs (int_of_float turns)

  (* So many that wait may be asked for. *)
  let waiting c =
    let size = Graph.size c.shared.graph in
    let expanded = size - Graph.left c.shared.graph in
    Int.min (size - c.unasked) (Int.max 0 (needed c - Int.max 0 (c.unasked - expanded)))

  let turns_of_mean = 64.

  let note_turn c i =
    let size = Graph.size c.shared.graph in
    c.fresh <- c.fresh +. ((float_of_int (size - c.size) -. c.fresh) /. turns_of_mean);
    c.size <- size;
    c.now <- i

  (* So many that wait, but for the one whose turn it is. *)
  let take c count =
    let beyond = c.unasked + waiting c in
    let rec from found chosen =
      if found = count || c.unasked = beyond then Array.of_list (List.rev chosen)
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
      wake c w

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

  (* Workers stop where room is wanted, some in the midst of an answer. They are not asked for more until they all
     have. *)
  let works w = w.under_way <> [] && not (Served.is_paused w.bells)
  let somebody_works c () = List.exists works c.workers

  let is_room_wanted c = Graph.is_room_wanted c.shared.graph c.shared.common

  let make_room_now c =
    let go_on w =
      if Served.is_paused w.bells then begin
        Served.end_pause w.bells;
        wake c w
      end
    in
    Critical.run (fun () ->
        Graph.make_room c.shared.graph c.shared.common;
        List.iter go_on c.workers)

  (* Where this process cannot go on without room, who is at a state that takes long is ended, and begins anew.
     What is found ahead is given up instead. *)
  let make_room c =
    let until = Unix.gettimeofday () +. seconds_to_stop in
    let rec wait () =
      if somebody_works c () then
        if Unix.gettimeofday () < until then begin
          wait_while c (somebody_works c);
          wait ()
        end
        else if c.is_ahead then raise Answers.Too_long
        else Critical.run (fun () -> List.iter (end_worker c) (List.filter works c.workers))
    in
    let before = List.length c.workers + c.deaths in
    wait ();
    make_room_now c;
    let ended = before - List.length c.workers - c.deaths in
    Critical.run (fun () -> for _ = 1 to ended do new_worker c done)

  let exchange c =
    Critical.run (fun () ->
        collect c;
        drop_first c);
    if is_room_wanted c && not (somebody_works c ()) then make_room_now c;
    Critical.run (fun () ->
        if List.exists is_full c.workers || c.own_slots = [] then drop_all c;
        if not (is_room_wanted c) then send c)

  (** {2 Answers} *)

  (* What this process has not come to is asked for again. *)
  let take_back c r ~answered =
    if answered < Array.length r.states then begin
      c.unasked <- Int.min c.unasked r.states.(answered);
      r.states <- Array.sub r.states 0 answered
    end;
    r.answered <- answered

  (* Some of what waits is found here; nothing, where there is none or no room for it. *)
  let works_ahead c =
    match c.own_slots with
    | [] -> false
    | _ when is_room_wanted c -> false
    | slot :: rest -> (
        match take c (Balance.request c.balance ~waiting:(waiting c) ~jobs:c.jobs) with
        | [||] -> false
        | states ->
          c.own_slots <- rest;
          Served.request slot states;
          let r = { worker = None; slot; states; answered = 0; next = 0 } in
          Queue.push r c.requests;
          c.is_ahead <- true;
          Fun.protect
            ~finally:(fun () -> c.is_ahead <- false)
            (fun () -> Service.find_for c.shared slot ~seconds:Balance.request_seconds);
          Critical.run (fun () -> take_back c r ~answered:(Served.answered slot));
          Balance.answered c.balance ~states:r.answered ~worked:(Served.seconds slot);
          if Served.seconds slot > long then c.patience <- 0.5 *. Served.seconds slot;
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

  let answer r k =
    match Served.progress r.slot k with
    | Answered at -> Some { Graph.words = r.slot; at }
    | Free | Taken | Untold -> None

  let fetch_from c r k =
    for k = k to Int.min (k + fetched_at_once) r.answered - 1 do
      Option.iter (Graph.fetch c.shared.graph) (answer r k)
    done

  (* Somebody else has begun with the state before this process began with what it found ahead. If that took long,
     the other one is likely to end soon. *)
  let is_patient c r k =
    c.patience > 0.
    && begin
      let start = Unix.gettimeofday () in
      wait ~seconds:c.patience c r k;
      c.patience <- c.patience -. Float.max 1e-6 (Unix.gettimeofday () -. start);
      true
    end

  (* This process waits only for a state that another one has begun with. *)
  let rec ready c i =
    match find c i with
    | None -> None
    | Some (r, k) when r.answered >= 0 ->
      if k >= r.answered then None
      else begin
        if k = r.next then r.next <- k + 1;
        if k land (fetched_at_once - 1) = 0 then fetch_from c r k;
        answer r k
      end
    | Some (r, k) -> (
        let use () = if k = r.next then r.next <- k + 1 in
        match Served.progress r.slot k with
        | Answered _ | Untold ->
          use ();
          answer r k
        | Free when Served.take r.slot k ->
          use ();
          None
        | Free -> ready c i
        | Taken ->
          if not (is_patient c r k || works_ahead c) then wait c r k;
          exchange c;
          ready c i)

  let begun shared balance jobs waits room =
    let own_slots = Option.value (make_slots own_slots) ~default:[] in
    let size = Graph.size shared.Service.graph in
    let rec first_waiting i = if i < size && not (waits i) then first_waiting (i + 1) else i in
    let unasked = first_waiting 0 and requests = Queue.create () in
    let expanded = Int.max 1 (size - Graph.left shared.graph) in
    let c =
      {
        shared; balance; jobs; waits; room; requests; own_slots; unasked; size;
        now = -1;
        patience = 0.;
        is_ahead = false;
        fresh = float_of_int size /. float_of_int expanded;
        workers = [];
        deaths = 0;
      }
    in
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
    fun g ~all_edges ~waits ~room ~dull ->
    if jobs < 2 then Graph.here g ~all_edges ~waits ~room ~dull
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
          let begin_with common =
            crew := Some (begun { graph = g; common; all_edges; dull } balance jobs waits room)
          in
          Critical.run (fun () -> Option.iter begin_with (Graph.share g))
        end
      in
      let ready i =
        match !crew with
        | None -> None
        | Some c ->
          note_turn c i;
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
