open Scc_data
open Scc_exact

type ends = No_more | End of { flight : Flights.flight; sweep : int; rest : ends }

type 'body event =
  | Contact of { time : Rat.t; one : Flights.flight; two : Flights.flight; sweep_one : int; sweep_two : int }
  | Sweep_ends of { time : Rat.t; mutable ends : ends }
  | Horizon of { time : Rat.t; body : 'body; age : int }
  | Split_instant of { time : Rat.t; body : 'body; age : int }

type 'body t = {
  age : 'body -> int;
  events : 'body event Heap.t;
  mutable last_end : 'body event option;  (** the ends of sweeps that have been added to last *)
  mutable room : int;  (** how many events to keep before those out of date are dropped *)
}

let time = function
  | Contact { time; _ } | Sweep_ends { time; _ } | Horizon { time; _ } | Split_instant { time; _ } -> time

let by_time d e = Rat.compare (time d) (time e)
let least_room = 1024

let create ~age =
  let events = Heap.create ~near:(fun e -> Rat.to_float (time e)) ~compare:by_time in
  { age; events; last_end = None; room = least_room }

(* Those that are over come no more. *)
let rec still = function
  | End { flight; sweep; rest } when flight.sweep <> sweep -> still rest
  | (End _ | No_more) as ends -> ends

let are_there = function End _ -> true | No_more -> false

let is_valid t = function
  | Contact c -> c.one.sweep = c.sweep_one && c.two.sweep = c.sweep_two
  | Sweep_ends s ->
    s.ends <- still s.ends;
    are_there s.ends
  | Horizon { body; age; _ } | Split_instant { body; age; _ } -> t.age body = age

let add t event =
  if Heap.size t.events >= t.room then begin
    Heap.keep t.events (is_valid t);
    t.room <- Int.max least_room (2 * Heap.size t.events)
  end;
  Heap.add t.events event

(* An event without ends may have left the agenda. *)
let add_end t time (flight : Flights.flight) =
  let is_first rest = End { flight; sweep = flight.sweep; rest } in
  match t.last_end with
  | Some (Sweep_ends s) when s.time == time && are_there s.ends -> s.ends <- is_first s.ends
  | Some _ | None ->
    let event = Sweep_ends { time; ends = is_first No_more } in
    t.last_end <- Some event;
    add t event

let watch t : Flights.watch =
  {
    contact =
      (fun time one two ->
         add t (Contact { time; one; two; sweep_one = one.sweep; sweep_two = two.sweep }));
    sweep_end = add_end t;
  }

(* What ends at this time again is a new event. *)
let ended t ends =
  t.last_end <- None;
  let rec all flights ends =
    match still ends with
    | No_more -> flights
    | End { flight; rest; _ } -> all (flight :: flights) rest
  in
  all [] ends

let drop_first t = Heap.drop_first t.events

let rec first t =
  match Heap.first t.events with
  | Some event when not (is_valid t event) ->
    drop_first t;
    first t
  | found -> found
