open Scc_ctl

(* {1 States that are expanded} *)

type states = {
  follows : Buffer.t;
  counts : Buffer.t;
  ahead : Buffer.t;
  mutable notes : Told.note list;
}

let states () =
  let b () = Buffer.create 4096 in
  { follows = b (); counts = b (); ahead = b (); notes = [] }

let clear c =
  List.iter Buffer.clear [ c.follows; c.counts; c.ahead ];
  c.notes <- []

let is_no_state = 5

let follows : _ Filter.following -> int = function
  | Moves _ -> 0
  | Rests -> 1
  | Ends _ -> 2
  | Stops -> 3
  | Fault _ -> 4

let ahead : Filter.ahead option -> int = function
  | None -> 0
  | Some { met; doubt } -> (if Option.is_some met then 1 else 0) lor if Option.is_some doubt then 2 else 0

let put_state c index ((bare : Filter.bare), look_ahead) =
  Buffer.add_uint8 c.follows (follows bare);
  Array.iter (fun a -> Buffer.add_uint8 c.ahead (ahead a)) look_ahead;
  let steps = match bare with Moves steps -> steps | Rests | Ends _ | Stops | Fault _ -> [] in
  Frame.put_number c.counts (List.length steps);
  let looked = if Array.for_all (fun a -> ahead a = 0) look_ahead then None else Some look_ahead in
  let why = Told.reason bare in
  if Option.is_some looked || Option.is_some why then
    c.notes <- { index; looked; why; error = None } :: c.notes;
  steps

let put_no_state filter c index d =
  Buffer.add_uint8 c.follows is_no_state;
  Frame.put_number c.counts 0;
  Array.iter (fun _ -> Buffer.add_uint8 c.ahead 0) (Filter.question filter).goals;
  c.notes <- { index; looked = None; why = None; error = Some d } :: c.notes

let read filter c frame ~from lengths work =
  if Array.fold_left ( + ) from lengths <> String.length frame then
    Frame.lost "its states are not as long as it says";
  let from = ref from in
  let state index length =
    let stop = !from + length in
    (match Filter.read filter frame ~from:!from ~stop with
     | Error d -> put_no_state filter c index d
     | Ok source -> (
         match Filter.look filter source with
         | Ok found -> work index source (put_state c index found)
         | Error d -> put_no_state filter c index d));
    from := stop
  in
  Array.iteri state lengths

(* {1 Targets} *)

type targets = {
  flags : Buffer.t;
  goals : Buffer.t;
  lengths : Buffer.t;
  bytes : Buffer.t;
  mutable doubts : (int * Truth.t array) list;
}

let targets () =
  let b () = Buffer.create 4096 in
  { flags = b (); goals = b (); lengths = b (); bytes = b (); doubts = [] }

let clear_targets c =
  List.iter Buffer.clear [ c.flags; c.goals; c.lengths; c.bytes ];
  c.doubts <- []

let truth : Truth.t -> int = function False -> 0 | True -> 1 | Undecided _ -> 2
let undecided : Truth.t -> bool = function Undecided _ -> true | True | False -> false

let put_target filter c index tuple print =
  let r = Filter.reach filter tuple print in
  Buffer.add_uint8 c.flags (if r.too_long then 1 else 0);
  Array.iter (fun g -> Buffer.add_uint8 c.goals (truth g)) r.goals;
  let before = Buffer.length c.bytes in
  Keys.put (Filter.keys filter) c.bytes tuple;
  Frame.put_number c.lengths (Buffer.length c.bytes - before);
  if Array.exists undecided r.goals then c.doubts <- (index, r.goals) :: c.doubts
